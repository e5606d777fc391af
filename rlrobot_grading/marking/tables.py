"""Points as a CSV table, with a line for each student."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

from rlrobot_grading.marking.marks import Marked

FORMULA = ("=", "+", "-", "@")  # a text that begins so, a spreadsheet computes


def as_csv(rows: Iterable[Iterable[Any]]) -> str:
    """Return rows as CSV, in which a spreadsheet takes no text for a formula."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    for row in rows:
        writer.writerow([_cell(cell) for cell in row])
    return file.getvalue()


def _cell(cell: Any) -> str:
    if not isinstance(cell, str):
        return f"{cell:g}"
    return f"'{cell}" if cell.startswith(FORMULA) else cell


def points_table(marked: Sequence[Marked]) -> str:
    """Return the points as CSV; what was not graded has empty cells, not 0 points."""
    columns: dict[str, None] = {}
    for one in marked:
        if not one.problem:
            columns |= dict.fromkeys(_points(one))
    first = ["id", "name", "notebook", "lesson", "score", "max_score"]
    last = ["days_late", "off", "reasons", "notes"]
    rows: list[list[Any]] = [[*first, *columns, *last]]
    for one in marked:
        points = {} if one.problem else _points(one)
        rows.append(
            [
                one.student.id,
                one.student.name,
                one.name,
                one.lesson,
                "" if one.problem else one.score,
                one.max_score if one.lesson else "",
                *[points.get(column, "") for column in columns],
                one.student.late,
                one.off,
                reasons(one),
                " ".join(one.notes),
            ]
        )
    return as_csv(rows)


def _points(one: Marked) -> dict[str, float]:
    """Return the points of each exercise by the name of its column."""
    return {f"{one.lesson}:{score.exercise}": score.score for score in one.scores}


def reasons(one: Marked) -> str:
    """Return in a line why points are missing, or were given although another answer is wrong."""
    if one.problem:
        return f"not graded: {one.problem}"
    parts = [
        f"{score.exercise}: {score.reason}" for score in one.scores if score.reason
    ]
    for score in one.scores:
        if score.substituted:
            parts.append(f"{score.exercise}: judged with the right {score.substituted}")
    if one.off:
        parts.append(f"{one.student.late:g} days late: {one.off:g} off")
    return "; ".join(parts)
