"""A table of what was received from a robot and sent to it."""

from dataclasses import dataclass

from rlrobot_edu.experiments.tables import Table, Tabled


@dataclass(frozen=True, repr=False)
class LinkReport(Tabled):
    """The messages received and sent over a link since it was opened. It shows itself as a table.

    address: of rosbridge; is_dry: whether nothing was really sent
    odometry, scans: messages received; not_new: how many of them came twice or after a newer one
    unreadable: messages that are impossible or incomplete; complaint: what is wrong with the last of them
    commands: 10 a second; held_back: how many of them without their forward motion, because something was near
    pauses: how often the robot was stopped, because too little was known of it; why: the reason of the last pause
    """

    address: str
    is_dry: bool
    odometry: int
    scans: int
    not_new: int
    unreadable: int
    complaint: str
    commands: int
    held_back: int
    pauses: int
    why: str

    def table(self) -> Table:
        """One line for each thing that was counted."""
        dry = "none was sent, this is a dry run" if self.is_dry else ""
        near = "something was nearer ahead than the safety distance"
        rows = [
            ("odometry received", self.odometry, ""),
            ("scans received", self.scans, ""),
            ("messages not new", self.not_new, "they came twice, or after a newer one"),
            ("unreadable messages", self.unreadable, self.complaint),
            ("commands", self.commands, dry),
            ("commands held back", self.held_back, near),
            ("pauses", self.pauses, self.why),
        ]
        title = f"The link to the robot at {self.address}"
        return Table(title, ("what", "how many", "what they are"), rows)
