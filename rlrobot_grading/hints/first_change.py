"""Where a run goes wrong that no call shows: after which step a table is another, or which entry of the result.

A loop that changes its tables itself hands them to nobody, and what it returns is made of all steps. So the tables are
looked at before each step of the world, and at the end.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from rlrobot_grading.answers.limits import Elsewhere, attempt
from rlrobot_grading.answers.values import (
    Function,
    differences,
    kept,
    safely,
    same,
    show,
)
from rlrobot_grading.hints.calls import WORLD, Log, noting
from rlrobot_grading.hints.evidence import Evidence
from rlrobot_grading.hints.first_event import MOST_ROWS, Rows, entries, first_event

TOLD = ("s_next", "r", "terminated", "truncated")  # by a step of a world


class Step(NamedTuple):
    """One step of the world: where it began, with which action, and what the world has told."""

    s: Any
    a: Any
    told: tuple[Any, ...]


@dataclass
class Tables(Log):
    """The calls of a loop, and with them its tables: before each step, and `end` adds how they are left.

    tables: by name, the loop's own; seen: a copy of each at these times; done: the steps
    """

    tables: Mapping[str, Any] = field(default_factory=dict)
    seen: list[dict[str, Any]] = field(default_factory=list)
    done: list[Step] = field(default_factory=list)

    def call(self, name: str, thing: Function, given: Any) -> Any:
        """Make a call; of a step of the world note what it tells."""
        if not name.endswith(".step"):
            return super().call(name, thing, given)
        self.end()
        before = self.state
        told = super().call(name, thing, given)
        self.done.append(Step(before, kept(given[0]), tuple(map(kept, told))))
        return told

    def end(self) -> None:
        """Copy the tables as they are now."""
        self.seen.append({name: kept(table) for name, table in self.tables.items()})


def first_that_differs(seen: Evidence) -> tuple[str, Rows]:
    """What the table of a wrong run has, and its rows: a call, a step, or an entry of the result; else nothing."""
    event = first_event(seen)
    if event:
        return "the first call in it that differs", event
    change = safely((), _first_change, seen)
    if change:
        return "the first step after which a table is another", change
    entry = safely((), _first_entry_of_the_result, seen)
    return ("the first entry that differs", entry) if entry else ("", ())


def _first_change(seen: Evidence) -> Rows:
    """After which step of the first wrong case a table is another; none where no step does."""
    if issubclass(type(seen.answer), Elsewhere) or not _has_a_world(seen):
        return ()
    right, mine = (_run(seen, one) for one in (seen.right, seen.answer))
    for n, (theirs, its) in enumerate(zip(right.seen, mine.seen, strict=False)):
        for name in theirs:
            if not same(theirs[name], its[name]):
                return _rows(n, right, mine, entries(name, theirs[name], its[name]))
    return ()


def _first_entry_of_the_result(seen: Evidence) -> Rows:
    i = seen.wrong[0]
    if not seen.returns or not _has_a_world(seen):
        return ()
    right, mine = (one[i].values[seen.returns] for one in (seen.expected, seen.got))
    return _first_entry(seen.returns, right, mine)


def _first_entry(name: str, right: Any, mine: Any) -> Rows:
    """The first entry in which two lists of the same length differ, with its place; none for anything else."""
    if not isinstance(right, list | tuple) or not isinstance(mine, list | tuple):
        return ()
    if len(right) != len(mine):
        return ()
    for k, (one, other) in enumerate(zip(right, mine, strict=True)):
        if not same(one, other):
            place = f"{name}[{k}]"
            return _first_entry(place, one, other) or differences(
                {place: one}, {place: other}
            )
    return ()


def _has_a_world(seen: Evidence) -> bool:
    things = seen.cases[0].values()
    return any(all(hasattr(thing, name) for name in WORLD) for thing in things)


def _run(seen: Evidence, function: Function) -> Tables:
    """What `function` does in the first wrong case."""
    given = copy.deepcopy(dict(seen.cases[seen.wrong[0]]))
    tables = {
        name: given[name]
        for name in seen.memory
        if isinstance(given.get(name), np.ndarray | dict)
    }
    log = Tables(tables=tables)
    attempt(
        noting(function, seen.parameters, log), *[given[n] for n in seen.parameters]
    )
    log.end()
    return log


def _rows(n: int, right: Tables, mine: Tables, changed: Rows) -> Rows:
    """The step number `n`, if both have made it, and what is another after it."""
    rows: list[tuple[str, str, str]] = [("steps so far", str(n), str(n))]
    steps = [log.done[n - 1] for log in (right, mine) if 0 < n <= len(log.done)]
    if len(steps) == 2:
        told = [
            {"s": one.s, "a": one.a, **dict(zip(TOLD, one.told, strict=False))}
            for one in steps
        ]
        rows += [(name, show(told[0][name]), show(told[1][name])) for name in told[0]]
    return (*rows, *changed)[:MOST_ROWS]
