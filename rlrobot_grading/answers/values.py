"""Values of answers: what data they are, when two are the same, how they differ, how a learner would write them.

An answer may be anything, and its own code (`__eq__`, `__repr__`, `__array__` …) runs when it is looked at. So all that
looks at one goes through `safely`, and nothing is copied or written out further than it can be read.

One rule holds for values in the notebook and for those that a kernel sends while a notebook is graded: what counts of
one is `as_data` of it.
"""

from __future__ import annotations

import copy
from collections import deque
from collections.abc import Callable, Mapping, Sequence, Sized
from itertools import islice
from types import MappingProxyType
from typing import Any, TypeVar

import numpy as np

ROWS_SHOWN = 6  # of a comparison; more would hide the first
MOST_SIGNS = 200  # of a value that is shown
MOST_SHOWN = 15  # entries of an array that are all shown
MOST_LEVELS = 4  # of lists in lists that are shown
MOST_ENTRIES = 1000  # of a value, on all levels; no right answer has nearly as many

# and dict; their subclasses count as these
CONTAINERS = (list, tuple, set, frozenset, deque)

Function = Callable[..., Any]  # a learner's answer, the right one, or a wrong one
T = TypeVar("T")


def safely(instead: T, function: Callable[..., T], *arguments: Any) -> T:
    """What `function` returns; `instead` where it raises anything but the interrupt of a reader who waits no longer."""
    try:
        return function(*arguments)
    except KeyboardInterrupt:
        raise
    except BaseException:
        return instead


class Unkept:
    """What a check keeps of a value that is too large, or that cannot be copied: how it looks. It equals nothing."""

    def __init__(self, text: str) -> None:
        self._text = text

    def __repr__(self) -> str:
        return self._text


def kept(value: Any) -> Any:
    """A copy of `value`, which no later step can change; `Unkept` if there is none."""
    copied = safely(None, _copied, as_data(value))
    return Unkept(show(value)) if copied is None and value is not None else copied


def _copied(value: Any) -> Any:
    return None if is_large(value) else copy.deepcopy(value)


def as_data(value: Any) -> Any:
    """A value without its dress: numbers, texts, arrays of numbers, and the containers of Python that hold such.

    What NumPy would make numbers of is numbers: a range, a Fraction, a matrix, an array of objects. Numbers that cannot
    be read, as those that a mask hides, are `Unkept`. What is no data, as a function, and what is large stays as it is.
    """
    if value is None or safely(True, is_large, value):
        return value
    data = safely(None, _data, value)
    return Unkept(show(value)) if data is None else data


def _data(value: Any) -> Any:
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, bytes | bytearray):
        return Unkept(show(value))
    for kind, plain in (
        (str, str.__str__),
        (int, int.__int__),
        (float, float.__float__),
    ):
        if isinstance(value, kind):
            return plain(value)  # type: ignore[operator]  # its own methods are not asked
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, Mapping):
        return {_data(key): _data(entry) for key, entry in value.items()}
    for container in CONTAINERS:
        if isinstance(value, container):
            return container(_data(entry) for entry in islice(value, MOST_ENTRIES + 1))
    if isinstance(value, Sequence):
        return as_data(list(islice(value, MOST_ENTRIES + 1)))
    if isinstance(value, np.bool_):
        return bool(value)
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, complex | np.complexfloating):
        return complex(value)
    if hasattr(type(value), "__array__") and not isinstance(value, np.generic):
        return _array(np.asarray(value))
    return float(value) if hasattr(type(value), "__float__") else value


def _array(value: np.ndarray) -> Any:
    """An array of numbers as one that is nothing more; of texts and of objects a list."""
    if np.ma.is_masked(value):
        return Unkept(show(value))
    array = np.asarray(value)
    kind = array.dtype.kind
    if kind in "biu":
        return array
    if kind == "f":
        return array.astype(float)
    if kind == "c":
        return array.astype(complex)
    return as_data(array.tolist()) if kind in "OU" else Unkept(show(value))


def is_large(value: Any) -> bool:
    """Whether a value has more than MOST_ENTRIES on all levels together; a list that holds itself has."""
    waiting, n = [value], 0
    while waiting and n + len(waiting) <= MOST_ENTRIES:
        part, n = waiting.pop(), n + 1
        if isinstance(part, np.ndarray):
            n += part.size
        elif isinstance(part, list | tuple | set | frozenset | deque | dict):
            waiting.extend(
                islice(part.values() if isinstance(part, dict) else part, MOST_ENTRIES)
            )
        elif isinstance(part, Sized) and not isinstance(part, str | bytes):
            n += len(part)
    return n + len(waiting) > MOST_ENTRIES


def same(a: Any, b: Any, relative: float = 1e-9) -> bool:
    """Whether two values are equal as data, numbers up to a relative difference."""
    return safely(False, _same, as_data(a), as_data(b), relative)


