"""Tables: rows as Python, a data frame or a spreadsheet holds them, as columns of numbers."""

import csv
import io
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.learning.transitions import Transitions

ORDER = Transitions._fields  # of the values in a row without names
WORDS = {"": math.nan, "TRUE": 1.0, "FALSE": 0.0}  # what a cell may hold but a number


class Table(NamedTuple):
    """The cells of each column, and what a message calls the whole and the row of a number."""

    columns: dict[str, Any]
    name: str
    where: Callable[[int], str]


def table_of(rows: Any) -> Table:
    """The cells of rows that Python holds. Raises ValueError if `rows` are no rows."""
    names = getattr(getattr(rows, "dtype", None), "names", None)  # a structured array
    if isinstance(rows, Mapping):
        names = rows
    elif hasattr(rows, "columns"):  # a data frame
        names = rows.columns
    try:
        if isinstance(rows, str | bytes):
            raise TypeError("its letters are not meant")
        if names is None:
            columns = _columns(list(rows))
        else:
            _check_distinct(names, "rows")
            columns = {}
            for name in names:
                columns[str(name)] = list(rows[name])
    except (TypeError, KeyError):
        kinds = "a list of dicts or tuples, an array or a data frame"
        file = "a file is read by rl.read_recording(path, task=…)"
        raise ValueError(f"rows must be {kinds}, got {_short(rows)}; {file}") from None
    lengths = {name: len(cells) for name, cells in columns.items()}
    if not lengths:
        raise ValueError("rows: there are none, expected one or more")
    if len(set(lengths.values())) > 1:
        raise ValueError(f"rows: columns must be of one length, got {lengths!s:.200}")
    return Table(columns, "rows", _place)


def _place(row: int) -> str:
    return f"row {row} (counted from 0)"


def _short(given: object) -> str:
    return " ".join(f"{given!r:.100}".split())  # in one line


def _columns(rows: list[Any]) -> dict[str, Any]:
    """The columns of dicts, or of sequences of values in the `ORDER` of a transition."""
    rows = [row._asdict() if hasattr(row, "_asdict") else row for row in rows]
    columns: dict[str, Any] = {}
    if all(isinstance(row, Mapping) for row in rows):
        names = dict.fromkeys(chain.from_iterable(rows))
        _check_distinct(names, "rows")
        for name in names:
            columns[str(name)] = [row.get(name) for row in rows]
        return columns
    width = _width(rows[0])
    for number, row in enumerate(rows):
        if _width(row) != width or not 3 <= width <= len(ORDER):
            order = f"3 to 6 values ({', '.join(ORDER)}), as many in each row"
            raise ValueError(
                f"{_place(number)} is {_short(row)}, expected a dict or {order}"
            )
    for i in range(width):
        columns[ORDER[i]] = [row[i] for row in rows]
    return columns


def _check_distinct(names: Iterable[Any], where: str) -> None:
    """Raises ValueError if two columns have the same name, as a text."""
    for title, times in Counter(map(str, names)).items():
        if times > 1:
            expected = "expected a name of its own for each column, such as s, a and r"
            raise ValueError(f"{where}: {title!r:.100} stands twice, {expected}")


def _width(row: Any) -> int:
    """How many values a row has; 0 if it is no sequence of values."""
    is_sequence = isinstance(row, list | tuple) or np.ndim(row) == 1
    return len(row) if is_sequence else 0


def read_table(path: Path) -> Table:
    """The cells of a CSV file as spreadsheets write it. Raises ValueError if it is none.

    Columns are separated by commas, semicolons or tabs; unless by commas, a number may have a decimal comma. Line 1
    names the columns, and one without a name is not read. Empty lines at the end are left out.
    """
    name = " ".join(str(path).split())  # in one line
    if not path.is_file():
        raise FileNotFoundError(f"{name}: there is no such file")
    text = path.read_text(encoding="utf-8-sig", errors="replace")
    header = text.partition("\n")[0]
    separator = max(",;\t", key=header.count)
    if separator != ",":
        text = text.replace(",", ".")
    reader = csv.reader(io.StringIO(text), delimiter=separator)
    try:
        lines = [(reader.line_num, cells) for cells in reader]
    except csv.Error as error:
        fault = f"{name}, line {reader.line_num}: {error}"
        raise ValueError(f"{fault}; save it as CSV again") from None
    while lines and not "".join(lines[-1][1]).strip():
        lines.pop()
    if not lines:
        raise ValueError(f"{name}: it is empty, expected names of columns and rows")
    titles = [cell.strip() for cell in lines.pop(0)[1]]
    for number, cells in lines:
        if "".join(cells[len(titles) :]).strip():
            fault = f"{len(cells)} cells, expected {len(titles)} as in line 1"
            advice = "with decimal commas, columns are separated by semicolons"
            raise ValueError(f"{name}, line {number}: {fault}; {advice}")
        cells += [""] * (len(titles) - len(cells))
    _check_distinct(filter(None, titles), f"{name}, line 1")
    columns: dict[str, Any] = {}
    for i, title in enumerate(titles):
        if title:
            columns[title] = [cells[i] for _, cells in lines]
    return Table(
        columns, f"{name}, line 1", lambda row: f"{name}, line {lines[row][0]}"
    )


def in_numbers(table: Table) -> Table:
    """Each cell as a float, NaN if it is empty. Raises ValueError for the first that is no number."""
    columns = {}
    for name, cells in table.columns.items():
        numbers = np.zeros(len(cells))
        for row, cell in enumerate(cells):
            try:
                numbers[row] = _number(cell)
            except (TypeError, ValueError, OverflowError):
                fault = f"{name} is {_short(cell)}, expected a number; correct it"
                raise ValueError(f"{table.where(row)}: {fault}") from None
        columns[name] = numbers
    return table._replace(columns=columns)


def _number(cell: Any) -> float:
    if cell is None:
        return math.nan
    if isinstance(cell, np.complexfloating):
        raise TypeError("float() would only warn, and drop a part")
    if not isinstance(cell, str):
        return float(cell)
    text = cell.strip().upper()
    return WORDS[text] if text in WORDS else float(text)
