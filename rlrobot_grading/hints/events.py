"""The first call of the world, of `choose` or `update` in which a loop differs from the right one.

The values that come out of a loop tell little about it; its calls tell what came too early, twice or never. A
difference that does no harm is passed over, as another a' where the episode has ended: the right function, with this
one call made as the learner makes it, is still right.
"""

from __future__ import annotations

import copy
import inspect
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.answers.limits import Elsewhere, attempt
from rlrobot_grading.answers.values import Function, kept, safely, same, show
from rlrobot_grading.hints.evidence import Evidence

MOST = 500  # calls that are noted
HARMLESS = 20  # differences that are passed over in a case
WORLD = ("reset", "step")


class Call(NamedTuple):
    """One call: of what, and with what, in the order of its parameters; tables as they were."""

    name: str
    given: tuple[Any, ...]


class Difference(NamedTuple):
    """A call of a case that differs.

    kind: what all wrong cases must have in common; told: in words; does_harm: whether it alone makes the case wrong
    is_late: whether the call that is due comes later; is_short: whether nothing comes in its place
    """

    kind: tuple[str, ...] = ()
    told: str = ""
    does_harm: bool = True
    is_late: bool = False
    is_short: bool = False


@dataclass
class Log:
    """The calls that a loop makes, in their order, and what is done differently in one of them.

    changed: by the number of a call the place of an argument, and what stands there instead; left_out: calls that
    are not made, and return None
    """

    changed: Mapping[int, tuple[int, Any]] = field(default_factory=dict)
    left_out: Sequence[int] = ()
    calls: list[Call] = field(default_factory=list)

    def call(self, name: str, thing: Function, given: Sequence[Any]) -> Any:
        """Note a call and make it, if it is not to be left out."""
        number = len(self.calls)
        if number < MOST:
            self.calls.append(Call(name, tuple(map(kept, given))))
        if number in self.left_out:
            return None
        arguments = list(given)
        if number in self.changed:
            place, value = self.changed[number]
            arguments[place] = value
        return thing(*arguments)


class Noted:
    """A function that a loop is given, whose calls are noted; of a world `reset` and `step`."""

    def __init__(self, name: str, thing: Any, log: Log) -> None:
        self._name, self._thing, self._log = name, thing, log

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = getattr(self._thing, name)
        if name not in WORLD:
            return found
        return Noted(f"{self._name}.{name}", found, self._log)

    def __call__(self, *arguments: Any, **by_name: Any) -> Any:
        given = (*arguments, *by_name.values())
        if by_name:
            given = safely(given, _in_order, self._thing, arguments, by_name)
        return self._log.call(self._name, self._thing, given)


def order_of_events(seen: Evidence) -> str:
    """What is the first to differ in the calls of a loop, if it is the same in every wrong case."""
    things = seen.cases[0].values()
    if issubclass(type(seen.answer), Elsewhere) or not any(map(_is_noted, things)):
        return ""  # the calls in another process are not seen
    mine = {i: safely([], _calls, seen, seen.answer, i) for i in seen.wrong}
    called = {call.name for calls in mine.values() for call in calls}
    differ = [safely([], _differences, seen, i, mine[i], called) for i in seen.wrong]
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


def _in_order(
    thing: Function, arguments: Sequence[Any], by_name: Mapping[str, Any]
) -> tuple[Any, ...]:
    return inspect.signature(thing).bind(*arguments, **by_name).args


def _is_noted(thing: Any) -> bool:
    return callable(thing) or all(hasattr(thing, name) for name in WORLD)


def _noting(function: Function, names: Sequence[str], log: Log) -> Function:
    """The function, with each call of what it is given noted, or changed, in `log`."""

    def noting(*arguments: Any) -> Any:
        given = zip(names, arguments, strict=True)
        return function(
            *[Noted(n, thing, log) if _is_noted(thing) else thing for n, thing in given]
        )

    return noting


def _calls(seen: Evidence, function: Function, i: int) -> list[Call]:
    """The calls that `function` makes in case `i`."""
    log = Log()
    # together, for `choose` may look at the world's clock
    given = copy.deepcopy(dict(seen.cases[i]))
    arguments = [given[name] for name in seen.parameters]
    attempt(_noting(function, seen.parameters, log), *arguments)
    return log.calls


def _does_no_harm(seen: Evidence, i: int, log: Log) -> bool:
    """Whether the right function is still right in case `i` if its calls are made as `log` has them."""
    right = _noting(seen.right, seen.parameters, log)
    return seen.expected[i].equals(seen.outcome(right, seen.cases[i]))


def _differences(
    seen: Evidence, i: int, mine: Sequence[Call], called: Collection[str]
) -> list[Difference]:
    """The calls of case `i` that are others than the right ones, until the first that does harm.

    mine: the learner's calls in this case; called: the names of all that the learner calls in the wrong cases
    """
    right = _calls(seen, seen.right, i)
    found: list[Difference] = []
    here = 0
    for there, wanted in enumerate(right):
        got = mine[here] if here < len(mine) else None
        if got is None or got.name != wanted.name:
            logs = [(_due(wanted, mine, here, called), Log(left_out=[there]))]
        else:
            number = sum(call.name == got.name for call in mine[: here + 1])
            here += 1
            logs = [
                (_other(seen, wanted, got, place, number), Log({there: (place, value)}))
                for place, value in _other_arguments(wanted, got)
            ]
        for difference, log in logs:
            does_harm = len(found) > HARMLESS or not _does_no_harm(seen, i, log)
            found.append(difference._replace(does_harm=does_harm))
            if does_harm:
                return found
    if here < len(mine):
        name = mine[here].name
        told = f"yours goes on too long: it calls {name} once more when all is done."
        found.append(Difference(("long", name), told))
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
    is_late = any(_is_same(wanted, later) for later in mine[here + 1 :])
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
    if sum(map(_is_noted, seen.cases[0].values())) == 1:
        # nothing else is noted that may have led there
        told += " Something before that has gone another way."
    return Difference(("argument", got.name, argument), told)


def _other_arguments(wanted: Call, got: Call) -> Iterator[tuple[int, Any]]:
    """The places of a call's arguments that are other than the right ones, and what stands there."""
    for place, (theirs, its) in enumerate(zip(wanted.given, got.given, strict=False)):
        if not same(theirs, its):
            yield place, its


def _is_same(one: Call, other: Call) -> bool:
    is_alike = one.name == other.name and len(one.given) == len(other.given)
    return is_alike and not list(_other_arguments(one, other))
