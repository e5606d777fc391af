"""What has become of a drive: how much of it are steps of the task, and why the rest is not."""

from collections.abc import Mapping
from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled


@dataclass(frozen=True, repr=False)
class DriveReport(Tabled):
    """What of a drive has become steps of a task. It shows itself as a table.

    task: its name; duration: of the drive [s]
    messages: how many were received, by topic
    faults: how many of them say what cannot be, such as NaN, and what is wrong with the last of these, by topic
    steps, stretches: rows of the recording, and the pieces without a gap in which they come
    unexplained: how many Twists were dropped, since no action of the task is like them; rounded, by v and ω
    cut_short: steps dropped, since another command came within them, or none any more
    stale: steps dropped, since odometry or scan was too old at their beginning or end
    unknown: steps dropped, since the latest odometry or scan at their beginning or end does not say enough
    jumps: steps dropped, since odometry tells of too long a way in them
    rays, lost: of all scans, and how many of them measured nothing
    partial: scans in which a laser is unknown that counts
    missing: lasers that do not count: the scanner cannot stand for them, or they are unknown in most scans
    """

    task: str
    duration: float
    messages: Mapping[str, int]
    faults: Mapping[str, tuple[int, str]]
    steps: int
    stretches: int
    unexplained: Mapping[tuple[float, float], int]
    cut_short: int
    stale: int
    unknown: int
    jumps: int
    rays: int
    lost: int
    partial: int
    missing: tuple[str, ...]

    @property
    def dropped(self) -> int:
        """How many Twists no action of the task explains."""
        return sum(self.unexplained.values())

    @property
    def unreadable(self) -> int:
        """How many messages say what cannot be."""
        return sum(n for n, _ in self.faults.values())

    def in_short(self) -> str:
        """The counts of what was dropped, in words."""
        return ", ".join(
            f"{n} {what}" for what, n, _ in self.table().rows[len(self.messages) + 1 :]
        )

    def table(self) -> Table:
        """One line for each thing that was counted."""
        commonest = sorted(
            self.unexplained, key=lambda twist: (-self.unexplained[twist], twist)
        )[:3]
        examples = ", ".join(f"{v:g} m/s and {omega:g} rad/s" for v, omega in commonest)
        rows = [
            *((f"messages of {topic}", n, "") for topic, n in self.messages.items()),
            ("steps", self.steps, f"stretches without a gap: {self.stretches}"),
            (
                "Twists that no action explains",
                self.dropped,
                f"no action is like {examples}" if examples else "",
            ),
            (
                "steps cut short",
                self.cut_short,
                "another command came within the step, or none any more",
            ),
            (
                "steps with old readings",
                self.stale,
                "odometry or scan was too old, or not there yet",
            ),
            (
                "steps with unknown readings",
                self.unknown,
                "the latest odometry or scan does not say enough",
            ),
            (
                "steps in which odometry jumped",
                self.jumps,
                "it tells of too long a way",
            ),
            *(
                (f"unreadable messages of {topic}", n, fault)
                for topic, (n, fault) in self.faults.items()
            ),
            (
                "lasers not in view, or unknown",
                len(self.missing),
                ", ".join(self.missing),
            ),
            (
                "scans that do not show all",
                self.partial,
                "a laser is unknown that others show",
            ),
            (
                "rays that measured nothing",
                self.lost,
                f"of {self.rays}: 0, NaN, or above range_max",
            ),
        ]
        columns = ("of the drive", "how many", "what they are")
        return Table(
            f"A drive of {self.duration:.4g} s as steps of {self.task}", columns, rows
        )
