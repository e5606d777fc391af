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

# times that a function is asked the same, to see whether there is chance in it
AGAIN = 40
CHANCE = "called twice with the same arguments, your function answers differently. Is there chance in it?"


def chance(seen: Evidence) -> Hint | None:
    """It answers differently when it is asked again. This comes first: chance may look like any mistake."""
    first = seen.wrong[0]
    before = seen.got[first]
    if not safely(False, uses_chance, seen.answer) or before.failure:
        return None
    if not before.equals(before):
        return None  # some values equal nothing, not even themselves
    again = (seen.outcome(seen.answer, seen.cases[first]) for _ in range(AGAIN))
    if all(outcome.failure or outcome.equals(before) for outcome in again):
        return None
    outside = from_the_notebook(seen)
    if outside:
        return outside
    unread = about_the_code(seen)
    if unread:
        return Hint("code", unread)
    right = seen.expected[first].values.get(seen.returns)
    mine = before.values.get(seen.returns)
    shape = safely("", unlike, right, mine)
    return Hint("chance", f"{CHANCE} {shape[:1].upper()}{shape[1:]}".strip())


def known_mistake(seen: Evidence) -> Hint | None:
    """It computes what one of the exercise's mistakes computes, in every case."""
    return next((hint for hint, wrong in seen.mistakes if seen.shows(wrong)), None)


def two_mistakes(seen: Evidence) -> Hint | None:
    """It makes two of the mistakes at once."""
    return next((hint for hint, both in seen.pairs() if seen.shows(both)), None)


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
        found = detector(seen)
        if isinstance(found, Hint):
            return found
        if found:
            return Hint(name, found)
    return Hint("", "")
