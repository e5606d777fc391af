"""Notebooks to hand out, which differ from student to student, and their solutions: ``rlrobot-edu hand-out``."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_course.homework import COURSE
from rlrobot_edu.files import shipped
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.cell import bound, exercise_in_last_line
from rlrobot_grading.marking.students import read_students
from rlrobot_grading.marking.submission import read_submission
from rlrobot_grading.marking.variants import Variant, replaced, variant_of

NOTEBOOKS = shipped("notebooks") / "homework"
USE_VARIANT = (
    "from rlrobot_course.homework import use_variant\n\nuse_variant(check, {student!r})"
)


def hand_out(
    students: str,
    notebooks: Sequence[str | Path] = (),
    to: str | Path = "handed_out",
    hints: int | None = None,
) -> int:
    """Write each student's notebooks into students/, and their solutions into solutions/.

    Parameters
    ----------
    students : str
        Path of the list of students.
    notebooks : sequence of paths
        All assignments if there are none.
    to : path
        The folder that gets students/ and solutions/.
    hints : int, optional
        How many an exercise shows; all if not given.

    Returns
    -------
    int
        How many students there are.

    Raises
    ------
    ValueError
        If a notebook has no exercises, or an id cannot be part of a file's name.
    OSError
        If something cannot be read or written.
    """
    import nbformat

    ids = [student.id for student in read_students(students)]
    for id in ids:
        if not re.fullmatch(r"\w[\w.@-]*", id):
            raise ValueError(
                f"{students}: the id {id!r} cannot be part of a file's name: use letters, digits and . @ _ -"
            )
    for path in map(Path, notebooks or sorted(NOTEBOOKS.glob("*.ipynb"))):
        submission = read_submission(COURSE, path)
        if submission.problem:
            raise ValueError(f"{path}: {submission.problem}")
        notebook = nbformat.read(path, as_version=4)
        for id in ids:
            variant = variant_of(COURSE, submission.lesson, id)
            blank = notebook_of(notebook, variant, id)
            solved = notebook_of(notebook, variant, id, submission.lesson)
            for folder, copy in (("students", blank), ("solutions", solved)):
                show_hints(copy, hints)
                file = Path(to, folder, id, f"{path.stem}_{id}.ipynb")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(nbformat.writes(copy) + "\n", encoding="utf-8")
    return len(ids)


def notebook_of(
    notebook: Any, variant: Variant, student: str, solved_of: str = ""
) -> Any:
    """Return a notebook as a student gets it; `solved_of`: the lesson whose solutions are put into it, if any."""
    copy = deepcopy(notebook)
    for cell in copy.cells:
        cell.source = variant.text(cell.source)
        if cell.cell_type != "code":
            continue
        cell.outputs, cell.execution_count = [], None
        name = exercise_in_last_line(cell.source)
        if re.search(r"^from \S+ import check$", cell.source, re.MULTILINE):
            cell.source += f"\n{USE_VARIANT.format(student=student)}"
        elif solved_of and name in variant.exercises:
            solution = _solution(variant, name, solved_of)
            cell.source = f"{solution}\n\n\ncheck.{name}({name})"
    return copy


def show_hints(notebook: Any, hints: int | None) -> None:
    """Have a notebook show no more than so many hints for an exercise; None: all."""
    if hints is None:
        return
    import nbformat

    first = nbformat.v4.new_code_cell(f"%env RLROBOT_EDU_HINTS={hints}", id="hints")
    if notebook.nbformat_minor < 5:
        del first["id"]
    notebook.cells.insert(1, first)


def _solution(variant: Variant, name: str, lesson: str) -> str:
    exercise = variant.exercises[name]
    if isinstance(exercise, Question):
        right = exercise.right
        if isinstance(right, np.ndarray):
            right = right.tolist()
        return f"{name} = {right!r}"
    return replaced(solution_of(name, lesson), variant.changes)


def solution_of(name: str, lesson: str) -> str:
    """Return the source of an exercise's solution, with all that it needs but other exercises."""
    module = importlib.import_module(f"{COURSE.module_of(lesson)}.exercises")
    text = inspect.getsource(module)
    defined = {}
    for statement in ast.parse(text).body:
        for bound_name in bound(ast.unparse(statement)):
            defined[bound_name] = statement
    others = defined.keys() - COURSE.exercises_of(lesson).keys()
    needed: list[ast.stmt] = []
    ahead = [name]
    while ahead:
        statement = defined[ahead.pop()]
        if statement in needed:
            continue
        needed.append(statement)
        used = {node.id for node in ast.walk(statement) if isinstance(node, ast.Name)}
        ahead += used & others
    needed.sort(key=lambda statement: statement.lineno)
    lines = text.splitlines()
    parts = [lines[one.lineno - 1 : one.end_lineno] for one in needed]
    return "\n\n".join("\n".join(part) for part in parts)
