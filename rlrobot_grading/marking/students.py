"""The students of a class, from a CSV file with a column `id`, and perhaps `name` and `late`."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Mapping
from dataclasses import dataclass

from rlrobot_grading.marking.text import text_of

SEPARATORS = ",;\t"
ROUNDED = re.compile(r"\d[.,]\d+E\+\d+")  # what a spreadsheet makes of a long number


@dataclass(frozen=True)
class Student:
    """One line of the list; late: days after the day on which the assignment was due."""

    id: str = ""
    name: str = ""
    late: float = 0.0


NOBODY = Student()


def read_students(path: str) -> list[Student]:
    """Read a list of students, whose cells commas, semicolons or tabs separate.

    Raises OSError, or ValueError if there is no column `id`, no student, an id is missing or there twice, or `late` is
    no number of days.
    """
    lines = text_of(path).splitlines()
    if not lines:
        raise ValueError(
            f"{path} is empty; its first line names the columns, as id,name,late"
        )
    separator = max(SEPARATORS, key=lines[0].count)
    students: dict[str, Student] = {}
    try:
        reader = csv.DictReader(io.StringIO("\n".join(lines)), delimiter=separator)
        names = [name.strip().lower() for name in reader.fieldnames or ()]
        if "id" not in names:
            raise ValueError(
                f"{path}: there is no column id; the first line names the columns, as id,name,late"
            )
        reader.fieldnames = names
        for row in reader:
            where = f"{path}, line {reader.line_num}"
            student = _student(where, row)
            if student is None:
                continue
            if student.id.lower() in students:
                raise ValueError(f"{where}: the id {student.id} is there twice")
            students[student.id.lower()] = student
    except csv.Error as error:
        raise ValueError(f"{path}: this is no CSV file ({error})") from None
    if not students:
        raise ValueError(f"{path}: there is no student in it")
    return list(students.values())


def _student(where: str, row: Mapping[str | None, object]) -> Student | None:
    """Return the student of a line; None if the line is empty."""
    if any(row.get(None) or ()):
        raise ValueError(f"{where}: it has more cells than the first line has columns")
    cells = {name: str(cell or "").strip() for name, cell in row.items() if name}
    if not any(cells.values()):
        return None
    id = cells["id"]
    if ROUNDED.fullmatch(id):
        raise ValueError(
            f"{where}: a spreadsheet has rounded the id {id}: format the column as text"
        )
    try:
        late = float(cells.get("late", "").replace(",", ".") or 0)
    except ValueError:
        late = -1.0
    if not id or not 0 <= late < 1e4:
        raise ValueError(
            f"{where}: a student has an id, and late is a number of days from 0 on"
        )
    return Student(id, cells.get("name", ""), late)
