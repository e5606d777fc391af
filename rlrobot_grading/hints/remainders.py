"""What can still be said of an answer of which no idea is known: which part of its result is wrong, and where.

Each sentence holds in every case that was tried, so it is true; it says where to look, not what is wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import as_data, is_large, safely, same, show
from rlrobot_grading.hints.evidence import Evidence

MOST_PARTS = 4  # of a result that has parts, such as x, y and z
FEWEST = 3  # cases on either side of a limit, so that it is no coincidence
ORDINALS = ("first", "second", "third", "fourth")

PLAIN = (int, float, list, tuple, dict, np.ndarray, np.generic)

Pair = tuple[Any, Any]  # what is asked, and the learner's


def what_is_left(seen: Evidence) -> str:
    """Which part of the result, or of a table, is wrong, or in which cases; an empty text where nothing holds."""
    if not seen.is_exact or any(outcome.failure for outcome in seen.got):
        return ""
    if len(seen.got) < len(seen.cases):
        return ""
    results = [value for outcome in seen.got for value in outcome.values.values()]
    if not all(isinstance(result, PLAIN) for result in results):
        return ""  # an iterator, for one, may never end
    if any(safely(True, is_large, result) for result in results):
        return ""
    told = (
        safely("", look, seen)
        for look in (_about_parts, _about_tables, _about_limits, _about_zeros)
    )
    return next((text for text in told if text), "") or safely("", _about_sizes, seen)


def _results(seen: Evidence, name: str) -> list[Pair]:
    """A value in each case: what is asked, and the learner's."""
    pairs = zip(seen.expected, seen.got, strict=True)
    return [(right.values[name], mine.values[name]) for right, mine in pairs]


def _about_parts(seen: Evidence) -> str:
    """Of a result of a few parts: which of them are right in every case."""
    if not seen.returns:
        return ""
    rows = [
        row for pair in _results(seen, seen.returns) for row in _rows_of_parts(*pair)
    ]
    n = len(rows[0][0])
    if not 2 <= n <= MOST_PARTS or any({len(x), len(y)} != {n} for x, y in rows):
        return ""
    is_right = [all(same(x[k], y[k]) for x, y in rows) for k in range(n)]
    vary = [any(not same(x[k], rows[0][0][k]) for x, _ in rows) for k in range(n)]
    right = [k for k in range(n) if is_right[k] and vary[k]]
    wrong = [k for k in range(n) if not is_right[k]]
    if not right or len(right) + len(wrong) < n:
        return ""
    kind = "list" if np.ndim(rows[0][0][right[0]]) else "number"
    verb = "are" if len(wrong) > 1 else "is"
    which = f"the {_listed(right)} {kind}{'s are' if len(right) > 1 else ' is'}"
    return f"{which} right in every case; the {_listed(wrong)} {verb} not."


def _rows_of_parts(right: Any, mine: Any) -> Iterator[tuple[Any, Any]]:
    """The parts of two results side by side; of dictionaries those of each entry. Raises TypeError for a number."""
    if not isinstance(right, dict):
        yield list(right), list(mine)
        return
    if right.keys() != mine.keys():
        raise TypeError("other keys")
    for key in right:
        yield list(right[key]), list(mine[key])


def _listed(numbers: Sequence[int]) -> str:
    return " and the ".join(ORDINALS[k] for k in numbers)


def _about_tables(seen: Evidence) -> str:
    """Of tables that the function changes: an entry that stays as it was, or changes that are all too large."""
    for name in seen.memory:
        before = [as_data(case[name]) for case in seen.cases]
        if not all(isinstance(table, np.ndarray) for table in before):
            return ""
        changes = [
            (right - was, mine - was)
            for was, (right, mine) in zip(before, _results(seen, name), strict=True)
        ]
        wrong = [(right, mine) for right, mine in changes if not same(right, mine)]
        if len(wrong) < 2:
            continue
        stays = [
            np.argwhere(~np.isclose(right, 0) & np.isclose(mine, 0)).tolist()
            for right, mine in wrong
        ]
        if all(stays):
            return f"less of {name} changes than should: {name}{stays[0][0]}, for one, stays as it was."
        ratios = [mine[right != 0] / right[right != 0] for right, mine in wrong]
        if len(wrong) < FEWEST or not all(
            same(mine[right == 0], right[right == 0]) for right, mine in wrong
        ):
            continue
        if all((one > 1 - 1e-9).all() for one in ratios):
            return f"the right entries of {name} change, but some of them too far: is something learned more than once?"
        if all(((one > 0) & (one < 1 + 1e-9)).all() for one in ratios):
            return f"the right entries of {name} change, but some of them not far enough: is something left out?"
    return ""


def _about_limits(seen: Evidence) -> str:
    """The cases that are wrong are those in which an argument, or its length, is as large as a limit or larger."""
    for name in seen.parameters:
        values = [case[name] for case in seen.cases]
        for measure, told in MEASURES:
            sizes = safely([], _measured, measure, values)
            wrong = [size for i, size in enumerate(sizes) if i in seen.wrong]
            right = [size for i, size in enumerate(sizes) if i not in seen.wrong]
            if min(len(wrong), len(right)) < FEWEST or min(wrong) <= max(right):
                continue
            limit = told.format(name=name, limit=show(min(wrong)))
            return f"it is wrong in all cases in which {limit}, and right in all others. What is different there?"
    return ""


def _measured(measure: Callable[[Any], float], values: Sequence[Any]) -> list[float]:
    return [measure(value) for value in values]


def _number(value: Any) -> float:
    """A number as it is. Raises TypeError for anything else."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError("no number")
    return float(value)


MEASURES: tuple[tuple[Callable[[Any], float], str], ...] = (
    (_number, "{name} is {limit} or more"),
    (len, "{name} has {limit} entries or more"),
)


def _about_zeros(seen: Evidence) -> str:
    """Something stands where 0 is asked, or 0 where something is, in each wrong case."""
    pairs = [_results(seen, seen.returns)[i] for i in seen.wrong]
    both = [(np.asarray(x, dtype=float), np.asarray(y, dtype=float)) for x, y in pairs]
    if len(both) < 2 or any(x.shape != y.shape or not x.ndim for x, y in both):
        return ""
    full = [np.argwhere((x == 0) & (y != 0)).tolist() for x, y in both]
    if all(full):
        return f"where 0 is asked, something else stands in yours: entry {full[0][0]} here, for one."
    empty = [np.argwhere((x != 0) & (y == 0)).tolist() for x, y in both]
    if all(empty):
        return f"0 stands in yours where something else is asked: entry {empty[0][0]} here, for one."
    return ""


def _about_sizes(seen: Evidence) -> str:
    """All that is wrong is too large, or all too small."""
    pairs = [_results(seen, seen.returns)[i] for i in seen.wrong]
    both = [(np.asarray(x, dtype=float), np.asarray(y, dtype=float)) for x, y in pairs]
    if len(both) < FEWEST or any(x.shape != y.shape for x, y in both):
        return ""
    gaps = np.concatenate([np.ravel(y - x) for x, y in both])
    if not np.isfinite(gaps).all():
        return ""
    if (gaps > -1e-9).all():
        return "whatever is wrong here is too large, and never too small. What counts too much?"
    if (gaps < 1e-9).all():
        return (
            "whatever is wrong here is too small, and never too large. What is missing?"
        )
    return ""
