"""A course folder for nbgrader from notebooks with exercises: ``make homework``.

Of each notebook it gets the instructor's version, with solutions, and from that nbgrader itself makes the students'.
"""

from __future__ import annotations

import ast
import importlib.util
import inspect
import os
import secrets
import subprocess
import sys
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.cell import bound, handed_in_last
from rlrobot_grading.marking.marks import NO_RULES, Rules, read_rules
from rlrobot_grading.marking.rooms import room_of
from rlrobot_grading.marking.submission import exercises_of, read_submission

CONFIG = '''"""nbgrader's settings for this course. Show it to no student: from the seed come the hidden tests."""

c = get_config()  # noqa: F821
c.ClearSolutions.code_stub = {{"python": ""}}  # the blank answer stands above the solution
c.ClearSolutions.text_stub = ""
c.Autograde.sanitize_preprocessors = ["nbgrader.preprocessors.ClearOutput"]  # the Judge restores cells itself
c.Autograde.autograde_preprocessors = [
    "rlrobot_grading.marking.nbgrader_judge.Judge",
    "nbgrader.preprocessors.SaveAutoGrades",
    "nbgrader.preprocessors.AssignLatePenalties",
    "nbgrader.preprocessors.CheckCellMetadata",
]
c.Judge.seed = {seed}
c.Judge.seconds = 300.0  # for one notebook
c.Judge.memory = 4096  # for one notebook [MiB]
c.Judge.rules = {rules!r}  # a file that says what counts how much
'''
# The checks of the lessons show verdicts and never raise: without the Judge, every answer would get its points.
HIDDEN = """
### BEGIN HIDDEN TESTS
raise AssertionError("not judged: nbgrader must be run in the folder of the exported nbgrader_config.py")
### END HIDDEN TESTS"""


def export(
    notebooks: Sequence[Path],
    folder: Path,
    seed: int | None = None,
    hints: int | None = None,
    rules: str = "",
) -> list[str]:
    """Write a course folder with an assignment for each notebook; returns the assignments' names.

    folder: if it has been exported to before, its settings stay, and its assignments are made anew
    seed: of the hidden tests; drawn if not given; hints: how many an exercise shows, all if not given
    rules: path of a file that says what counts how much
    Raises ValueError for a notebook that does not fit, FileExistsError if the folder is another course's, or has a seed
    and another is given, ImportError without nbgrader, RuntimeError if nbgrader fails.
    """
    if seed is not None and seed < 0:
        raise ValueError(f"the seed must not be negative, and {seed} is")
    what_counts = read_rules(rules) if rules else NO_RULES
    sources = {path.stem: source_of(path, what_counts, hints) for path in notebooks}
    import nbformat  # is there: the notebooks have been read

    folder.mkdir(parents=True, exist_ok=True)
    _settle(
        folder / "nbgrader_config.py", seed, str(Path(rules).resolve()) if rules else ""
    )
    for name, source in sources.items():
        path = folder / "source" / name / f"{name}.ipynb"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(nbformat.writes(source) + "\n", encoding="utf-8")
    _release(folder, list(sources))
    return list(sources)


def _settle(settings: Path, seed: int | None, rules: str) -> None:
    """Write nbgrader's settings, unless there are some with a seed, and none is given."""
    if not settings.exists():
        seed = secrets.randbits(64) if seed is None else seed
        settings.write_text(CONFIG.format(seed=seed, rules=rules), encoding="utf-8")
    elif "c.Judge.seed" not in settings.read_text(encoding="utf-8"):
        raise FileExistsError(
            f"{settings} belongs to another course; choose another folder"
        )
    elif seed is not None:
        raise FileExistsError(
            f"{settings} has a seed already: change it there, or choose another folder"
        )


def source_of(path: Path, rules: Rules = NO_RULES, hints: int | None = None) -> Any:
    """The instructor's version of a notebook: of each exercise an answer, with its solution, and a test, locked.

    The answer in words is a cell that is graded by hand, with the rubric as its solution.

    Raises ValueError if it has no exercises, or if one of them has not one cell that ends with ``check.NAME(NAME)``.
    """
    submission = read_submission(path)
    if submission.problem:
        raise ValueError(f"{path}: {submission.problem}")
    exercises = exercises_of(submission.lesson)
    import nbformat  # is there: the submission has been read

    notebook = nbformat.read(path, as_version=4)
    cells, found = [], []
    for cell in notebook.cells:
        name = checked(cell)
        if name in exercises:
            cells += _answer_and_test(
                cell, name, solution_of(name, submission.lesson), rules.points_of(name)
            )
            found.append(name)
        else:
            cells.append(
                _in_words(cell, path)
                if "question" in cell.metadata.get("tags", [])
                else cell
            )
    if wrong := [name for name in exercises if found.count(name) != 1]:
        raise ValueError(
            f"{path}: one cell must end with check.{wrong[0]}({wrong[0]}), not {found.count(wrong[0])}"
        )
    notebook.cells = cells
    tell_hints(notebook, hints)
    return notebook


