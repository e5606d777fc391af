"""What was heard from a robot and said to it, in a table."""

from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled


@dataclass(frozen=True, repr=False)
class LinkReport(Tabled):
    """What came and went over a link since it was opened. It shows itself as a table.

    way: over which link; is_dry: whether nothing was really said
    odometry, scans: messages heard; not_new: how many of them came twice or after a newer one
    unreadable: messages that say what cannot be, or too little; complaint: what is wrong with the last of them
    said: commands, 10 a second; held_back: how many of them without their forward motion, since something was near
    pauses: how often the robot was stopped, since too little was known of it; why: the reason of the last time
    """

    way: str
    is_dry: bool
    odometry: int
    scans: int
    not_new: int
    unreadable: int
    complaint: str
    said: int
    held_back: int
    pauses: int
    why: str

    def table(self) -> Table:
        """One line for each thing that was counted."""
        rows = [
            ("odometry heard", self.odometry, ""),
            ("scans heard", self.scans, ""),
            (
                "messages that were not new",
                self.not_new,
                "they came twice, or after a newer one",
            ),
            ("messages that are unreadable", self.unreadable, self.complaint),
            (
                "commands",
                self.said,
                "none was sent, this is a dry run" if self.is_dry else "",
            ),
            (
                "commands held back",
                self.held_back,
                "something was nearer ahead than the safety distance",
            ),
            ("pauses", self.pauses, self.why),
        ]
        return Table(
            f"The link to the robot over {self.way}",
            ("what", "how many", "what they are"),
            rows,
        )
