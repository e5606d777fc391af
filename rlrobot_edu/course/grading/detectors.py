"""How a hint is found: a list of detectors, tried in this order. The first that returns a hint decides.

Each takes the `Evidence` on one wrong answer and returns a `Hint` or None. An answer that stops with an exception has
values for none of them to look at: `errors` tells what that exception means.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from rlrobot_edu.course.grading.replay import Outcome
from rlrobot_edu.course.grading.source import uses_chance
from rlrobot_edu.course.grading.suspicions import about_the_cases, about_the_code, about_the_memory, about_the_values
from rlrobot_edu.course.grading.values import safely

if TYPE_CHECKING:
    from rlrobot_edu.course.grading.exercise import Exercise

AGAIN = 40  # times that a function is asked the same, to see whether there is chance in it
CHANCE = "called twice with the same arguments, your function answers differently. Is there chance in it?"


class Hint(NamedTuple):
    """What is told about a wrong answer; id: of the mistake, or the name of the detector that has found it."""

    id: str
    text: str


@dataclass(frozen=True)
class Evidence:
    """One wrong answer, and what it has done in each case that was tried."""

    exercise: Exercise
    answer: Callable[..., Any]
    got: Sequence[Outcome]

    def shows(self, function: Callable[..., Any]) -> bool:
        """Whether the answer does in every case what `function` does. One case in which it fails is excused."""
        failed = [i for i, mine in enumerate(self.got) if mine.failure]
        return all(self.exercise.mistaken(function, i).equals(mine) for i, mine in enumerate(self.got) if [i] != failed)


def chance(seen: Evidence) -> Hint | None:
    """It answers differently when it is asked again. This comes first: chance may look like any mistake."""
    exercise, pairs = seen.exercise, zip(seen.got, seen.exercise.expected, strict=False)
    first = next(i for i, (mine, right) in enumerate(pairs) if not right.equals(mine))
    before = seen.got[first]
    if not safely(False, uses_chance, seen.answer) or before.failure or not before.equals(before):
        return None  # some values equal nothing, not even themselves
    again = (exercise.outcome(seen.answer, exercise.cases[first]) for _ in range(AGAIN))
    if all(outcome.failure or outcome.equals(before) for outcome in again):
        return None
    return code(seen) or Hint("chance", CHANCE)


def known_mistake(seen: Evidence) -> Hint | None:
    """It computes what one of the exercise's mistakes computes, in every case."""
    exercise = seen.exercise
    pairs = zip(exercise.mistakes, exercise.wrong_functions, strict=True)
    return next((Hint(mistake.id, mistake.hint) for mistake, wrong in pairs if seen.shows(wrong)), None)


def values(seen: Evidence) -> Hint | None:
    """Its values stand in one relation to the right ones in every case: rounded, of the other sign, too large by 3."""
    exercise = seen.exercise
    told = about_the_values(seen.answer, exercise.cases, exercise.expected, seen.got, exercise.returns)
    return Hint("values", told) if told else None


def two_mistakes(seen: Evidence) -> Hint | None:
    """It makes two of the mistakes at once."""
    for one, other, both in seen.exercise.pairs:
        if seen.shows(both):
            told = f"two things at once. First, {one.hint} Second, {other.hint}"
            return Hint(f"{one.id}+{other.id}", told)
    return None


def memory(seen: Evidence) -> Hint | None:
    """It changes more of a table than it should, or always by so many times too much."""
    exercise = seen.exercise
    told = about_the_memory(exercise.cases, exercise.expected, seen.got, exercise.tables)
    return Hint("memory", told) if told else None


def code(seen: Evidence) -> Hint | None:
    """It never reads an argument, or takes one from the notebook."""
    told = about_the_code(seen.answer, seen.exercise.right)
    return Hint("code", told) if told else None


def cases(seen: Evidence) -> Hint | None:
    """It is wrong in just those cases in which an argument is True, or negative, or empty."""
    told = about_the_cases(seen.exercise.cases, seen.exercise.expected, seen.got)
    return Hint("cases", told) if told else None


DETECTORS: tuple[Callable[[Evidence], Hint | None], ...] = (
    chance,
    known_mistake,
    values,
    two_mistakes,
    memory,
    code,
    cases,
)


def find_hint(seen: Evidence) -> Hint:
    """The hint of the first detector that has one; an empty hint where none has."""
    found = (detector(seen) for detector in DETECTORS)
    return next((hint for hint in found if hint), Hint("", ""))
