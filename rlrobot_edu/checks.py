"""Checks of arguments, and the words that error messages share: the nearest known name, the line of a file."""

import difflib
import math
import re
import traceback
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import islice
from numbers import Real
from pathlib import Path
from typing import Any, Literal, TypeGuard, overload

import numpy as np

WHOLE = (int, np.integer)  # kinds of whole numbers; bool is one of them
LARGEST_NUMBER = 1e100  # of a reward, say: sums and squares of such numbers are finite
MOST_BINS = 100_000  # of one variable
MOST_PAIRS = 10_000_000  # of states and actions; a table has a number for each, and an agent has three tables


def did_you_mean(
    name: object, names: Iterable[str], meanings: Mapping[str, str] | None = None
) -> str:
    """``; did you mean 'x'?`` with the nearest of `names`, or a full stop if none is similar: a sentence can follow.

    Capitals, hyphens, spaces and underscores do not count. meanings: other words, each with the name that it means
    """
    written = {_bare(word): meant for word, meant in (meanings or {}).items()}
    written |= {_bare(each): each for each in names}
    near = difflib.get_close_matches(_bare(str(name)[:100]), written, n=1, cutoff=0.6)
    return f"; did you mean {written[near[0]]!r}?" if near else "."


def _bare(name: str) -> str:
    return re.sub(r"[-_\s]", "", name).lower()


def check_name(
    name: object,
    names: Collection[str],
    kind: str,
    owner: str,
    meanings: Mapping[str, str] | None = None,
) -> str:
    """`name` if it is one of `names`, or a ValueError that lists them and suggests the nearest, see `did_you_mean`."""
    if isinstance(name, str) and name in names:
        return name
    nearest = did_you_mean(name, names, meanings)
    raise ValueError(
        f"{owner} has no {kind} {name!r:.200}{nearest} It has: {', '.join(names)}"
    )


def check_index(kind: str, number: int, n: int) -> int:
    """The number of a state or action (`kind`) as an int. Raises ValueError unless it is one of 0 to n − 1."""
    if not (isinstance(number, WHOLE) and 0 <= number < n):
        raise ValueError(
            f"there is no {kind} {number!r:.200}: {kind}s are the integers 0 to {n - 1}"
        )
    return int(number)


def check_pair(shape: tuple[int, ...], s: int, a: int = 0) -> tuple[int, int]:
    """(s, a) as ints. Raises ValueError for a state or an action that a table of this `shape` does not have."""
    n_states, n_actions = shape
    return check_index("state", s, n_states), check_index("action", a, n_actions)


def check_transition(
    shape: tuple[int, ...], s: int, a: int, r: Any, s_next: int
) -> tuple[int, int, float, int]:
    """(s, a, r, s_next) in Python's own numbers, which kernels know. Raises ValueError for an impossible one."""
    s, a = check_pair(shape, s, a)
    s_next = check_index("state", s_next, shape[0])
    if isinstance(r, np.generic | np.ndarray) and r.ndim == 0:
        r = r.item()
    check_between("a reward", r, -LARGEST_NUMBER, LARGEST_NUMBER)
    return s, a, float(r), s_next


def is_whole(number: object) -> TypeGuard[int | np.integer[Any]]:
    """Whether it is a whole number, Python's or NumPy's; True and False are none."""
    return isinstance(number, WHOLE) and not isinstance(number, bool)


@overload
def check_count(name: str, number: object, least: int = 1) -> int: ...
@overload
def check_count(
    name: str, number: object, least: int = 1, *, or_none: Literal[True]
) -> int | None: ...
def check_count(
    name: str, number: object, least: int = 1, *, or_none: bool = False
) -> int | None:
    """`number` as Python's int; a small integer of NumPy could not hold what is computed with it.

    Raises ValueError unless it is a whole number, Python's or NumPy's, of at least `least` (or None).
    """
    if or_none and number is None:
        return None
    if is_whole(number) and int(number) >= least:
        return int(number)
    expected = "None or a" if or_none else "a"
    given = in_a_line(f"{number!r:.200}")
    raise ValueError(
        f"{name} must be {expected} whole number of at least {least}, got {given}"
    )


