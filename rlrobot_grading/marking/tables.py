"""Points as tables: a plain one, and those that Canvas, Moodle and Gradescope take in."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from rlrobot_grading.marking.marks import Marked
from rlrobot_grading.marking.rooms import room_of

Rows = list[list[Any]]
CANVAS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")


def table_for(system: str, marked: Sequence[Marked]) -> str:
    """The points as CSV for a system of `TABLES`; what was not graded has empty cells, not 0 points."""
    return as_csv(TABLES[system](marked))


def as_csv(rows: Iterable[Iterable[Any]]) -> str:
    """Rows as CSV, in which a spreadsheet takes no text for a formula."""
    file = io.StringIO()
    csv.writer(file, lineterminator="\n").writerows(
        [_cell(cell) for cell in row] for row in rows
    )
    return file.getvalue()


def _cell(cell: Any) -> str:
    if isinstance(cell, str):
        return f"'{cell}" if cell[:1] in ("=", "+", "-", "@") else cell
    return f"{cell:g}"


def _plain(marked: Sequence[Marked]) -> Rows:
    """A line for each student: the notebook, all its points, why some are missing, and what came off for being late."""
    graded = [one for one in marked if not one.problem]
    columns = list(
        dict.fromkeys(
            f"{one.lesson}:{score.exercise}" for one in graded for score in one.scores
        )
    )
    head = [
        "student",
        "notebook",
        "lesson",
        "score",
        "max_score",
        *columns,
        "days_late",
        "off",
        "reasons",
        "notes",
    ]
    rows: Rows = [head]
    for one in marked:
        points = {
            f"{one.lesson}:{score.exercise}": score.score
            for score in one.scores
            if not one.problem
        }
        cells = [points.get(column, "") for column in columns]
        first = [
            one.student.id,
            one.name,
            one.lesson,
            _points(one),
            one.max_score if one.lesson else "",
        ]
        rows.append(
            [
                *first,
                *cells,
                one.student.late,
                one.off,
                reasons(one),
                " ".join(one.notes),
            ]
        )
    return rows


def _points(one: Marked) -> float | str:
    return "" if one.problem else one.score


def reasons(one: Marked) -> str:
    """Why points are missing, or were given although another answer is wrong, in a line."""
    if one.problem:
        return f"not graded: {one.problem}"
    told = [f"{score.exercise}: {score.reason}" for score in one.scores if score.reason]
    told += [
        f"{score.exercise}: judged with the right {score.lent}"
        for score in one.scores
        if score.lent
    ]
    return "; ".join(
        told + [f"{one.student.late:g} days late: {one.off:g} off"] * bool(one.off)
    )


def _canvas(marked: Sequence[Marked]) -> Rows:
    """Canvas's gradebook: a column for each lesson, below the heading the points that there are."""
    possible = {one.lesson: one.max_score for one in marked if one.lesson}
    rows = [
        [*CANVAS, *map(_title, possible)],
        ["Points Possible", "", "", "", "", *possible.values()],
    ]
    by_student = {one.student.id: one.student for one in marked if one.student.id}
    points = {(one.student.id, one.lesson): _points(one) for one in marked}
    for student in by_student.values():
        known = {"Student": student.name, "ID": student.id} | dict(student.row)
        rows.append(
            [
                *(known.get(column) or "" for column in CANVAS),
                *(points.get((student.id, n), "") for n in possible),
            ]
        )
    return rows


def _moodle(marked: Sequence[Marked]) -> Rows:
    """Moodle's import of grades: a column to map students by, and for each lesson a grade with feedback.

    That column is the ID number; Moodle's number of the participant if the list of students has that.
    """
    lessons = list(dict.fromkeys(one.lesson for one in marked if one.lesson))
    titles = [
        title
        for lesson in lessons
        for title in (_title(lesson), f"{_title(lesson)} feedback")
    ]
    told: dict[str, dict[str, list[Any]]] = {}
    for one in marked:
        if one.student.id:
            told.setdefault(one.student.id, {})[one.lesson] = [
                _points(one),
                reasons(one),
            ]
    students = {one.student.id: one.student for one in marked}
    numbered = any(student.number for student in students.values())
    return [
        [
            "Identifier" if numbered else "ID number",
            "Full name",
            "Email address",
            *titles,
        ]
    ] + [
        [
            students[id].number or id,
            students[id].name,
            students[id].email,
            # why there is no notebook, or none whose lesson is known, stands with every lesson
            *(cell for n in lessons for cell in of.get(n) or of.get("") or ["", ""]),
        ]
        for id, of in told.items()
    ]


def _gradescope(marked: Sequence[Marked]) -> Rows:
    """Gradescope's table of scores, as it exports it itself, with the questions numbered."""
    graded = [one for one in marked if not one.problem]
    names = dict.fromkeys(
        (score.exercise, score.max_score) for one in graded for score in one.scores
    )
    titles = [
        f"{i}: {name} ({points:g} pts)"
        for i, (name, points) in enumerate(names, start=1)
    ]
    rows: Rows = [
        [
            "Name",
            "SID",
            "Email",
            "Total Score",
            "Max Points",
            "Lateness (H:M:S)",
            *titles,
        ]
    ]
    for one in marked:
        if one.student.id:
            points = {
                score.exercise: score.score for score in one.scores if not one.problem
            }
            late = f"{round(24 * one.student.late):02d}:00:00"
            first = [
                one.student.name,
                one.student.id,
                one.student.email,
                _points(one),
                one.max_score,
                late,
            ]
            rows.append([*first, *(points.get(name, "") for name, _ in names)])
    return rows


def _title(lesson: str) -> str:
    return room_of(lesson).replace("_", " ")


TABLES: dict[str, Callable[[Sequence[Marked]], Rows]] = {
    "plain": _plain,
    "canvas": _canvas,
    "moodle": _moodle,
    "gradescope": _gradescope,
}
