"""How a hint is found: detectors are tried in the order of `DETECTORS`. The first that has a hint decides.

Each takes the `Evidence` on one wrong answer. It returns a `Hint`, or only its text, which then has the detector's name
as id; nothing where it has none. An answer that stops with an exception leaves them no values to look at: `errors`
tells what that exception means.
"""

from __future__ import annotations

from collections.abc import Callable

from rlrobot_grading.answers.source import uses_chance
from rlrobot_grading.answers.values import safely
from rlrobot_grading.hints.as_if import one_change
from rlrobot_grading.hints.events import order_of_events
from rlrobot_grading.hints.evidence import Evidence, Hint
from rlrobot_grading.hints.suspicions import (
    about_the_cases,
    about_the_code,
    about_the_memory,
    about_the_values,
    from_the_notebook,
    unlike,
)

AGAIN = (
    40  # times that a function is asked the same, to see whether there is chance in it
)
CHANCE = "called twice with the same arguments, your function answers differently. Is there chance in it?"


def chance(seen: Evidence) -> Hint | None:
    """It answers differently when it is asked again. This comes first: chance may look like any mistake."""
    exercise, first = seen.exercise, seen.wrong[0]
    before = seen.got[first]
    if (
        not safely(False, uses_chance, seen.answer)
        or before.failure
        or not before.equals(before)
    ):
        return None  # some values equal nothing, not even themselves
    again = (exercise.outcome(seen.answer, exercise.cases[first]) for _ in range(AGAIN))
    if all(outcome.failure or outcome.equals(before) for outcome in again):
        return None
    if in_the_code := from_the_notebook(seen) or about_the_code(seen):
        return (
            in_the_code if isinstance(in_the_code, Hint) else Hint("code", in_the_code)
        )
    right, mine = (
        outcome.values.get(exercise.returns)
        for outcome in (exercise.expected[first], before)
    )
    shape = safely("", unlike, right, mine)
    return Hint("chance", f"{CHANCE} {shape[:1].upper()}{shape[1:]}".strip())


def known_mistake(seen: Evidence) -> Hint | None:
    """It computes what one of the exercise's mistakes computes, in every case."""
    pairs = zip(seen.exercise.mistakes, seen.exercise.wrong_functions, strict=True)
    return next(
        (
            Hint(mistake.id, mistake.hint)
            for mistake, wrong in pairs
            if seen.shows(wrong)
        ),
        None,
    )


def two_mistakes(seen: Evidence) -> Hint | None:
    """It makes two of the mistakes at once."""
    for one, other, both in seen.exercise.pairs:
        if seen.shows(both):
            told = f"two things at once. First, {one.hint} Second, {other.hint}"
            return Hint(f"{one.id}+{other.id}", told)
    return None


DETECTORS: dict[str, Callable[[Evidence], Hint | str | None]] = {
    "chance": chance,
    "known_mistake": known_mistake,
    "values": about_the_values,
    "two_mistakes": two_mistakes,
    "notebook": from_the_notebook,
    "one_change": one_change,
    "events": order_of_events,
    "memory": about_the_memory,
    "code": about_the_code,
    "cases": about_the_cases,
}


def find_hint(seen: Evidence) -> Hint:
    """The hint of the first detector that has one; an empty hint where none has."""
    for name, detector in DETECTORS.items():
        if found := detector(seen):
            return found if isinstance(found, Hint) else Hint(name, found)
    return Hint("", "")
