"""A notebook for each student, with cases, constants and worlds of their own, and for the instructor its solutions."""

from __future__ import annotations

import re
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any

from rlrobot_course.grading.question import Question
from rlrobot_course.homework.nbgrader_course import checked, solution_of, tell_hints
from rlrobot_course.homework.own import Variant, replaced, variant_of
from rlrobot_course.homework.students import read_students
from rlrobot_course.homework.submission import read_submission

OWN = "from rlrobot_course.homework.own import own\n\nown(check, {student!r})"


def export_each(notebooks: Sequence[Path], folder: Path, roster: str, hints: int | None = None) -> int:
    """Write each student's notebooks into students/, and their solutions into solutions/; returns how many students.

    roster: path of the list of students; hints: how many are told for an exercise, all if not given
    Raises ValueError if a notebook has no exercises, or an id cannot be part of a file's name; OSError.
    """
    import nbformat

    students = [student.id for student in read_students(roster)]
    if wrong := [student for student in students if not re.fullmatch(r"\w[\w.@-]*", student)]:
        raise ValueError(f"{roster}: the id {wrong[0]!r} cannot be part of a file's name: letters, digits, . @ _ -")
    for path in notebooks:
        submission = read_submission(path)
        if submission.problem:
            raise ValueError(f"{path}: {submission.problem}")
        notebook = nbformat.read(path, as_version=4)
        for student in students:
            variant = variant_of(submission.lesson, student)
            for room, solved in (("students", False), ("solutions", True)):
                copy = own_copy(notebook, variant, student, submission.lesson if solved else "")
                tell_hints(copy, hints)
                to = folder / room / student / f"{path.stem}_{student}.ipynb"
                to.parent.mkdir(parents=True, exist_ok=True)
                to.write_text(nbformat.writes(copy) + "\n", encoding="utf-8")
    return len(students)


def own_copy(notebook: Any, variant: Variant, student: str, solved_of: str = "") -> Any:
    """A notebook as a student gets it; `solved_of`: the lesson whose solutions are put into it; none if empty."""
    copy = deepcopy(notebook)
    for cell in copy.cells:
        cell.source = variant.text(cell.source)
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
            name = checked(cell)
            if re.search(r"^from \S+ import check$", cell.source, re.MULTILINE):
                cell.source += f"\n{OWN.format(student=student)}"
            elif solved_of and name in variant.exercises:
                cell.source = f"{_solution(variant, name, solved_of)}\n\n\ncheck.{name}({name})"
    return copy


def _solution(variant: Variant, name: str, lesson: str) -> str:
    exercise = variant.exercises[name]
    if isinstance(exercise, Question):
        return f"{name} = {exercise.right!r}"
    return replaced(solution_of(name, lesson), variant.changes)
