"""Each student their own: cases, constants and the order of answers, drawn from the student's number.

`export_each` writes a notebook for each student, and its solutions for the instructor.

What may differ stands in `own.toml` beside an assignment:

- `[[constant]]`: `values`, of which the first is as in the notebook, and `places`: texts that hold it, in the notebook,
  in solutions, mistakes and hints
- `[[order]]`: the exercise whose `letters` change places, in its rows of the notebook and in `places`
"""

from __future__ import annotations

import re
import tomllib
import zlib
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import FunctionType, SimpleNamespace
from typing import Any

import numpy as np

from rlrobot_grading.answers.source import edited, head_and_body
from rlrobot_grading.answers.values import safely
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.mistake import Mistake
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.nbgrader_course import checked, solution_of, tell_hints
from rlrobot_grading.marking.rooms import COURSE, room_of
from rlrobot_grading.marking.secret import secret_twin
from rlrobot_grading.marking.students import read_students
from rlrobot_grading.marking.submission import exercises_of, read_submission


@dataclass
class Variant:
    """What a student's assignment has of its own.

    changes: texts in the notebook, and what stands there instead; orders: for an exercise, its letters by those that
    they take the place of
    """

    exercises: dict[str, Exercise | Question] = field(default_factory=dict)
    changes: dict[str, str] = field(default_factory=dict)
    orders: dict[str, dict[str, str]] = field(default_factory=dict)

    def text(self, text: str) -> str:
        """A cell of the notebook, or a solution, with what is different in it."""
        for order in self.orders.values():
            rows = {
                row[2]: row
                for row in text.splitlines()
                if row[:2] == "| " and row[2:3] in order
            }
            if rows.keys() == order.keys():
                moved = {
                    order[letter]: f"| {order[letter]}{row[3:]}"
                    for letter, row in rows.items()
                }
                text = replaced(
                    text, {row: moved[letter] for letter, row in rows.items()}
                )
        return replaced(text, self.changes)


def own(check: SimpleNamespace, student: str) -> None:
    """Give the checks of an assignment a student's own cases and constants; for notebooks."""
    functions = (one.right for one in vars(check).values() if isinstance(one, Exercise))
    room = next(functions).__module__.rpartition(".")[0]
    vars(check).update(
        variant_of(room.rpartition(".")[2].removeprefix("lesson_"), student).exercises
    )


def variant_of(lesson: str, student: str) -> Variant:
    """The variant of an assignment, or of a lesson, for the student of this number."""
    rng = np.random.default_rng(
        [zlib.crc32(text.lower().encode()) for text in (lesson, student)]
    )
    variant, right = Variant(), {}
    file = COURSE / room_of(lesson) / "own.toml"
    told = tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    for constant in told.get("constant", ()):
        first, *_ = constant["values"]
        drawn = constant["values"][rng.integers(len(constant["values"]))]
        variant.changes |= {
            place.format(*first): place.format(*drawn) for place in constant["places"]
        }
    orders = {order["exercise"]: order for order in told.get("order", ())}
    for name, exercise in exercises_of(lesson).items():
        if isinstance(exercise, Exercise):
            changed = _with_constants(exercise, variant.changes, right)
            right[name] = changed.right
            variant.exercises[name] = (
                secret_twin(changed, int(rng.integers(2**32))) or changed
            )
        elif isinstance(exercise, Question):
            if name in orders:
                letters = orders[name]["letters"]
                variant.orders[name] = new = _drawn_order(exercise, letters, rng)
                same = dict(zip(letters, letters, strict=True))
                variant.changes |= {
                    p.format_map(same): p.format_map(new)
                    for p in orders[name]["places"]
                }
            variant.exercises[name] = _with_order(
                exercise, variant.orders.get(name, {}), variant.changes
            )
    return variant


def replaced(text: str, changes: Mapping[str, str]) -> str:
    """`text` with other texts in it, all put in at once."""
    return (
        re.sub("|".join(map(re.escape, changes)), lambda m: changes[m[0]], text)
        if changes
        else text
    )


