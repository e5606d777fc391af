"""The first call of the world, of `choose` or `update` in which a loop differs from the right one.

The values that come out of a loop tell little about it; its calls tell what came too early, twice or never.
"""

from __future__ import annotations

import ast
import copy
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.answers.limits import Elsewhere, attempt
from rlrobot_grading.answers.replay import Case
from rlrobot_grading.answers.source import tree_of
from rlrobot_grading.answers.values import Function, kept, safely, same, show
from rlrobot_grading.hints.evidence import Evidence

MOST = 500  # calls that are noted
WORLD = ("reset", "step")


class Call(NamedTuple):
    """One call: of what, and with what; tables as they were."""

    name: str
    given: tuple[Any, ...]


class Noted:
    """A function that a loop is given, whose calls are noted; of a world `reset` and `step`."""

    def __init__(self, name: str, thing: Any, calls: list[Call]) -> None:
        self._name, self._thing, self._calls = name, thing, calls

    def __deepcopy__(self, memo: dict[int, Any]) -> Noted:
        return Noted(self._name, copy.deepcopy(self._thing, memo), self._calls)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        found = getattr(self._thing, name)
        return (
            Noted(f"{self._name}.{name}", found, self._calls)
            if name in WORLD
            else found
        )

    def __call__(self, *arguments: Any, **by_name: Any) -> Any:
        if len(self._calls) < MOST:
            self._calls.append(
                Call(self._name, tuple(map(kept, (*arguments, *by_name.values()))))
            )
        return self._thing(*arguments, **by_name)


def order_of_events(seen: Evidence) -> str:
    """What is the first to differ in the calls of a loop, if it is the same in every wrong case."""
    if issubclass(type(seen.answer), Elsewhere) or not any(
        map(_is_noted, seen.cases[0].values())
    ):
        return ""  # the calls in another process are not seen
    found = [safely(("", ""), _first_difference, seen, i) for i in seen.wrong]
    return found[0][1] if len({kind for kind, _ in found}) == 1 else ""


def _is_noted(thing: Any) -> bool:
    return callable(thing) or all(hasattr(thing, name) for name in WORLD)


def _calls(function: Function, case: Case, names: tuple[str, ...]) -> list[Call]:
    """The calls that `function` makes in a case."""
    calls: list[Call] = []
    # together, for `choose` may look at the world's clock
    given = copy.deepcopy(
        {n: Noted(n, case[n], calls) if _is_noted(case[n]) else case[n] for n in names}
    )
    attempt(function, *[given[name] for name in names])
    return calls


def _first_difference(seen: Evidence, i: int) -> tuple[str, str]:
    """The first call of case `i` that is another than the right one: of which kind that is, and in words."""
    case, names = seen.cases[i], seen.parameters
    right, mine = (
        _calls(function, case, names) for function in (seen.right, seen.answer)
    )
    called = {call.name for call in mine}
    for k, (wanted, got) in enumerate(zip(right, mine, strict=False)):
        if wanted.name != got.name:
            if wanted.name not in called:
                return wanted.name, f"yours never calls {wanted.name}."
            before = f"after {mine[k - 1].name}" if k else "at first"
            told = f"the order of the calls: {before} yours calls {got.name}, where {wanted.name} is due."
            return told, told
        which = _other_argument(wanted, got)
        if which is not None:
            theirs, its = wanted.given[which], got.given[which]
            if np.ndim(theirs):
                return (
                    got.name,
                    f"{got.name} is given another table than it should: what has changed it before?",
                )
            calls = (
                node
                for node in ast.walk(tree_of(seen.right))
                if isinstance(node, ast.Call)
            )
            named = next(
                ast.unparse(call.args[which])
                for call in calls
                if ast.unparse(call.func) == got.name
            )
            which_one = f"the argument {named} of {got.name}"
            return (
                which_one,
                f"{which_one} is {show(its)} in a call in which it should be {show(theirs)}.",
            )
    if len(mine) > len(right):
        return (
            "long",
            f"yours goes on too long: it calls {mine[len(right)].name} once more when all is done.",
        )
    if len(right) > len(mine) > 0:
        missing = right[len(mine)].name
        if missing not in called:
            return missing, f"yours never calls {missing}."
        return (
            "short",
            f"yours ends too early: after its last {mine[-1].name} comes {missing}.",
        )
    return "", ""


def _other_argument(wanted: Call, got: Call) -> int | None:
    """Which argument of a call is another than the right one."""
    pairs = zip(wanted.given, got.given, strict=False)
    return next(
        (k for k, (theirs, its) in enumerate(pairs) if not same(theirs, its)), None
    )
