"""What a grading is given and what comes of it: limits, rules, and for a notebook the scores of its exercises."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.guard import NO_GUARD, Guard
from rlrobot_grading.marking.students import NOBODY, Student
from rlrobot_grading.marking.text import text_of

HINTS = "hints_asked_for"  # why a right answer has not all points
WAITS = "…"  # what a verdict begins with that waits for an answer
LONGEST = 1e6  # time for one notebook, eleven days [s]
LARGEST = 2**24  # memory for one notebook, sixteen terabytes [MiB]


@dataclass(frozen=True)
class Limits:
    """What a submission may use: seconds in all, a third of them in one cell or one call; memory [MiB]; its guard."""

    seconds: float = 300.0
    memory: int = 4096
    guard: Guard = NO_GUARD

    def check(self) -> None:
        """Raise ValueError if these are no limits; NaN is none."""
        if not 0 < self.seconds <= LONGEST:
            raise ValueError(
                f"--seconds {self.seconds}: it must be above 0, and {LONGEST:.0f} at most"
            )
        if not 256 <= self.memory <= LARGEST:
            raise ValueError(
                f"--memory {self.memory}: it must be at least 256 [MiB], and {LARGEST} at most"
            )


@dataclass(frozen=True)
class Score:
    """What an exercise has got.

    output: why, for the learner; is_answered: whether there was anything to judge
    mistake, hint: the id of the mistake that was recognised, and its hint; empty where there is none
    substituted: the functions in whose place the right ones were called, as "period"
    """

    exercise: str
    score: float
    output: str
    max_score: float = 1.0
    is_answered: bool = False
    mistake: str = ""
    hint: str = ""
    substituted: str = ""

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
        if self.hint:
            return self.hint
        said = " ".join(self.output.removeprefix("✗").split())
        sentence = re.match(r".+?[.!?](?=\s|$)", said)
        if sentence and self.is_answered:
            said = sentence[0]
        return one_line(said) or self.mistake.replace("_", " ")


@dataclass
class Marked:
    """A submission with its scores.

    notes: what the teacher should know; student: whose it is; off: points taken off because it came late
    made_for: the id of the student whose variant it is, if each has their own
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


@dataclass(frozen=True)
class Rules:
    """By default each exercise counts 1 point, for an answer that is right in every case.

    points: of exercises, by their names; partial: whether an answer that is right in some cases gets part of its points
    hint_off: part of an exercise's points that each of its hints costs
    late_off: part of all points that each day costs after `late_free` days, `late_most` at most
    """

    points: Mapping[str, float] = field(default_factory=dict)
    partial: bool = False
    hint_off: float = 0.0
    late_off: float = 0.0
    late_free: float = 0.0
    late_most: float = 1.0

    def points_of(self, exercise: str) -> float:
        """Points of an exercise."""
        return self.points.get(exercise, 1.0)

    def off(self, days: float, points: float) -> float:
        """Points that come off so many points after so many days."""
        late = max(0.0, days - self.late_free)
        return round(points * min(self.late_most, self.late_off * late), 2)


NO_RULES = Rules()
SHARES = ("hint_off", "late_off", "late_most")  # of points


def read_rules(path: str) -> Rules:
    """The rules of a TOML file. Raises OSError, or ValueError if it says anything else than rules."""
    try:
        rules = tomllib.loads(text_of(path))
    except ValueError as error:
        raise ValueError(f"{path} is no TOML file: {error}") from None
    known = [rule.name for rule in fields(Rules)]
    for name, value in rules.items():
        if name == "points":
            fits = isinstance(value, dict) and all(map(_is_amount, value.values()))
        elif name == "partial":
            fits = isinstance(value, bool)
        else:
            fits = _is_amount(value)
        if name not in known or not fits:
            raise ValueError(
                f"{path}: {name} = {value!r} is no rule; there are {', '.join(known)}, not below 0"
            )
        if name in SHARES and value > 1:
            raise ValueError(
                f"{path}: {name} = {value!r} is more than all; write 0.1 for 10 %"
            )
    return Rules(**rules)


def _is_amount(value: Any) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and 0 <= value < 1e9
