"""A submitted notebook: which lesson it belongs to, and which of its code cells answer which exercise."""

from __future__ import annotations

import ast
import importlib
import json
import re
from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.cell import (
    bound,
    calls_in,
    handed_in,
    lessons_imported,
    made_for,
    tree,
)
from rlrobot_grading.marking.rooms import LESSONS, room_of
from rlrobot_grading.marking.text import INVISIBLE, text_of

LARGEST = 256 * 2**20  # notebook that is read, its outputs included [bytes]
KINDS = (
    ".ipynb",
    ".py",
    ".json",
    ".txt",
)  # of files: a script is exported; browsers name some the last two
# Where a cell begins in an exported script: of Jupyter; of VS Code, Spyder and Jupytext; of Databricks
MARK = re.compile(r"^# (?:In ?\[[ \d]*\]:|%%.*|COMMAND -+)$", re.MULTILINE)


class Cell(NamedTuple):
    """A cell of a notebook; kind: code, markdown, or another that does not count."""

    kind: str
    source: str


@dataclass
class Submission:
    """One notebook as it was handed in.

    name: of its file; cells: source of its code cells, in their order
    lesson: its number, or assignment_1 and so on; empty if unknown
    answered_in: for each exercise of the lesson, the places in `cells` that hand the answer to its check; where none
        does, those that define it, or at least name it and cannot be read
    defined_in: the places that define it
    problem: why it cannot be run, if it cannot
    made_for: the number of the student whose variant it is; empty if it is nobody's
    """

    name: str
    lesson: str = ""
    cells: list[str] = field(default_factory=list)
    answered_in: dict[str, list[int]] = field(default_factory=dict)
    defined_in: dict[str, list[int]] = field(default_factory=dict)
    problem: str = ""
    made_for: str = ""

    @property
    def last_cell(self) -> int:
        """How many cells are run: what comes after the last answer is not judged."""
        if not all(self.answered_in.values()):
            return len(
                self.cells
            )  # an answer may be handed in by a way that cannot be read off
        found = [*self.answered_in.values(), *self.defined_in.values()]
        return 1 + max((i for places in found for i in places), default=-1)

    @cached_property
    def _calls(self) -> dict[str, set[str]]:
        return calls_in(self.cells)

    def called_by(self, name: str) -> set[str]:
        """What stands in the definitions of a name, and in those of all that stands there."""
        called, ahead = {name}, [name]
        while ahead:
            new = self._calls.get(ahead.pop(), set()) - called
            called |= new
            ahead += new
        return called

    def answered_by(self, place: int, left_out: Collection[int]) -> list[str]:
        """The exercises that a definition in this cell answers: as far as can be read, no later cell hands them in."""
        later = [
            self.cells[i]
            for i in range(place + 1, len(self.cells))
            if i not in left_out
        ]
        handed = set().union(*(handed_in(source) for source in later))
        return [name for name in self.answered_in if name not in handed]


def exercises_of(lesson: str) -> dict[str, Exercise | Question]:
    """The exercises of a lesson by name, in the order of its notebook. Raises ValueError if there are none."""
    if lesson not in LESSONS:
        raise ValueError(
            f"there are no exercises in a lesson {lesson!r}; the lessons with some are {', '.join(LESSONS)}"
        )
    room = f"rlrobot_course.{room_of(lesson)}"
    checks = vars(importlib.import_module(f"{room}.exercises").check)
    return {
        name: one
        for name, one in checks.items()
        if isinstance(one, Exercise | Question)
    }


def read_submission(path: Path, lesson: str = "") -> Submission:
    """Read a notebook; never raises for what is in it. `lesson`: its number, if it is not to be looked for."""
    name = str(path)
    try:
        cells = [cell.source for cell in cells_of(path) if cell.kind == "code"]
        problem = "" if cells else "There is no code cell in it."
    except OSError as error:
        cells, problem = [], f"It cannot be read: {error.strerror}."
    except ValueError as error:
        cells, problem = (
            [],
            f"This is not a notebook that can be read ({one_line(str(error), 120)}).",
        )
    except Exception:  # of a file that is no notebook anything may be the matter
        cells, problem = (
            [],
            "This is not a notebook that can be read (it has no cells where a notebook has them).",
        )
    lesson = lesson or _lesson_of(path, cells)
    if not lesson:
        why = "It cannot be told which lesson this notebook belongs to: no cell imports the check of a lesson."
        return Submission(name, problem=problem or why)
    exercises = exercises_of(lesson)
    defined = {
        name: [i for i, source in enumerate(cells) if name in bound(source)]
        for name in exercises
    }
    handing = {
        name: [i for i, source in enumerate(cells) if name in handed_in(source)]
        for name in exercises
    }
    answered = {
        name: handing[name] or defined[name] or _named_in(name, cells)
        for name in exercises
    }
    student = next(filter(None, map(made_for, cells)), "")
    return Submission(name, lesson, cells, answered, defined, problem, student)


