"""A report on a drive: how much of it became steps of the task, and why the rest did not."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled

Row = tuple[str, int, str]
MOST_MOTIONS = 9  # so many are written out


@dataclass(frozen=True, repr=False)
class DriveReport(Tabled):
    """How much of a drive became steps of a task. It shows itself as a table.

    task: its name; duration: of the drive [s]
    messages: how many were received, by topic
    faults: how many of them have impossible values, such as NaN, and what is wrong with the last of these, by topic
    steps, stretches: rows of the recording, and the pieces without a gap in which they come
    unexplained: how many Twists were dropped, because no action of the task is like them; rounded, by v and ω
    motions: v and ω of the task's actions, rounded
    to_and_fro: commands that lasted less than a person's touch of a key between two others that were alike
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
    motions: tuple[tuple[float, float], ...]
    to_and_fro: int
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

    def why_empty(self) -> str:
        """Why there is no step, and what to do, in words."""
        counted = [f"{n} {what}" for what, n, _ in self._dropped_rows() if n]
        losses = ", ".join(counted) or "no command lasts for a step"
        return f"{losses}; {self._advice()}"

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
        to_and_fro = "as if two publishers sent commands at once"
        stale = "odometry or scan was too old, or not there yet"
        unknown = "the latest odometry or scan does not say enough"
        jumps = "it tells of too long a way"
        disordered = "a clock was set, or two publishers share a topic"
        partial = "a laser is unknown that others show"
        lost = f"of {self.rays}: 0, NaN, or above range_max"
        rows: list[Row] = [
            ("Twists that no action explains", self.dropped, self._examples()),
            ("steps cut short", self.cut_short, cut),
            ("commands that go to and fro", self.to_and_fro, to_and_fro),
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
        """The three most frequent Twists that no action explains, and the actions' own; empty without any."""
        if not self.unexplained:
            return ""
        by_frequency = sorted(
            self.unexplained, key=lambda twist: (-self.unexplained[twist], twist)
        )
        return (
            f"no action is like {_in_words(by_frequency[:3])}; "
            f"the actions are {_in_words(self.motions)}"
        )

    def _advice(self) -> str:
        """What to do about the greatest loss."""
        if 2 * self.to_and_fro > self.cut_short + self.dropped:
            return (
                "two publishers seem to send commands at once: record again while only one of them does, and hold "
                "each command for whole steps"
            )
        advice = {
            f"{self._examples()}: choose a task with such motions, or a larger tolerance": self.dropped,
            "record again, and hold each command for whole steps": self.cut_short,
            "record odometry, scan and commands at the same time": self.stale,
            "say how the scanner is mounted and what it gives for far": self.unknown,
            "is this the robot's own odometry, and the task's robot the one that drove?": self.jumps,
            "record again without setting a clock, with one publisher for each topic": self.disordered,
        }
        most = max(advice.values())
        if most == 0:
            return "record for longer than the task's step"
        return next(what for what, loss in advice.items() if loss == most)


def _in_words(motions: Sequence[tuple[float, float]]) -> str:
    """Some motions, as v and ω."""
    words = [f"{v:g} m/s and {omega:g} rad/s" for v, omega in motions[:MOST_MOTIONS]]
    more = len(motions) - MOST_MOTIONS
    if more > 0:
        words.append(f"and {more} others")
    return ", ".join(words)
