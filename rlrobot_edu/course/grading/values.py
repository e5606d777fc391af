"""Values of answers: when two are the same, how they differ, and how a learner would write them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

ROWS_SHOWN = 6  # of a comparison; more would hide the first


def same(a: Any, b: Any, relative: float = 1e-9) -> bool:
    """Whether two values are equal, numbers up to a relative difference."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key], relative) for key in a)
    if isinstance(a, str) or isinstance(b, str) or a is None or b is None:
        return a is b or (isinstance(a, str) and isinstance(b, str) and a.strip().lower() == b.strip().lower())
    try:
        x, y = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    except (TypeError, ValueError):
        return bool(type(a) is type(b) and a == b)
    return x.shape == y.shape and np.allclose(x, y, rtol=relative, atol=1e-12, equal_nan=True)


def first_difference(some: Sequence[Any], others: Sequence[Any]) -> int:
    """How far two sequences are alike from the start: the index of the first difference, or the length of `some`."""
    return next((i for i, both in enumerate(zip(some, others, strict=False)) if not same(*both)), len(some))


def differences(expected: Mapping[str, Any], got: Mapping[str, Any]) -> tuple[tuple[str, str, str], ...]:
    """Name, expected and got of what differs; of arrays of the same shape, the entries that differ."""
    rows = []
    for name, right in expected.items():
        mine = got.get(name)
        if same(mine, right):
            continue
        if isinstance(right, np.ndarray) and isinstance(mine, np.ndarray) and right.shape == mine.shape:
            for index in np.argwhere(~np.isclose(right, mine, rtol=1e-9, atol=1e-12)):
                i = tuple(int(k) for k in index)
                rows.append((f"{name}[{', '.join(map(str, i))}]", show(right[i]), show(mine[i])))
        else:
            rows.append((name, show(right), show(mine)))
    more = ((f"and {len(rows) - ROWS_SHOWN} more", "", ""),) if len(rows) > ROWS_SHOWN else ()
    return (*rows[:ROWS_SHOWN], *more)


def show(value: Any) -> str:
    """A value as a learner would write it, numbers with few digits; of a large array its shape."""
    if isinstance(value, np.ndarray) and value.size > 12:
        return f"array of shape {value.shape}"
    if isinstance(value, np.ndarray | list | tuple):
        return "[" + ", ".join(show(x) for x in value) + "]"
    if isinstance(value, bool | np.bool_ | int | np.integer | str) or value is None:
        return str(value)
    if isinstance(value, float | np.floating):
        return f"{value:.5g}"
    return repr(value)
