"""How a hint is found: detectors are tried in the order of `DETECTORS`. The first that has a hint decides.

Each takes the `Evidence` on one wrong answer. It returns a `Hint`, or only its text, which then has the detector's name
as id; nothing where it has none. An answer that stops with an exception leaves them no values to look at: `errors`
tells what that exception means.
"""

from __future__ import annotations

import time
from collections.abc import Callable

from rlrobot_grading.answers.source import uses_chance
from rlrobot_grading.answers.values import safely
from rlrobot_grading.hints.as_if import one_change
from rlrobot_grading.hints.events import order_of_events
from rlrobot_grading.hints.evidence import Evidence, Hint
from rlrobot_grading.hints.in_place import not_in_place
from rlrobot_grading.hints.mistakes import known_mistake, two_mistakes
from rlrobot_grading.hints.remainders import what_is_left
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
RUNS_AGAIN = (
    5  # the same, if it runs a whole world: chance shows in one of its many steps
)
SECONDS = 1.0  # of computing that this may take
CHANCE = "called twice with the same arguments, your function answers differently. Is there chance in it?"


def chance(seen: Evidence) -> Hint | None:
    """It answers differently when it is asked again. This comes first: chance may look like any mistake."""
    first = seen.wrong[0]
    before = seen.got[first]
    if not safely(False, uses_chance, seen.answer) or before.failure:
        return None
    if not before.equals(before):
        return None  # some values equal nothing, not even themselves
    if not _differs(seen, first):
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


DETECTORS: dict[str, Callable[[Evidence], Hint | str | None]] = {
    "chance": chance,
    "known_mistake": known_mistake,
    "in_place": not_in_place,
    "values": about_the_values,
    "two_mistakes": two_mistakes,
    "notebook": from_the_notebook,
    "one_change": one_change,
    "events": order_of_events,
    "memory": about_the_memory,
    "code": about_the_code,
    "cases": about_the_cases,
    "left": what_is_left,
}


def _differs(seen: Evidence, i: int) -> bool:
    """Whether the answer does something else when it is asked the same case again, as far as there is time."""
    begun = time.process_time()
    times = RUNS_AGAIN if "env" in seen.cases[i] else AGAIN
    for _ in range(times):
        again = seen.outcome(seen.answer, seen.cases[i])
        if not again.failure and not again.equals(seen.got[i]):
            return True
        if time.process_time() - begun > SECONDS:
            break
    return False


def find_hint(seen: Evidence) -> Hint:
    """The hint of the first detector that has one; an empty hint where none has."""
    for name, detector in DETECTORS.items():
        found = detector(seen)
        if isinstance(found, Hint):
            return found
        if found:
            return Hint(name, found)
    return Hint("", "")
