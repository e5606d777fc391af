"""Answers that are alike to the token, in the notebooks of several students."""

from __future__ import annotations

import ast
import csv
import inspect
import io
import textwrap
from collections import defaultdict
from collections.abc import Sequence

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.homework.cell import defined_in
from rlrobot_edu.course.homework.submission import Submission, exercises_of

SHORTEST = 25  # parts of the syntax tree; shorter answers are often alike by themselves


def alike(submissions: Sequence[Submission]) -> str:
    """CSV: a line for each answer that stands in several notebooks, alike but for spaces, comments and docstrings.

    Also said is whether it is alike to the solution that ships with the course: then it tells nothing of the others.
    """
    found: dict[tuple[str, str, str], list[str]] = defaultdict(list)
    for one in submissions:
        for exercise, places in one.answered_in.items():
            for line in [defined_in(one.cells[place], exercise) for place in places][-1:]:
                if line is not None and len(list(ast.walk(line))) >= SHORTEST:
                    found[one.lesson, exercise, _bare(line)].append(one.name)
    file = io.StringIO()
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["lesson", "exercise", "alike in", "alike to the course's solution", "notebooks"])
    for (lesson, exercise, text), names in sorted(found.items(), key=lambda item: -len(item[1])):
        if len(names) > 1:
            known = exercises_of(lesson)[exercise]
            shipped = isinstance(known, Exercise) and text == _bare(_definition(known))
            table.writerow([lesson, exercise, len(names), "yes" if shipped else "no", " ".join(names)])
    return file.getvalue()


def _definition(exercise: Exercise) -> ast.stmt:
    return ast.parse(textwrap.dedent(inspect.getsource(exercise.right))).body[0]


def _bare(line: ast.stmt) -> str:
    """The syntax of a definition, without docstring and annotations of types."""
    if isinstance(line, ast.FunctionDef) and ast.get_docstring(line) is not None:
        line.body = line.body[1:]
    return ast.dump(line)
