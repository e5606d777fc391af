"""What has become of a drive: how much of it are steps of the task, and why the rest is not."""

from collections.abc import Mapping
from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled

Velocity = tuple[float, float]  # v [m/s], ω [rad/s]


@dataclass(frozen=True, repr=False)
class DriveReport(Tabled):
    """What of a drive has become steps of a task. It shows itself as a table.

    task: its name; duration: of the drive [s]
    messages: how many were received, by topic; unreadable: how many of them hold what cannot be, such as NaN
    steps, stretches: rows of the recording, and the pieces without a gap in which they come
    unexplained: how many Twists were dropped, since no action of the task is like them; rounded, by v and ω
    cut_short: steps dropped, since another command came within them, or none any more
    stale: steps dropped, since odometry or scan was too old at their beginning or end
    silences: how often cmd_vel fell silent, so that no command was in force
    missing: lasers that the scanner cannot stand for
    """

    task: str
    duration: float
    messages: Mapping[str, int]
    steps: int
    stretches: int
    unexplained: Mapping[Velocity, int]
    cut_short: int
    stale: int
    silences: int
    unreadable: int
    missing: tuple[str, ...]

    @property
    def dropped(self) -> int:
        """How many Twists no action of the task explains."""
        return sum(self.unexplained.values())

    def in_short(self) -> str:
        """The counts of what was dropped, in words."""
        return (
            f"{self.dropped} Twists that no action explains, {self.cut_short} steps cut short, {self.stale} with "
            f"readings too old, {self.silences} silences of cmd_vel"
        )

    def table(self) -> Table:
        """One line for each thing that was counted."""
        commonest = sorted(self.unexplained, key=lambda twist: (-self.unexplained[twist], twist))[:3]
        examples = ", ".join(f"{v:g} m/s and {omega:g} rad/s" for v, omega in commonest)
        rows = [
            *((f"messages of {topic}", n, "") for topic, n in self.messages.items()),
            ("messages that are unreadable", self.unreadable, "they say what cannot be" if self.unreadable else ""),
            ("steps", self.steps, f"stretches without a gap: {self.stretches}"),
            ("dropped Twists", self.dropped, f"no action is like {examples}" if examples else ""),
            ("dropped steps, cut short", self.cut_short, "another command came within the step, or none any more"),
            ("dropped steps, stale", self.stale, "odometry or scan was too old, or not there yet"),
            ("silences of cmd_vel", self.silences, ""),
        ]
        if self.missing:
            rows.append(("lasers not in view", len(self.missing), ", ".join(self.missing)))
        caption = f"A drive of {self.duration:.4g} s as steps of {self.task}"
        return Table(caption, ("of the drive", "how many", "what they are"), rows)
