"""A submitted notebook: which lesson it belongs to, and which of its code cells answer which exercise."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.cell import (
    CHECK,
    bound,
    calls_in,
    handed_in,
    imported,
    lessons_imported,
    made_for,
    tree,
)
from rlrobot_grading.marking.course import LESSON, Course
from rlrobot_grading.marking.text import INVISIBLE, text_of

LARGEST = 256 * 2**20  # notebook that is read, its outputs included [bytes]
NO_CELLS = "This is not a notebook that can be read (it has no cells where a notebook has them)."


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
    made_for: the id of the student whose variant it is; empty if it is nobody's
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
            # an answer may be handed in by a way that cannot be read off
            return len(self.cells)
        last = -1
        for places in [*self.answered_in.values(), *self.defined_in.values()]:
            last = max([last, *places])
        return 1 + last

    @cached_property
    def _calls(self) -> dict[str, set[str]]:
        return calls_in(self.cells)

    def called_by(self, name: str) -> set[str]:
        """Return what stands in the definitions of a name, and in those of all that stands there."""
        called = {name}
        ahead = [name]
        while ahead:
            new = self._calls.get(ahead.pop(), set()) - called
            called |= new
            ahead += new
        return called

    def answered_by(self, place: int, left_out: Collection[int]) -> list[str]:
        """Return the exercises that a definition in this cell answers: no later cell hands them in."""
        later: set[str] = set()
        for i in range(place + 1, len(self.cells)):
            if i not in left_out:
                later |= handed_in(self.cells[i])
        return [name for name in self.answered_in if name not in later]


def read_submission(course: Course, path: Path, lesson: str = "") -> Submission:
    """Read a notebook; never raises for what is in it. `lesson`: its number, if it is not to be looked for."""
    name = str(path)
    cells: list[str] = []
    problem = ""
    try:
        cells = [cell.source for cell in cells_of(path) if cell.kind == "code"]
        if not cells:
            problem = "There is no code cell in it."
    except OSError as error:
        problem = f"It cannot be read: {error.strerror}."
    except ValueError as error:
        why = one_line(str(error), 120)
        problem = f"This is not a notebook that can be read ({why})."
    except Exception:  # of a file that is no notebook anything may be the matter
        problem = NO_CELLS
    lesson = lesson or _lesson_of(course, path, cells)
    if not lesson:
        return Submission(name, problem=problem or _no_lesson(course, cells))
    defined = {}
    answered = {}
    for exercise in course.exercises_of(lesson):
        defined[exercise] = _places(cells, exercise, bound)
        answered[exercise] = (
            _places(cells, exercise, handed_in)
            or defined[exercise]
            or _unreadable(cells, exercise)
        )
    students = [made_for(source) for source in cells]
    student = next(filter(None, students), "")
    return Submission(name, lesson, cells, answered, defined, problem, student)


def _places(
    cells: Sequence[str], exercise: str, names: Callable[[str], set[str]]
) -> list[int]:
    """Return the cells among whose `names` the exercise is."""
    return [i for i, source in enumerate(cells) if exercise in names(source)]


def _unreadable(cells: Sequence[str], exercise: str) -> list[int]:
    """Return the cells that cannot be read, but name the exercise: to say why it is not answered."""
    word = re.compile(rf"\b{exercise}\b")
    return [
        i for i, source in enumerate(cells) if word.search(source) and not tree(source)
    ]


def sections_of(path: Path) -> dict[str, str]:
    """Return the heading under which each exercise is checked in a notebook; empty where it cannot be read."""
    sections: dict[str, str] = {}
    heading = ""
    with suppress(Exception):  # it may be no notebook
        for cell in cells_of(path):
            if cell.kind == "markdown":
                for line in cell.source.splitlines():
                    if line.startswith("#"):
                        heading = line.strip("# ")
            elif cell.kind == "code" and heading:
                # it may be checked again, below the summary, say
                for name in handed_in(cell.source):
                    sections.setdefault(name, heading)
    return sections


def cells_of(path: Path) -> list[Cell]:
    """Return the cells of a notebook.

    Only what distinguishes cells is read: many programs write notebooks, and leave out or add what they like.
    Raises OSError, or ValueError and more if it is none.
    """
    if path.stat().st_size > LARGEST:
        raise ValueError(
            f"it has more than {LARGEST >> 20} MB: choose “Clear Outputs of All Cells”, save it, and hand it in again"
        )
    text = text_of(path).strip()
    if not text:
        raise ValueError("it is empty")
    cells = []
    for cell in json.loads(text)["cells"]:
        source = "".join(cell.get("source") or "").strip(INVISIBLE)
        # half a letter cannot be sent to a kernel
        source = source.encode("utf-8", "replace").decode()
        cells.append(Cell(str(cell.get("cell_type")), source))
    return cells


def _of_another_course(course: Course, cells: Sequence[str]) -> str:
    """Return the check of a lesson of another package that a notebook imports; empty if there is none."""
    for source in cells:
        for name in imported(source):
            package, _, inner = name.rpartition(f".{LESSON}")
            if package not in ("", course.package) and inner.endswith(f".{CHECK}"):
                return name
    return ""


def _no_lesson(course: Course, cells: Sequence[str]) -> str:
    """Return why it cannot be told which lesson a notebook belongs to."""
    theirs = _of_another_course(course, cells)
    if theirs:
        return (
            f"It imports {one_line(theirs, 80)}, which is not of {course.package}: "
            "a notebook of another year? Hand in the answers in a notebook of this course."
        )
    return "It cannot be told which lesson this notebook belongs to: no cell imports the check of a lesson."


def _lesson_of(course: Course, path: Path, cells: Sequence[str]) -> str:
    """Return the lesson whose check the notebook imports; else that in front of its file's name.

    03_q_learning.ipynb is of lesson 03; 1_a_robots_day.ipynb is of assignment_1.
    """
    candidates = []
    for source in cells:
        for folder in lessons_imported(source, course.package):
            candidates.append(folder.removeprefix(LESSON))
    if not candidates and _of_another_course(course, cells):
        return ""  # there, the numbers in front of files' names may be others
    number = path.name.partition("_")[0]
    candidates += [number, f"assignment_{number}"]
    known = course.lessons
    return next((lesson for lesson in candidates if lesson in known), "")