def tell_hints(notebook: Any, hints: int | None) -> None:
    """Have a notebook tell no more than so many hints for an exercise; None: all."""
    if hints is not None:
        import nbformat

        first = nbformat.v4.new_code_cell(f"%env RLROBOT_EDU_HINTS={hints}", id="hints")
        if notebook.nbformat_minor < 5:
            del first["id"]
        notebook.cells.insert(1, first)


def _in_words(cell: Any, path: Path) -> Any:
    """The cell of the answer in words, a point for each line of its rubric in `rubrics.md`."""
    file, answer = path.with_name("rubrics.md"), deepcopy(cell)
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    rubric = text.partition(f"\n## {path.stem}\n")[2].partition("\n## ")[0].strip()
    points = rubric.count("\n- ") + rubric.startswith("- ")
    answer.source = f"{cell.source}\n\n### BEGIN SOLUTION\n{rubric}\n### END SOLUTION"
    answer.metadata["nbgrader"] = _metadata(
        "in-words", solution=True, points=points or 1, cell_type="markdown"
    )
    return answer


def solution_of(exercise: str, lesson: str) -> str:
    """Source of an exercise's solution and of what it needs, but for other exercises, which have cells of their own."""
    room = f"rlrobot_course.{room_of(lesson)}"
    if isinstance(asked := exercises_of(lesson)[exercise], Question):
        right = (
            asked.right.tolist() if isinstance(asked.right, np.ndarray) else asked.right
        )
        return f"{exercise} = {right!r}"
    text = inspect.getsource(importlib.import_module(f"{room}.exercises"))
    defined = {
        name: line for line in ast.parse(text).body for name in bound(ast.unparse(line))
    }
    needed, ahead = [], [exercise]
    while ahead:
        line = defined[ahead.pop()]
        if line not in needed:
            needed.append(line)
            used = {node.id for node in ast.walk(line) if isinstance(node, ast.Name)}
            ahead += used & defined.keys() - exercises_of(lesson).keys()
    lines = text.splitlines()
    return "\n\n".join(
        "\n".join(lines[n.lineno - 1 : n.end_lineno])
        for n in sorted(needed, key=lambda n: n.lineno)
    )


def checked(cell: Any) -> str:
    """The exercise that a cell hands to its check in its last line; empty if it does not."""
    return handed_in_last(cell.source) if cell.cell_type == "code" else ""


def _answer_and_test(cell: Any, name: str, solution: str, points: float) -> list[Any]:
    """The two cells that nbgrader wants, from the one that a lesson has."""
    answer, test = deepcopy(cell), deepcopy(cell)
    blank = cell.source[: cell.source.rindex(f"check.{name}(")].rstrip()
    answer.source = f"{blank}\n### BEGIN SOLUTION\n{solution}\n### END SOLUTION"
    answer.metadata["nbgrader"] = _metadata(f"{name}-answer", solution=True)
    test.source = f"check.{name}({name}){HIDDEN}"
    test.metadata["nbgrader"] = _metadata(
        name, locked=True, points=points, cell_type="code"
    )
    if "id" in cell:
        test.id = f"{cell.id}-test"[-64:]
    return [answer, test]


def _metadata(
    grade_id: str, solution: bool = False, locked: bool = False, **graded: Any
) -> dict[str, Any]:
    """What nbgrader knows of a cell; graded: points and cell_type, if there are points for it."""
    kind = {
        "grade": bool(graded),
        "locked": locked,
        "solution": solution,
        "task": False,
    }
    return {"grade_id": grade_id, "schema_version": 3, **kind, **graded}


def _release(folder: Path, names: Sequence[str]) -> None:
    """Have nbgrader make the students' version of each assignment, in release/."""
    if importlib.util.find_spec("nbgrader") is None:
        raise ImportError(
            "nbgrader is not installed: run pip install 'rlrobot-edu[teach]'"
        )
    path = os.pathsep.join(
        [str(Path(sys.executable).parent), os.environ.get("PATH", "")]
    )  # it looks for alembic there
    for name in names:
        command = [
            sys.executable,
            "-m",
            "nbgrader",
            "generate_assignment",
            name,
            "--force",
        ]
        done = subprocess.run(
            command,
            cwd=folder,
            env=os.environ | {"PATH": path},
            capture_output=True,
            text=True,
        )
        if done.returncode:
            raise RuntimeError(
                f"nbgrader could not make the students' version of {name}:\n{done.stderr}"
            )
