"""The calls that a loop makes of its world, of the functions that it is given, and of those in its cell, noted."""

from __future__ import annotations

import copy
import inspect
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import FunctionType
from typing import Any, NamedTuple

from rlrobot_grading.answers.limits import attempt
from rlrobot_grading.answers.values import Function, kept, safely, same
from rlrobot_grading.hints.evidence import Evidence

MOST = 500  # calls that are noted
WORLD = ("reset", "step")


class Call(NamedTuple):
    """One call: of what, and with what, in the order of its parameters; tables as they were.

    steps: how many of the world's steps came before it; state: the last one that the world has told
    """

    name: str
    given: tuple[Any, ...]
    steps: int = 0
    state: Any = None


@dataclass
class Log:
    """The calls that a loop makes, in their order; or what is done differently in one of them, and then none is kept.

    changed: by the number of a call the place of an argument, and what stands there instead; left_out: calls that
    are not made, and return None
    """

    changed: Mapping[int, tuple[int, Any]] = field(default_factory=dict)
    left_out: Sequence[int] = ()
    calls: list[Call] = field(default_factory=list)
    number: int = 0
    steps: int = 0
    state: Any = None

    def call(self, name: str, thing: Function, given: Sequence[Any]) -> Any:
        """Note a call and make it, if it is not to be left out."""
        number, self.number = self.number, self.number + 1
        if number < MOST and not (self.changed or self.left_out):
            now = tuple(map(kept, given))
            self.calls.append(Call(name, now, self.steps, self.state))
        if number in self.left_out:
            return None
        arguments = list(given)
        if number in self.changed:
            place, value = self.changed[number]
            arguments[place] = value
        value = thing(*arguments)
        if name.endswith(".step"):
            self.steps, self.state = self.steps + 1, kept(value[0])
        elif name.endswith(".reset"):
            self.state = kept(value)
        return value


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


def _in_order(
    thing: Function, arguments: Sequence[Any], by_name: Mapping[str, Any]
) -> tuple[Any, ...]:
    return inspect.signature(thing).bind(*arguments, **by_name).args


def is_noted(thing: Any) -> bool:
    """Whether the calls of an argument are noted: it is a function, or a world."""
    return callable(thing) or all(hasattr(thing, name) for name in WORLD)


def noting(
    function: Function,
    names: Sequence[str],
    log: Log,
    borrowed: Collection[str] = (),
) -> Function:
    """The function, with each call of what it is given noted, or changed, in `log`.

    names: of its arguments; borrowed: of the functions of its cell whose calls are noted, too
    """
    if borrowed:
        cell = function.__globals__
        others = {name: Noted(name, cell[name], log) for name in borrowed}
        copied = FunctionType(
            function.__code__,
            {**cell, **others},
            function.__name__,
            function.__defaults__,
            function.__closure__,
        )
        copied.__kwdefaults__ = function.__kwdefaults__
        function = copied

    def noted(*arguments: Any) -> Any:
        given = zip(names, arguments, strict=True)
        return function(
            *[Noted(n, thing, log) if is_noted(thing) else thing for n, thing in given]
        )

    return noted


def calls_of(
    seen: Evidence, function: Function, i: int, borrowed: Collection[str] = ()
) -> list[Call]:
    """The calls that `function` makes in case `i`."""
    log = Log()
    # together, for `choose` may look at the world's clock
    given = copy.deepcopy(dict(seen.cases[i]))
    arguments = [given[name] for name in seen.parameters]
    attempt(noting(function, seen.parameters, log, borrowed), *arguments)
    return log.calls


def does_no_harm(
    seen: Evidence, i: int, log: Log, borrowed: Collection[str] = ()
) -> bool:
    """Whether the right function is still right in case `i` if its calls are made as `log` has them."""
    right = noting(seen.right, seen.parameters, log, borrowed)
    return seen.expected[i].equals(seen.outcome(right, seen.cases[i]))


def other_arguments(wanted: Call, got: Call) -> Iterator[tuple[int, Any]]:
    """The places of a call's arguments that are other than the right ones, and what stands there."""
    for place, (theirs, its) in enumerate(zip(wanted.given, got.given, strict=False)):
        if not same(theirs, its):
            yield place, its


def is_same(one: Call, other: Call) -> bool:
    """Whether two calls are of the same function with the same arguments."""
    is_alike = one.name == other.name and len(one.given) == len(other.given)
    return is_alike and not list(other_arguments(one, other))