def _with_constants(
    exercise: Exercise,
    changes: Mapping[str, str],
    right: Mapping[str, Callable[..., Any]],
) -> Exercise:
    """An exercise with other constants; `right`: the functions of those before it, which it may call."""

    def changed(function: Callable[..., Any]) -> Callable[..., Any]:
        body = safely("", lambda: head_and_body(function)[1])
        here = {old: new for old, new in changes.items() if old in body}
        function = edited(function, here) if here else function
        called = {
            name: other
            for name, other in right.items()
            if name in getattr(function, "__globals__", ())
        }
        if not called or not isinstance(function, FunctionType):
            return function
        return FunctionType(
            function.__code__,
            function.__globals__ | called,
            function.__name__,
            function.__defaults__,
        )

    def mistaken(one: Mistake) -> Mistake:
        wrong = (
            changed(one.wrong)
            if callable(one.wrong)
            else _replaced_in(one.wrong, changes)
        )
        return replace(one, hint=replaced(one.hint, changes), wrong=wrong)

    hints, mistakes = (
        [replaced(hint, changes) for hint in exercise.hints],
        [*map(mistaken, exercise.mistakes)],
    )
    return replace(
        exercise,
        right=changed(exercise.right),
        mistakes=mistakes,
        hints=hints,
        witnesses={},
    )


def _replaced_in(
    edits: Mapping[str, str], changes: Mapping[str, str]
) -> dict[str, str]:
    return {
        replaced(old, changes): replaced(new, changes) for old, new in edits.items()
    }


def _drawn_order(
    question: Question, letters: str, rng: np.random.Generator
) -> dict[str, str]:
    """New letters by the old ones, by which no mistake becomes the answer that the notebook shows as an example."""
    while True:
        order = dict(zip(letters, rng.permutation(list(letters)).tolist(), strict=True))
        turned = _with_order(question, order, {})
        wrong = [str(mistake.wrong) for mistake in turned.mistakes]
        if len({*wrong, str(turned.right)}) == len(wrong) + 1:
            return order


def _with_order(
    question: Question, order: Mapping[str, str], changes: Mapping[str, str]
) -> Question:
    """A question with other letters for its answers; of a list, the places change."""

    def turned(value: Any) -> Any:
        if isinstance(value, str):
            return "".join(sorted(order.get(letter, letter) for letter in value))
        if isinstance(value, list) and order:
            by_letter = dict(zip(order.values(), value, strict=True))
            return [by_letter[letter] for letter in sorted(by_letter)]
        return value

    def mistaken(one: Mistake) -> Mistake:
        return replace(
            one,
            hint=replaced(one.hint, changes),
            wrong=one.wrong if one.id == "as_shown" else turned(one.wrong),
        )

    mistakes, because = (
        [*map(mistaken, question.mistakes)],
        replaced(question.because, changes),
    )
    hints = [replaced(hint, changes) for hint in question.hints]
    return replace(
        question,
        right=turned(question.right),
        mistakes=mistakes,
        because=because,
        hints=hints,
        witnesses={},
    )


OWN = "from rlrobot_grading.marking.variants import own\n\nown(check, {student!r})"


def export_each(
    notebooks: Sequence[Path], folder: Path, roster: str, hints: int | None = None
) -> int:
    """Write each student's notebooks into students/, and their solutions into solutions/; returns how many students.

    roster: path of the list of students; hints: how many an exercise shows, all if not given
    Raises ValueError if a notebook has no exercises, or an id cannot be part of a file's name; OSError.
    """
    import nbformat

    students = [student.id for student in read_students(roster)]
    if wrong := [
        student for student in students if not re.fullmatch(r"\w[\w.@-]*", student)
    ]:
        raise ValueError(
            f"{roster}: the id {wrong[0]!r} cannot be part of a file's name: letters, digits, . @ _ -"
        )
    for path in notebooks:
        submission = read_submission(path)
        if submission.problem:
            raise ValueError(f"{path}: {submission.problem}")
        notebook = nbformat.read(path, as_version=4)
        for student in students:
            variant = variant_of(submission.lesson, student)
            for room, solved in (("students", False), ("solutions", True)):
                copy = own_copy(
                    notebook, variant, student, submission.lesson if solved else ""
                )
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
                cell.source = (
                    f"{_solution(variant, name, solved_of)}\n\n\ncheck.{name}({name})"
                )
    return copy


def _solution(variant: Variant, name: str, lesson: str) -> str:
    exercise = variant.exercises[name]
    if isinstance(exercise, Question):
        return f"{name} = {exercise.right!r}"
    return replaced(solution_of(name, lesson), variant.changes)
