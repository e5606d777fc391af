"""Grades as a text, as a sheet for each student, and as Gradescope's ``results.json``."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Mapping
from datetime import date
from pathlib import Path

from rlrobot_course.homework.marks import Marked, Score
from rlrobot_course.homework.rooms import room_of


def as_text(one: Marked) -> str:
    """What a terminal shows of one notebook: points, and of each exercise what there is to say."""
    where = f" ({_title(one)})" * bool(one.lesson)
    if one.problem:
        return "\n".join([f"{one.name}: not graded{where}", f"  {one.problem}", *_notes(one)])
    lines = [f"{one.name}: {one.score:g} of {one.max_score:g} points{where}"]
    for score in one.scores:
        lines.append(f"  {score.exercise:<20} {score.score:g}/{score.max_score:g}")
        if score.score < score.max_score or score.lent:
            lines.append(textwrap.indent(_said(score), "      "))
    if one.off:
        lines.append(f"  {one.student.late:g} days late: {one.off:g} points off")
    return "\n".join(lines + _notes(one))


def _notes(one: Marked) -> list[str]:
    return [f"  Note: {note}" for note in one.notes if note != one.problem]


def _said(score: Score) -> str:
    return "Not answered yet." if score.is_blank else score.output


def _title(one: Marked) -> str:
    return room_of(one.lesson).replace("_", " ")


def as_sheet(one: Marked, sections: Mapping[str, str], day: date) -> str:
    """What a student gets back, in Markdown: the points, and for each that is missing why, and where to look again.

    sections: the heading under which each exercise stands in the notebook, by its name; day: of the grading
    """
    id = one.student.id or Path(one.name).stem
    student = f"{one.student.name} ({id})" if one.student.name else id
    title = f"{student}, {_title(one)}" if one.lesson else student
    graded = f"`{Path(one.name).name}`, graded on {day.isoformat()}."
    if one.problem:
        again = "Save it again in Jupyter, as a file that ends in .ipynb, and hand that in."
        return "\n".join([f"# {title}: not graded", "", graded, "", one.problem, "", again, ""])
    lines = [f"# {title}: {one.score:g} of {one.max_score:g} points", "", graded, ""]
    if one.off:
        points = f"{one.score + one.off:g} points for the answers"
        lines += [f"{points}; {one.student.late:g} days late: {one.off:g} points off.", ""]
    for score in one.scores:
        if not score.max_score:
            lines += [f"- `{score.exercise}`: does not count", ""]
        elif score.score == score.max_score:
            lent = f", with the right `{score.lent}` in place of yours" * bool(score.lent)
            lines += [f"- `{score.exercise}`: right{lent}", ""]
        elif score.is_blank:
            lines += [f"- `{score.exercise}`: not answered yet, 0 of {score.max_score:g}", ""]
        else:
            points = f"## `{score.exercise}`: {score.score:g} of {score.max_score:g}"
            lines += [points, "", "```text", score.output, "```", ""]
            if score.exercise in sections:
                lines += [f"To look at again: *{sections[score.exercise]}*, in your notebook.", ""]
    return "\n".join(lines)


def as_gradescope(one: Marked) -> str:
    """Gradescope's ``results.json``: a visible test for each exercise, and what only the instructor should see."""
    tests = [
        {"name": score.exercise, "score": score.score, "max_score": score.max_score, "output": score.output,
         "status": "passed" if score.score == score.max_score else "failed", "visibility": "visible"}
        for score in one.scores
    ]  # fmt: skip
    if one.notes:
        tests.append(
            {"name": "notes for the instructor", "score": 0.0, "max_score": 0.0, "output": "\n".join(one.notes),
             "visibility": "hidden"}
        )  # fmt: skip
    return json.dumps({"score": one.score, "tests": tests}, indent=1, ensure_ascii=False) + "\n"
