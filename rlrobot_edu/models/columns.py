"""The rows of a recording: seven columns, checked, and as text that any spreadsheet can read."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from rlrobot_edu.models.source import Source

DTYPES = {
    "episode": np.int64,
    "step": np.int64,
    "s": np.int64,
    "a": np.int64,
    "r": np.float64,
    "s_next": np.int64,
    "terminated": np.bool_,
}
HEADER = ",".join(DTYPES)
REMEDY = "put back the original file, or record again"

Columns = dict[str, np.ndarray]
Where = Callable[[int], str]  # names a row in a message


def checked(columns: Mapping[str, np.ndarray], source: Source, where: Where) -> Columns:
    """Read-only copies of the columns, arrays (n,), in their own types; `where(i)` is how messages name row i.

    Raises ValueError that names the first row that cannot be and what was expected there.
    """
    found = {name: np.asarray(columns[name]) for name in DTYPES}
    lengths = {name: column.shape for name, column in found.items()}
    if len(set(lengths.values())) > 1 or found["s"].ndim != 1 or not len(found["s"]):
        raise ValueError(f"a recording is made of columns of one length, at least 1, got {lengths}")
    ends = {"s": source.states.n, "a": source.actions.n, "s_next": source.states.n, "terminated": 2}
    for name, column in found.items():
        if name == "r":
            bad, expected = ~np.isin(column, source.rewards), f"one of the rewards {list(source.rewards)}"
        else:
            end = ends.get(name, 2**53)  # up to here a float holds every whole number
            bad = ~((column == np.floor(column)) & (column >= 0) & (column < end))
            expected = "a whole number from 0" + (f" to {end - 1}" if name in ends else " on")
        if bad.any():
            row = int(np.argmax(bad))
            value = repr(column[row].item()).removesuffix(".0")
            raise ValueError(f"{where(row)}: {name} is {value}, expected {expected}; {REMEDY}")
    _check_order(found["episode"], found["step"], found["terminated"], where)
    result = {name: np.array(column, DTYPES[name]) for name, column in found.items()}
    for column in result.values():
        column.flags.writeable = False
    return result


def _check_order(episode: np.ndarray, step: np.ndarray, terminated: np.ndarray, where: Where) -> None:
    """Refuse rows that are missing or out of order: steps count up in an episode, and episodes count up."""
    goes_on = (np.diff(episode) == 0) & (np.diff(step) == 1) & (terminated[:-1] == 0)
    starts = (np.diff(episode) == 1) & (step[1:] == 0)
    good = np.concatenate([[episode[0] == 0 and step[0] == 0], goes_on | starts])
    if not good.all():
        row = int(np.argmin(good))
        before = f"after episode {episode[row - 1]:.0f}, step {step[row - 1]:.0f}" if row else "expected 0 and 0"
        before += ", which terminated" if row and terminated[row - 1] else ""
        raise ValueError(
            f"{where(row)}: episode {episode[row]:.0f}, step {step[row]:.0f} stands {before}, so rows are missing or "
            f"out of order; {REMEDY}"
        )


def to_csv(columns: Mapping[str, np.ndarray]) -> str:
    """The columns as CSV text, the same for the same numbers. A reward reads back exactly."""
    rows = zip(*(columns[name].tolist() for name in DTYPES), strict=True)
    lines = [f"{e},{t},{s},{a},{r!r},{n},{end:d}\n" for e, t, s, a, r, n, end in rows]
    return f"{HEADER}\n{''.join(lines)}"


def from_csv(text: str, source: Source, name: str) -> Columns:
    """The columns in CSV `text`; `name` of the file is for messages, where rows count from 0 and lines from 1.

    Raises ValueError that names the first bad row.
    """

    def where(row: int) -> str:
        return f"{name}, row {row} (line {row + 2})"

    header, *lines = text.split("\n")
    if header.strip() != HEADER:
        raise ValueError(f"{name}, line 1: the columns are {header[:100]!r}, expected {HEADER!r}; {REMEDY}")
    if not lines or lines.pop() != "":
        raise ValueError(f"{where(max(0, len(lines)))}: the file is cut off in the middle of this row; {REMEDY}")
    if not lines:
        raise ValueError(f"{name}: there are no rows after the header; {REMEDY}")
    n_columns = len(DTYPES)
    try:
        numbers = list(map(float, ",".join(lines).split(",")))
        table = np.array(numbers).reshape(-1, n_columns)
        regular = all(line.count(",") == n_columns - 1 for line in lines)
    except ValueError:
        regular = False
    if not regular:
        _refuse_first_bad_line(lines, where)
    return checked(dict(zip(DTYPES, table.T, strict=True)), source, where)


def _refuse_first_bad_line(lines: list[str], where: Where) -> None:
    for row, line in enumerate(lines):
        fields = line.split(",")
        if len(fields) != len(DTYPES):
            raise ValueError(f"{where(row)}: {len(fields)} columns in {line[:100]!r}, expected {len(DTYPES)}; {REMEDY}")
        for name, field in zip(DTYPES, fields, strict=True):
            if math.isnan(_number(field)) and field.strip().lower() != "nan":
                raise ValueError(f"{where(row)}: {name} is {field!r}, expected a number; {REMEDY}")


def _number(field: str) -> float:
    try:
        return float(field)
    except ValueError:
        return math.nan
