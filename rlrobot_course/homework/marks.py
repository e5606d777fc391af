"""What a grading is given and what comes of it: limits, and for a notebook the scores of its exercises."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from rlrobot_course.grading.values import one_line
from rlrobot_course.homework.guard import OPEN_HOUSE, Guard
from rlrobot_course.homework.students import NOBODY, Student

HINTS = "hints_asked_for"  # why a right answer has not all points
WAITS = "…"  # what a verdict begins with that waits for an answer
LONGEST = 1e6  # time for one notebook, eleven days [s]
LARGEST = 2**24  # memory for one notebook, sixteen terabytes [MiB]


@dataclass(frozen=True)
class Limits:
    """What a submission may use: seconds in all, a third of them in one cell or one call; memory [MiB]; its guard."""

    seconds: float = 300.0
    memory: int = 4096
    guard: Guard = OPEN_HOUSE

    def check(self) -> None:
        """Raise ValueError if these are no limits; NaN is none."""
        if not 0 < self.seconds <= LONGEST:
            raise ValueError(f"--seconds {self.seconds}: it must be above 0, and {LONGEST:.0f} at most")
        if not 256 <= self.memory <= LARGEST:
            raise ValueError(f"--memory {self.memory}: it must be at least 256 [MiB], and {LARGEST} at most")


@dataclass(frozen=True)
class Score:
    """What an exercise has got.

    output: why, for the learner; is_answered: whether there was anything to judge
    mistake, hint: the id of the mistake that was recognised, and its hint; empty where there is none
    lent: which other functions the right ones stood in for, as "period"
    """

    exercise: str
    score: float
    output: str
    max_score: float = 1.0
    is_answered: bool = False
    mistake: str = ""
    hint: str = ""
    lent: str = ""

    @property
    def is_right(self) -> bool:
        """Whether it is right, even if its hints have cost points."""
        return self.score == self.max_score or self.mistake == HINTS

    @property
    def is_blank(self) -> bool:
        """Whether its check still waits for an answer."""
        return not self.is_answered and self.output.startswith(WAITS)

    @property
    def reason(self) -> str:
        """Why points are missing, in a sentence for the student; empty if none are."""
        if self.score == self.max_score:
            return ""
        if self.mistake == HINTS:
            return "hints asked for"
        if self.is_blank:
            return "not answered yet"
        told = " ".join(self.output.removeprefix("✗").split())
        sentence = re.match(r".+?[.!?](?=\s|$)", told) if self.is_answered else None
        return self.hint or one_line(sentence[0] if sentence else told) or self.mistake.replace("_", " ")


@dataclass
class Marked:
    """A submission with its scores.

    notes: what the instructor should know; student: whose it is; off: points taken off because it came late
    made_for: the number of the student whose variant it is, if each has their own
    problem: why it was not graded, if it was not; its points are none then, not 0
    """

    name: str
    lesson: str
    scores: list[Score]
    notes: list[str] = field(default_factory=list)
    student: Student = NOBODY
    off: float = 0.0
    made_for: str = ""
    problem: str = ""

    @property
    def score(self) -> float:
        """Points in all."""
        return sum(score.score for score in self.scores) - self.off

    @property
    def max_score(self) -> float:
        """Points that there are."""
        return sum(score.max_score for score in self.scores)

    @property
    def is_full(self) -> bool:
        """Whether it has all points."""
        return not self.problem and self.score == self.max_score
