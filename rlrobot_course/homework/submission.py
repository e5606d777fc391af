"""A submitted notebook: which lesson it belongs to, and which of its code cells answer which exercise."""

from __future__ import annotations

import importlib
import json
import re
from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.question import Question
from rlrobot_course.grading.values import one_line
from rlrobot_course.homework.cell import (
    bound,
    calls_in,
    handed_in,
    lessons_imported,
    made_for,
    names_of_checks,
    tree,
)
from rlrobot_course.homework.rooms import LESSONS, room_of

LARGEST = 256 * 2**20  # notebook that is read, its outputs included [bytes]


@dataclass
class Submission:
    """One notebook as it was handed in.

    name: of its file; cells: source of its code cells, in their order
    lesson: its number, or assignment_1 and so on; empty if it cannot be told
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
            return len(self.cells)  # an answer may be handed in by a way that cannot be read off
        found = [*self.answered_in.values(), *self.defined_in.values()]
        return 1 + max((i for places in found for i in places), default=-1)

    @cached_property
    def checks(self) -> set[str]:
        """The names by which its cells know the checks."""
        return names_of_checks(self.cells)

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
        later = [self.cells[i] for i in range(place + 1, len(self.cells)) if i not in left_out]
        handed = set().union(*(handed_in(source, self.checks) for source in later))
        return [name for name in self.answered_in if name not in handed]


def exercises_of(lesson: str) -> dict[str, Exercise | Question]:
    """The exercises of a lesson by name, in the order of its notebook. Raises ValueError if there are none."""
    if lesson not in LESSONS:
        raise ValueError(
            f"there are no exercises in a lesson {lesson!r}; the lessons with some are {', '.join(LESSONS)}"
        )
    room = f"rlrobot_course.{room_of(lesson)}"
    checks = vars(importlib.import_module(f"{room}.exercises").check)
    return {name: one for name, one in checks.items() if isinstance(one, Exercise | Question)}


def read_submission(path: Path, lesson: str = "") -> Submission:
    """Read a notebook; never raises for what is in it. `lesson`: its number, if it is not to be looked for."""
    name = str(path)
    try:
        cells = _code_cells(path)
        problem = "" if cells else "There is no code cell in it."
    except (OSError, ImportError):
        raise
    except Exception as error:  # of a file that is no notebook anything may be the matter
        cells, problem = [], f"This is not a notebook that can be read ({one_line(str(error), 120)})."
    lesson = lesson or _lesson_of(path, cells)
    if not lesson:
        why = "It cannot be told which lesson this notebook belongs to: no cell imports the check of a lesson."
        return Submission(name, problem=problem or why)
    exercises, checks = exercises_of(lesson), names_of_checks(cells)
    defined = {name: [i for i, source in enumerate(cells) if name in bound(source)] for name in exercises}
    handing = {name: [i for i, source in enumerate(cells) if name in handed_in(source, checks)] for name in exercises}
    answered = {name: handing[name] or defined[name] or _named_in(name, cells) for name in exercises}
    student = next(filter(None, map(made_for, cells)), "")
    return Submission(name, lesson, cells, answered, defined, problem, student)


def sections_of(path: Path) -> dict[str, str]:
    """The heading under which each exercise is checked in a notebook, by its name; empty where it cannot be read."""
    sections: dict[str, str] = {}
    heading = ""
    with suppress(Exception):  # it may be no notebook
        cells = _notebook(path).cells
        checks = names_of_checks([cell.source for cell in cells if cell.cell_type == "code"])
        for cell in cells:
            if cell.cell_type == "markdown":
                headings = [line.strip("# ") for line in cell.source.splitlines() if line.startswith("#")]
                heading = headings[-1] if headings else heading
            elif cell.cell_type == "code" and heading:
                for name in handed_in(cell.source, checks):
                    sections.setdefault(name, heading)  # it may be checked again, below the summary, say
    return sections


def _named_in(exercise: str, cells: Sequence[str]) -> list[int]:
    """Cells that cannot be read, but name the exercise: to tell why it is not answered."""
    word = re.compile(rf"\b{exercise}\b")
    return [i for i, source in enumerate(cells) if word.search(source) and tree(source) is None]


def _notebook(path: Path) -> Any:
    """A notebook in nbformat 4, without its outputs. Raises ValueError, and more, if it is none."""
    try:
        import nbformat
    except ImportError:
        raise ImportError("jupyter is not installed: run pip install 'rlrobot-edu[lab]'; grading needs it") from None
    if path.stat().st_size > LARGEST:
        raise ValueError(
            f"it has more than {LARGEST >> 20} MB: choose “Clear Outputs of All Cells”, save it, and hand it in again"
        )
    # bytes: json knows UTF-8 and UTF-16, with a mark at their beginning or without, as other programs write them
    told = json.loads(path.read_bytes(), object_hook=_without_outputs)
    return nbformat.reads(json.dumps(told), as_version=4)


def _without_outputs(part: dict[str, Any]) -> dict[str, Any]:
    return part | {"outputs": []} if isinstance(part.get("outputs"), list) else part


def _code_cells(path: Path) -> list[str]:
    return [str(cell.source) for cell in _notebook(path).cells if cell.cell_type == "code"]


def _lesson_of(path: Path, cells: Sequence[str]) -> str:
    """The lesson whose check the notebook imports; else that in front of its file's name.

    02_q_learning.ipynb is of lesson 02; 1_a_robots_day.ipynb is of assignment_1.
    """
    imported = [room.removeprefix("lesson_") for source in cells for room in lessons_imported(source)]
    number = path.name.partition("_")[0]
    return next((lesson for lesson in [*imported, number, f"assignment_{number}"] if lesson in LESSONS), "")
