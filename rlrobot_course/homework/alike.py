"""Answers that are alike to the token, in the notebooks of several students."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections import defaultdict
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.homework.cell import defined_in
from rlrobot_course.homework.submission import Submission, exercises_of
from rlrobot_course.homework.tables import as_csv

SHORTEST = 25  # parts of the syntax tree; shorter answers are often alike by themselves


def alike(submissions: Sequence[Submission]) -> str:
    """CSV: a line for each answer that stands in several notebooks, alike but for spaces, comments and docstrings.

    Also said is whether it is alike to the solution that ships with the course: then it tells nothing of the others.
    """
    found: dict[tuple[str, str, str], list[str]] = defaultdict(list)
    for one in submissions:
        for exercise in one.answered_in:
            with suppress(RecursionError):  # of brackets in brackets
                line = _definition(one, exercise)
                if line is not None and len(list(ast.walk(line))) >= SHORTEST:
                    found[one.lesson, exercise, _bare(line)].append(one.name)
    rows: list[list[Any]] = [["lesson", "exercise", "alike in", "alike to the course's solution", "notebooks"]]
    for (lesson, exercise, text), names in sorted(found.items(), key=lambda item: -len(item[1])):
        if len(names) > 1:
            known = exercises_of(lesson)[exercise]
            shipped = isinstance(known, Exercise) and text == _bare(_solution(known))
            rows.append([lesson, exercise, len(names), "yes" if shipped else "no", " ".join(names)])
    return as_csv(rows)


def _definition(one: Submission, exercise: str) -> ast.stmt | None:
    """What the judge is given: the last definition that is not blank, not behind the last cell that hands it in.

    It may stand in another cell than the call of its check; behind it only if none does before.
    """
    end = 1 + max(one.answered_in[exercise], default=-1)
    lines = (defined_in(source, exercise) for source in [*one.cells[end:], *one.cells[:end]][::-1])
    return next((line for line in lines if line is not None and not _is_blank(line)), None)


def _is_blank(line: ast.stmt) -> bool:
    """Whether a definition is still as the notebook hands it out, with ``...`` for the answer."""
    values = [node.value for node in ast.walk(line) if isinstance(node, ast.Expr | ast.Return | ast.Assign)]
    return any(isinstance(value, ast.Constant) and value.value is ... for value in values)


def _solution(exercise: Exercise) -> ast.stmt:
    return ast.parse(textwrap.dedent(inspect.getsource(exercise.right))).body[0]


def _bare(line: ast.stmt) -> str:
    """The syntax of a definition, without its docstring."""
    if isinstance(line, ast.FunctionDef) and ast.get_docstring(line) is not None:
        line.body = line.body[1:]
    return ast.dump(line)
