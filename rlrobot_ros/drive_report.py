"""A report on a drive: how much of it became steps of the task, and why the rest did not."""

from collections.abc import Mapping
from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled

Row = tuple[str, int, str]


@dataclass(frozen=True, repr=False)
class DriveReport(Tabled):
    """How much of a drive became steps of a task. It shows itself as a table.

    task: its name; duration: of the drive [s]
    messages: how many were received, by topic
    faults: how many of them have impossible values, such as NaN, and what is wrong with the last of these, by topic
    steps, stretches: rows of the recording, and the pieces without a gap in which they come
    unexplained: how many Twists were dropped, because no action of the task is like them; rounded, by v and ω
    cut_short: steps dropped because another command came within them, or because the commands ended
    stale: steps dropped because odometry or scan was too old at their beginning or end
    unknown: steps dropped because the latest odometry or scan at their beginning or end does not say enough
    jumps: steps dropped because odometry moved too far in them
    disordered: steps dropped because messages were not received in the order in which they were sent, or because the
        clocks of sender and recorder disagree about their time
    rays, lost: the rays of all scans, and how many of them measured nothing
    partial: scans in which a laser is unknown that counts
    missing: lasers that do not count, because the scanner cannot replace them or they are unknown in most scans
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
    disordered: int
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
        """How many messages have impossible values."""
        return sum(n for n, _ in self.faults.values())

    def in_short(self) -> str:
        """The counts of what was dropped, in words."""
        return ", ".join(f"{n} {what}" for what, n, _ in self._dropped_rows())

    def table(self) -> Table:
        """One line for each thing that was counted."""
        rows: list[Row] = []
        for topic, n in self.messages.items():
            rows.append((f"messages of {topic}", n, ""))
        stretches = f"stretches without a gap: {self.stretches}"
        rows.append(("steps", self.steps, stretches))
        rows += self._dropped_rows()
        title = f"A drive of {self.duration:.4g} s as steps of {self.task}"
        return Table(title, ("of the drive", "how many", "what they are"), rows)

    def _dropped_rows(self) -> list[Row]:
        cut = "another command came within the step, or none any more"
        stale = "odometry or scan was too old, or not there yet"
        unknown = "the latest odometry or scan does not say enough"
        jumps = "it tells of too long a way"
        disordered = "a clock was set, or two publishers share a topic"
        partial = "a laser is unknown that others show"
        lost = f"of {self.rays}: 0, NaN, or above range_max"
        rows: list[Row] = [
            ("Twists that no action explains", self.dropped, self._examples()),
            ("steps cut short", self.cut_short, cut),
            ("steps with old readings", self.stale, stale),
            ("steps with unknown readings", self.unknown, unknown),
            ("steps in which odometry jumped", self.jumps, jumps),
            ("steps whose times contradict", self.disordered, disordered),
        ]
        for topic, (n, fault) in self.faults.items():
            rows.append((f"unreadable messages of {topic}", n, fault))
        missing = ", ".join(self.missing)
        rows.append(("lasers not in view, or unknown", len(self.missing), missing))
        rows.append(("scans that do not show all", self.partial, partial))
        rows.append(("rays that measured nothing", self.lost, lost))
        return rows

    def _examples(self) -> str:
        """The three most frequent Twists that no action explains, in words; empty without any."""
        if not self.unexplained:
            return ""
        by_frequency = sorted(
            self.unexplained, key=lambda twist: (-self.unexplained[twist], twist)
        )
        examples = [f"{v:g} m/s and {omega:g} rad/s" for v, omega in by_frequency[:3]]
        return f"no action is like {', '.join(examples)}"
