"""Whose notebook it is: by a list of students, or by the file's name alone."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

# What a column is called: in a list of one's own, and in those that Canvas, Moodle and Gradescope export
COLUMNS = {
    "id": ("id", "sid", "student id", "id number"),
    "name": ("name", "student", "full name"),
    "email": ("email", "email address"),
    "late": ("late", "days late"),
}


@dataclass(frozen=True)
class Student:
    """One line of the list; late: days after the day on which the assignment was due; row: all columns."""

    id: str = ""
    name: str = ""
    email: str = ""
    late: float = 0.0
    row: Mapping[str, str] = field(default_factory=dict, compare=False)


NOBODY = Student()


def read_students(path: str) -> list[Student]:
    """The students of a CSV file with a column id, and perhaps name, email, late.

    Raises OSError, or ValueError if ids are missing or double, or if days are no numbers.
    """
    students = []
    with Path(path).open(encoding="utf-8-sig", newline="") as file:
        for line, row in enumerate(csv.DictReader(file), start=2):
            by_name = {str(name).strip().lower(): (text or "").strip() for name, text in row.items()}
            told = {of: next((by_name[n] for n in names if n in by_name), "") for of, names in COLUMNS.items()}
            if not told["id"] and told["name"].lower() in ("", "points possible"):
                continue  # an empty line, or Canvas's own below the heading
            try:
                late = float(told["late"] or 0)
            except ValueError:
                late = -1.0
            if not told["id"] or not 0 <= late < 1e4:
                raise ValueError(f"{path}, line {line}: a student has an id, and late is a number of days from 0 on")
            students.append(Student(told["id"], told["name"], told["email"], late, row))
    double = [name for name, n in Counter(student.id.lower() for student in students).items() if n > 1]
    if double or not students:
        raise ValueError(f"{path}: {f'the id {double[0]} is there twice' if double else 'there is no student in it'}")
    return students


def students_of(paths: Sequence[Path], students: Sequence[Student]) -> list[Student]:
    """Whose notebooks these are: the student whose id is in a file's name, or in that of a folder, the nearest first.

    If there is no list, the id is the name of the file, or of its folder if several files have the same name.
    Raises ValueError if nobody's id, or that of two, is in a name.
    """
    if students:
        return [_student_of(path, students) for path in paths]
    differ = len({path.stem for path in paths}) == len(paths)
    return [Student(path.stem if differ else path.parent.name) for path in paths]


def _student_of(path: Path, students: Sequence[Student]) -> Student:
    for part in reversed(path.parts):
        found = [
            one for one in students if re.search(rf"(?<![^\W_]){re.escape(one.id)}(?![^\W_])", part, re.IGNORECASE)
        ]
        if len(found) > 1:
            raise ValueError(f"{path}: the ids {found[0].id} and {found[1].id} are both in its name")
        if found:
            return found[0]
    raise ValueError(f"{path}: no id of a student is in its name, nor in that of a folder around it")
