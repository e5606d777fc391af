"""The first call of the world, of `choose` or `update` in which a loop differs from the right one.

The values that come out of a loop tell little about it; its calls tell what came too early, twice or never. A
difference that does no harm is passed over, as another a' where the episode has ended: the right function, with this
one call made as the learner makes it, is still right.
"""

from __future__ import annotations

import inspect
from collections.abc import Collection, Sequence
from typing import NamedTuple

import numpy as np

from rlrobot_grading.answers.limits import Elsewhere
from rlrobot_grading.answers.values import safely, show
from rlrobot_grading.hints.calls import (
    Call,
    Log,
    calls_of,
    does_no_harm,
    is_noted,
    is_same,
    other_arguments,
)
from rlrobot_grading.hints.evidence import Evidence

HARMLESS = 20  # differences that are passed over in a case


class Difference(NamedTuple):
    """A call of a case that differs.

    kind: what all wrong cases must have in common; told: in words; does_harm: whether it alone makes the case wrong
    is_late: whether the call that is due comes later; is_short: whether nothing comes in its place
    place: the number of the right call that differs, and that of the learner's; such a call may be missing
    """

    kind: tuple[str, ...] = ()
    told: str = ""
    does_harm: bool = True
    is_late: bool = False
    is_short: bool = False
    place: tuple[int, int] = (0, 0)


def order_of_events(seen: Evidence) -> str:
    """What is the first to differ in the calls of a loop, if it is the same in every wrong case."""
    things = seen.cases[0].values()
    if issubclass(type(seen.answer), Elsewhere) or not any(map(is_noted, things)):
        return ""  # the calls in another process are not seen
    mine = {i: safely([], calls_of, seen, seen.answer, i) for i in seen.wrong}
    called = {call.name for calls in mine.values() for call in calls}
    differ = [safely([], differences_in, seen, i, mine[i], called) for i in seen.wrong]
    # what does no harm in one case, by chance, may do so in another
    harmful = {one.kind for several in differ for one in several if one.does_harm}
    found = [
        next((one for one in several if one.kind in harmful), Difference())
        for several in differ
    ]
    if not found[0].does_harm:
        return ""  # that is the case which the learner sees
    kinds = {one.kind for one in found}
    if len(kinds) > 1:
        # what is due is told of the case that the learner sees
        are_due = all(kind[:1] == ("due",) for kind in kinds)
        return found[0].told if are_due else ""
    # where something stands in the place of what is due, more is to be seen than at the end
    plainest = min(found, key=lambda one: (not one.is_late, one.is_short))
    is_missing = not plainest.is_short and any(one.is_short for one in found)
    return plainest.told + (" At the very end it is missing." if is_missing else "")


def differences_in(
    seen: Evidence, i: int, mine: Sequence[Call], called: Collection[str]
) -> list[Difference]:
    """The calls of case `i` that are others than the right ones, until the first that does harm.

    mine: the learner's calls in this case; called: the names of all that the learner calls in the wrong cases
    """
    right = calls_of(seen, seen.right, i)
    found: list[Difference] = []
    here = 0
    for there, wanted in enumerate(right):
        place_of_both = (there, here)
        got = mine[here] if here < len(mine) else None
        if got is None or got.name != wanted.name:
            logs = [(_due(wanted, mine, here, called), Log(left_out=[there]))]
        else:
            number = sum(call.name == got.name for call in mine[: here + 1])
            here += 1
            logs = [
                (_other(seen, wanted, got, place, number), Log({there: (place, value)}))
                for place, value in other_arguments(wanted, got)
            ]
        for difference, log in logs:
            does_harm = len(found) > HARMLESS or not does_no_harm(seen, i, log)
            found.append(difference._replace(does_harm=does_harm, place=place_of_both))
            if does_harm:
                return found
    if here < len(mine):
        name = mine[here].name
        told = f"yours goes on too long: it calls {name} once more when all is done."
        found.append(Difference(("long", name), told, place=(len(right), here)))
    return found


def _due(
    wanted: Call, mine: Sequence[Call], here: int, called: Collection[str]
) -> Difference:
    """A call is due in the place `here` of the learner's calls, and another one stands there, or none."""
    due = wanted.name
    if due not in called:
        return Difference(("never", due), f"yours never calls {due}.")
    before = f"after {mine[here - 1].name}" if here else "at first"
    kind = ("due", before, due)
    if here == len(mine):
        told = f"yours ends too early: {before} comes {due}."
        return Difference(kind, told, is_short=True)
    got = mine[here].name
    is_late = any(is_same(wanted, later) for later in mine[here + 1 :])
    if is_late:
        told = f"yours calls {due} too late: it is due {before}, and {got} comes first."
    else:
        told = (
            f"the order of the calls: {before} yours calls {got}, where {due} is due."
        )
    return Difference(kind, told, is_late=is_late)


def _other(
    seen: Evidence, wanted: Call, got: Call, place: int, number: int
) -> Difference:
    """An argument of a call is another than the right one; number: of the call, among those of the same name."""
    theirs, its = wanted.given[place], got.given[place]
    if np.ndim(theirs):
        told = (
            f"in call {number} of {got.name} the table is another than it should be. "
            "What has changed it before, or has not?"
        )
        return Difference(("table", got.name), told)
    thing = seen.cases[0][got.name.partition(".")[0]]
    method = got.name.partition(".")[2]
    function = getattr(thing, method) if method else thing
    argument = list(inspect.signature(function).parameters)[place]
    told = f"in call {number} of {got.name}, {argument} is {show(its)} and should be {show(theirs)}."
    if sum(map(is_noted, seen.cases[0].values())) == 1:
        # nothing else is noted that may have led there
        told += " Something before that has gone another way."
    return Difference(("argument", got.name, argument), told)
