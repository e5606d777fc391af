"""One case is tried on a learner's function, and what comes of it is kept, so that it can be compared."""

from __future__ import annotations

import copy
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from rlrobot_grading.answers.limits import Failure, attempt
from rlrobot_grading.answers.values import Function, kept, safely, same

Case = Mapping[str, Any]  # the arguments of one call, by name


@dataclass(frozen=True)
class Outcome:
    """What a function does in one case.

    values: what it returns and what it leaves in the arguments that it may change, by name
    spoilt: names of the arguments that it should only have read, and has changed
    failure: the exception that it ended with, if it did; printed: what it printed meanwhile
    """

    values: Mapping[str, Any]
    spoilt: tuple[str, ...] = ()
    failure: Failure | None = None
    printed: str = ""

    def equals(self, other: Outcome) -> bool:
        """Whether two functions do the same in this case, as far as it matters."""
        kinds = [
            outcome.failure.kind if outcome.failure else "" for outcome in (self, other)
        ]
        return (
            kinds[0] == kinds[1]
            and self.spoilt == other.spoilt
            and same(dict(self.values), dict(other.values))
        )


def cases_of(
    right: Function,
    tape: Sequence[Case],
    memory: Case,
    returns: str,
    names: Sequence[str],
) -> list[Case]:
    """The cases of an exercise: the steps of its tape, each with the memory as the right function has left it.

    So every case stands for itself: a mistake in one does not spoil the cases after it.
    """
    cases: list[Case] = []
    now = copy.deepcopy(dict(memory))
    for step in tape:
        cases.append({**copy.deepcopy(now), **step})
        if not memory:
            continue
        value = right(*[{**now, **copy.deepcopy(dict(step))}[name] for name in names])
        if returns in memory:
            now[returns] = value
    return cases


def outcome_of(
    answer: Function,
    case: Case,
    names: Sequence[str],
    memory: Sequence[str],
    returns: str,
    endless: bool,
) -> Outcome:
    """Call `answer` with the arguments `names` of `case`, of which it may change those in `memory`.

    endless: whether it may take as long as it likes
    """
    arguments = copy.deepcopy(dict(case))
    value, failure, printed = attempt(
        answer, *[arguments[name] for name in names], endless=endless
    )
    spoilt = tuple(
        name
        for name in names
        if name not in memory and safely(True, _changed, case[name], arguments[name])
    )
    if failure:
        return Outcome({}, spoilt, failure, printed)
    values = {name: arguments[name] for name in memory} | (
        {returns: value} if returns else {}
    )
    return Outcome(
        {name: kept(thing) for name, thing in values.items()}, spoilt, None, printed
    )


def _changed(before: Any, after: Any) -> bool:
    """Whether something that can be changed in place has been: an array, or a list and its like."""
    if isinstance(before, np.ndarray):
        return not (
            type(after) is type(before)
            and np.array_equal(before, after, equal_nan=True)
        )
    return isinstance(before, list | dict | set | deque) and not same(before, after)
