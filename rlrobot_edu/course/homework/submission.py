"""A submitted notebook: which lesson it belongs to, and which of its code cells answer which exercise."""

from __future__ import annotations

import ast
import importlib
import re
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.values import one_line
from rlrobot_edu.course.homework.rooms import LESSONS, room_of

LARGEST = 64 * 2**20  # notebook that is read [bytes]
CHECKED = re.compile(r"\bcheck\.(\w+)\(")
ITS_CHECK = re.compile(r"rlrobot_edu\.course\.((?:lesson|assignment)_\w+?)(?:\.check\b|\s+import\s.*?\bcheck\b)")


OWN = re.compile(r"""^own\(check, ["']([^"']+)["']\)""", re.MULTILINE)


@dataclass
class Submission:
    """One notebook as it was handed in.

    name: of its file; cells: source of its code cells, in their order
    lesson: its number, or assignment_1 and so on; empty if it cannot be told
    answered_in: for each exercise of the lesson, the places in `cells` that may answer it
    problem: why it cannot be run, if it cannot
    made_for: the number of the student whose variant it is; empty if it is nobody's
    """

    name: str
    lesson: str = ""
    cells: list[str] = field(default_factory=list)
    answered_in: dict[str, list[int]] = field(default_factory=dict)
    problem: str = ""
    made_for: str = ""

    @property
    def last_cell(self) -> int:
        """How many cells are run: what comes after the last answer is not judged."""
        if not all(self.answered_in.values()):
            return len(self.cells)  # an answer may be handed in by a way that cannot be read off
        return 1 + max((i for places in self.answered_in.values() for i in places), default=-1)


def exercises_of(lesson: str) -> dict[str, Exercise | Question]:
    """The exercises of a lesson by name, in the order of its solutions. Raises ValueError if there are none."""
    if lesson not in LESSONS:
        raise ValueError(
            f"there are no exercises in a lesson {lesson!r}; the lessons with some are {', '.join(LESSONS)}"
        )
    room = f"rlrobot_edu.course.{room_of(lesson)}"
    here, solutions = (importlib.import_module(f"{room}.{name}") for name in ("check", "solutions"))
    here, order = vars(here), getattr(solutions, "__all__", vars(solutions))
    return {name: here[name] for name in order if isinstance(here.get(name), Exercise | Question)}


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
    answered_in = {exercise: _places(exercise, cells) for exercise in exercises_of(lesson)}
    made_for = next((student for source in cells for student in OWN.findall(source)), "")
    return Submission(name, lesson, cells, answered_in, problem, made_for)


def sections_of(path: Path) -> dict[str, str]:
    """The heading under which each exercise is checked in a notebook, by its name; empty where it cannot be read."""
    import nbformat

    sections, heading = {}, ""
    with suppress(Exception):  # it may be no notebook
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "markdown":
                headings = [line.strip("# ") for line in cell.source.splitlines() if line.startswith("#")]
                heading = headings[-1] if headings else heading
            elif cell.cell_type == "code" and heading:
                for name in CHECKED.findall(cell.source):
                    sections.setdefault(name, heading)  # it may be checked again, below the summary, say
    return sections


def bound(source: str) -> set[str]:
    """Names that a cell gives a value to, but for those that `take` gives it; empty where it cannot be read."""
    names: set[str] = set()
    for line in _lines(source):
        if isinstance(line, ast.FunctionDef):
            names.add(line.name)
        elif isinstance(line, ast.Assign | ast.AnnAssign) and line.value and "take(" not in ast.unparse(line.value):
            targets = line.targets if isinstance(line, ast.Assign) else [line.target]
            names |= {node.id for target in targets for node in ast.walk(target) if isinstance(node, ast.Name)}
    return names


def names_in(source: str) -> set[str]:
    """Names that a cell reads; empty where it cannot be read."""
    return {node.id for line in _lines(source) for node in ast.walk(line) if isinstance(node, ast.Name)}


def defined_in(source: str, name: str) -> ast.stmt | None:
    """The last function of this name that a cell defines, by def or as a lambda."""
    found = [line for line in _lines(source) if _defines(line, name)]
    return found[-1] if found else None


def _defines(line: ast.stmt, name: str) -> bool:
    if isinstance(line, ast.Assign) and isinstance(line.value, ast.Lambda):
        return any(isinstance(target, ast.Name) and target.id == name for target in line.targets)
    return isinstance(line, ast.FunctionDef) and line.name == name


def hints_asked(cells: list[str], exercise: str) -> int:
    """How many different hints of an exercise the cells ask for."""
    call = re.compile(rf"^[^#\n]*\bcheck\s*\.\s*{exercise}\s*\.\s*hint\(([^)]*)", re.MULTILINE)
    return len({asked.strip() or "1" for source in cells for asked in call.findall(source)})


def changes_checks(source: str) -> bool:
    """Whether a cell gives the checks, or something in them, another value."""
    return any(_changes_checks(node) for line in _lines(source) for node in ast.walk(line))


def _changes_checks(node: ast.AST) -> bool:
    if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store | ast.Del):
        return bool(re.match(r"check(\.|$)|.*\.(judge|__call__|__bool__)$", ast.unparse(node)))
    if isinstance(node, ast.Call):
        return ast.unparse(node).startswith("setattr(check")
    return isinstance(node, ast.FunctionDef) and node.name == "check"


def _lines(source: str) -> list[ast.stmt]:
    try:
        return ast.parse(source).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []


def _places(exercise: str, cells: list[str]) -> list[int]:
    """Cells that hand the answer to its check; where none does, those that define it."""
    call = re.compile(rf"\bcheck\s*\.\s*{exercise}\s*\(")
    handing_in = [i for i, source in enumerate(cells) if call.search(source)]
    return handing_in or [i for i, source in enumerate(cells) if exercise in bound(source)]


def _code_cells(path: Path) -> list[str]:
    try:
        import nbformat
    except ImportError:
        raise ImportError("jupyter is not installed: run pip install 'rlrobot-edu[lab]'; grading needs it") from None
    if path.stat().st_size > LARGEST:
        raise ValueError(f"it has more than {LARGEST >> 20} MB")
    notebook = nbformat.reads(path.read_text(encoding="utf-8"), as_version=4)
    return [str(cell.source) for cell in notebook.cells if cell.cell_type == "code"]


def _lesson_of(path: Path, cells: list[str]) -> str:
    """The lesson whose check the notebook imports; else that in front of its file's name.

    02_q_learning.ipynb is of lesson 02; 1_a_robots_day.ipynb is of assignment_1.
    """
    found = [match.removeprefix("lesson_") for source in cells for match in ITS_CHECK.findall(source)]
    number = path.name.partition("_")[0]
    return next((lesson for lesson in [*found, number, f"assignment_{number}"] if lesson in LESSONS), "")