def sections_of(path: Path) -> dict[str, str]:
    """The heading under which each exercise is checked in a notebook, by its name; empty where it cannot be read."""
    sections: dict[str, str] = {}
    heading = ""
    with suppress(Exception):  # it may be no notebook
        for cell in cells_of(path):
            if cell.kind == "markdown":
                headings = [
                    line.strip("# ")
                    for line in cell.source.splitlines()
                    if line.startswith("#")
                ]
                heading = headings[-1] if headings else heading
            elif cell.kind == "code" and heading:
                for name in handed_in(cell.source):
                    sections.setdefault(
                        name, heading
                    )  # it may be checked again, below the summary, say
    return sections


def _named_in(exercise: str, cells: Sequence[str]) -> list[int]:
    """Cells that cannot be read, but name the exercise: to tell why it is not answered."""
    word = re.compile(rf"\b{exercise}\b")
    return [
        i
        for i, source in enumerate(cells)
        if word.search(source) and tree(source) is None
    ]


def cells_of(path: Path) -> list[Cell]:
    """The cells of a notebook in any of Jupyter's formats, or of a script that was exported from one.

    Only what tells cells apart is looked at: many programs write notebooks, and leave out or add what they like.
    Raises OSError, or ValueError and more if it is none.
    """
    if path.stat().st_size > LARGEST:
        raise ValueError(
            f"it has more than {LARGEST >> 20} MB: choose “Clear Outputs of All Cells”, save it, and hand it in again"
        )
    text = text_of(path).strip()
    if not text:
        raise ValueError("it is empty")
    if path.suffix == ".py":
        return _cells_of_script(text)
    told, _ = json.JSONDecoder().raw_decode(
        text
    )  # what stands behind it is no part of it
    sheets = (
        [told] if "cells" in told else told["worksheets"]
    )  # the latter until format 3
    return [
        Cell(str(cell.get("cell_type")), _source(cell))
        for sheet in sheets
        for cell in sheet["cells"]
    ]


def _source(cell: Mapping[str, Any]) -> str:
    source = cell.get("source", cell.get("input")) or ""
    whole = "".join(source).strip(INVISIBLE)
    return whole.encode(
        "utf-8", "replace"
    ).decode()  # half a letter cannot be sent to a kernel


def _cells_of_script(text: str) -> list[Cell]:
    """A script has marks between its cells; Google Colab writes none, and so each statement is a cell."""
    parts = MARK.split(text)
    if len(parts) == 1:
        parts = list(map(ast.unparse, getattr(tree(text), "body", []))) or parts
    return [Cell("code", part.strip()) for part in parts if part.strip()]


def is_notebook(path: Path) -> bool:
    """Whether a file is a notebook by its name, or by what is in it, which imports the check of a lesson."""
    if path.suffix.lower() not in KINDS[1:]:
        return path.suffix.lower() == KINDS[0]
    with suppress(Exception):  # it is something else
        return any(lessons_imported(cell.source) for cell in cells_of(path))
    return False


def _lesson_of(path: Path, cells: Sequence[str]) -> str:
    """The lesson whose check the notebook imports; else that in front of its file's name.

    03_q_learning.ipynb is of lesson 03; 1_a_robots_day.ipynb is of assignment_1.
    """
    imported = [
        room.removeprefix("lesson_")
        for source in cells
        for room in lessons_imported(source)
    ]
    number = path.name.partition("_")[0]
    return next(
        (
            lesson
            for lesson in [*imported, number, f"assignment_{number}"]
            if lesson in LESSONS
        ),
        "",
    )