def check_text(name: str, text: object) -> None:
    """Raises ValueError unless `text` is one."""
    if not isinstance(text, str):
        raise ValueError(f"{name} must be a text, got {text!r:.200}")


def check_between(
    name: str, number: float, low: float, high: float, unit: str = ""
) -> None:
    """Raises ValueError unless `number` is real and from `low` to `high`, in a `unit` such as " of seconds"."""
    if isinstance(number, np.generic):
        number = number.item()  # a small float of NumPy overflows beside 1e100
    if not (isinstance(number, Real) and low <= number <= high):
        limits = f"at least {low:g} and at most {high:g}"
        raise ValueError(
            f"{name} must be a number{unit}, {limits}, got {number!r:.200}"
        )


def check_numbers(
    what: str, given: Sequence[float], finite: bool = False
) -> tuple[float, ...]:
    """The given numbers as floats; if `finite`, one or more finite ones. Raises ValueError that names `what`."""
    try:
        if isinstance(given, str | bytes | bytearray | Mapping):
            raise TypeError("its letters or keys are not meant")
        # unlike float(), ldexp takes no text
        floats = tuple(math.ldexp(x, 0) for x in islice(given, MOST_BINS + 1))
    except (TypeError, ValueError, OverflowError):
        raise ValueError(
            f"{what} must be a list of numbers, got {given!r:.200}"
        ) from None
    if len(floats) > MOST_BINS:
        raise ValueError(f"{what} must be at most {MOST_BINS:,} numbers")
    if finite and not (floats and all(abs(x) <= LARGEST_NUMBER for x in floats)):
        raise ValueError(
            f"{what} must be one or more finite numbers up to 1e100, got {list(floats)!s:.200}"
        )
    return floats


def check_table(n_states: int, n_actions: int) -> int:
    """Number of pairs in a table of so many states and actions. Raises ValueError if that is too large."""
    if n_states * n_actions > MOST_PAIRS:
        limit = f"at most {MOST_PAIRS:,} pairs; use fewer inputs, outputs or bins"
        raise ValueError(
            f"{n_states:,} states × {n_actions:,} actions are too many for a table: {limit}"
        )
    return n_states * n_actions


def all_in_range(numbers: np.ndarray, n: float) -> bool:
    """Whether all `numbers`, an array of any shape, are 0 to n − 1."""
    return bool(((numbers >= 0) & (numbers < n)).all())


def first_difference(there: dict[str, Any], here: dict[str, Any], place: str) -> str:
    """The first fact, by name, that differs `there`, in a `place` such as "file"; empty if none does."""
    for name in there | here:
        was = in_a_line(there.get(name, "missing"))
        given = in_a_line(here.get(name, "missing"))
        if was != given:
            return f"{in_a_line(name):.200} is {was:.200} in the {place}, {given:.200}"
    return ""


def in_a_line(given: object) -> str:
    return " ".join(str(given).split())


def file_and_line(path: str | Path, error: BaseException) -> str:
    """`path`, and the line of that file in which `error` arose, if it did."""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if frame.filename == str(path)]
    return f"{path}, line {lines[-1]}" if lines else str(path)


def describe_error(error: BaseException, names: Iterable[str] | None = None) -> str:
    """What went wrong in a task's own code; for a missing key also the existing `names`."""
    if isinstance(error, KeyError) and names is not None:
        known = [in_a_line(name) for name in names]
        nearest = did_you_mean(error.args[0] if error.args else "", known)
        return f"there is no {error}{nearest} There are {', '.join(known)}"
    return f"{type(error).__name__}: {in_a_line(error):.500}"


def check_parts(what: str, parts: Iterable[tuple[str, object]]) -> None:
    """Raises ValueError for the first of `parts`, pairs of a name and whether that part is sound, that is not."""
    for name, is_sound in parts:
        if not is_sound:
            raise ValueError(f"{name} does not fit this {what}")