def _same(a: Any, b: Any, relative: float) -> bool:
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(
            _same(a[key], b[key], relative) for key in a
        )
    if isinstance(a, str) or isinstance(b, str) or a is None or b is None:
        return a is b or (
            isinstance(a, str)
            and isinstance(b, str)
            and a.strip().lower() == b.strip().lower()
        )
    if is_large(a) or is_large(b):
        return False
    try:
        x, y = _numbers(a), _numbers(b)
    except (TypeError, ValueError, OverflowError):
        # arrays of unlike shapes
        if isinstance(a, list | tuple | deque) and isinstance(b, list | tuple | deque):
            return len(a) == len(b) and all(
                _same(x, y, relative) for x, y in zip(a, b, strict=True)
            )
        return bool(type(a) is type(b) and a == b)
    return x.shape == y.shape and np.allclose(
        x, y, rtol=relative, atol=1e-12, equal_nan=True
    )


def _numbers(value: Any) -> np.ndarray:
    if np.asarray(value).dtype.kind in "US":
        raise TypeError("text is no number, even where it could be read as one")
    # float would drop what is imaginary
    return np.asarray(value, dtype=complex if np.iscomplexobj(value) else float)


def differences(
    expected: Mapping[str, Any], got: Mapping[str, Any]
) -> tuple[tuple[str, str, str], ...]:
    """Name, expected and got of what differs; of arrays of the same shape, the entries that differ."""
    rows = []
    for name, right in expected.items():
        mine = got.get(name)
        if not same(mine, right):
            rows += safely([], _entries, name, right, mine) or [
                (name, *_shown_apart(right, mine))
            ]
    if len(rows) > ROWS_SHOWN:
        rows[ROWS_SHOWN:] = [(f"and {len(rows) - ROWS_SHOWN} more", "", "")]
    return tuple(rows)


def _entries(name: str, right: Any, mine: Any) -> list[tuple[str, str, str]]:
    """The entries in which two arrays of the same shape differ; empty for anything else."""
    if not (
        isinstance(right, np.ndarray)
        and isinstance(mine, np.ndarray)
        and right.shape == mine.shape
    ):
        return []
    differ = np.argwhere(~np.isclose(right, mine, rtol=1e-9, atol=1e-12)).tolist()
    return [
        (
            f"{name}[{', '.join(map(str, i))}]",
            *_shown_apart(right[tuple(i)], mine[tuple(i)]),
        )
        for i in differ
    ]


def _shown_apart(right: Any, mine: Any) -> tuple[str, str]:
    """Two values that differ, as they are shown; with all digits where few would look the same."""
    shown = show(right), show(mine)
    if shown[0] != shown[1]:
        return shown
    written = safely("", _written, right), safely("", _written, mine)
    return written if written[0] != written[1] else shown


def _written(value: Any) -> str:
    return one_line(repr(np.asarray(as_data(value)).tolist()))


def show(value: Any, level: int = 0) -> str:
    """A value as a learner would write it, in a line: numbers with few digits, of a large array its shape."""
    return one_line(
        safely("", _shown, value, level)
        or safely("a value that cannot be shown", _kind, value)
    )


def _kind(value: Any) -> str:
    return f"a value of type {type(value).__name__}"


def _shown(value: Any, level: int) -> str:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return _shown(value[()], level)
    if isinstance(value, np.ndarray) and value.size > MOST_SHOWN:
        return f"array of shape {value.shape}"
    if isinstance(value, np.ndarray | list | tuple):
        if level == MOST_LEVELS:
            return "[…]"
        parts: list[str] = []
        for part in value:
            parts.append(show(part, level + 1))
            if sum(map(len, parts)) > MOST_SIGNS:
                break  # nobody would read the rest
        return "[" + ", ".join(parts) + "]"
    if isinstance(value, bool | np.bool_ | int | np.integer | str) or value is None:
        return str(value) or "''"
    if isinstance(value, float | np.floating):
        return f"{value:.5g}"
    if isinstance(value, dict | set | frozenset | deque) and is_large(value):
        return f"a {type(value).__name__} of {len(value)} entries"
    if isinstance(value, deque):
        return f"deque({_shown(list(value), level)})"
    if isinstance(value, set | frozenset) and value:
        return "{" + ", ".join(show(part, level + 1) for part in _in_order(value)) + "}"
    if type(value) is MappingProxyType and not is_large(value):
        value = dict(value)
    if isinstance(value, dict) and level < MOST_LEVELS:
        entries = [
            f"{_in_dict(key, level)}: {_in_dict(part, level)}"
            for key, part in value.items()
        ]
        return "{" + ", ".join(entries) + "}"
    text = repr(value)
    # an address says nothing to a learner
    return _kind(value) if " at 0x" in text else text


def _in_order(entries: set[Any] | frozenset[Any]) -> list[Any]:
    """The entries of a set in an order that does not depend on how it was made."""
    try:
        return sorted(entries)
    except TypeError:
        return sorted(entries, key=lambda entry: (type(entry).__name__, repr(entry)))


def _in_dict(value: Any, level: int) -> str:
    """A key or a value of a dict; tuples in round brackets, for a list can be no key."""
    shown = show(value, level + 1)
    if isinstance(value, tuple) and shown.startswith("["):
        return f"({shown[1:-1]})"
    return shown


def one_line(text: str, most: int = MOST_SIGNS) -> str:
    """`text` without what breaks a line or a terminal, cut where it gets long."""
    text = "".join(sign if sign.isprintable() else " " for sign in text[: most + 1])
    return text if len(text) <= most else text[: most - 1] + "…"
