"""Another variant of an assignment for each student: cases, constants and the order of answers.

All is drawn from the student's id. What may differ besides the cases stands in `variants.toml` beside an assignment:

- `[[constant]]`: `values`, of which the first is as in the notebook, and `places`: texts that hold it, in the notebook,
  in solutions, mistakes and hints
- `[[order]]`: the exercise whose `letters` change places, in its rows of the notebook and in `places`
"""

from __future__ import annotations

import re
import tomllib
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_grading.answers.source import edited, head_and_body
from rlrobot_grading.answers.values import Function, safely
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.mistake import Mistake
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.secret import secret_twin


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
        """Return a cell of the notebook, or a solution, with what is different in it."""
        for order in self.orders.values():
            rows = {}
            for row in text.splitlines():
                if row.startswith("| ") and row[2:3] in order:
                    rows[row[2]] = row
            if rows.keys() == order.keys():
                moved = {order[letter]: row[3:] for letter, row in rows.items()}
                new = {
                    row: f"| {letter}{moved[letter]}" for letter, row in rows.items()
                }
                text = replaced(text, new)
        return replaced(text, self.changes)


def variant_of(course: Course, lesson: str, student: str) -> Variant:
    """Return the variant of an assignment, or of a lesson, for the student with this id."""
    rng = np.random.default_rng(
        [zlib.crc32(text.lower().encode()) for text in (lesson, student)]
    )
    variant = Variant()
    right: dict[str, Function] = {}
    file = course.path / course.folder_of(lesson) / "variants.toml"
    differs = tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    for constant in differs.get("constant", ()):
        first, *_ = constant["values"]
        drawn = constant["values"][rng.integers(len(constant["values"]))]
        for place in constant["places"]:
            variant.changes[place.format(*first)] = place.format(*drawn)
    orders = {order["exercise"]: order for order in differs.get("order", ())}
    for name, exercise in course.exercises_of(lesson).items():
        if isinstance(exercise, Exercise):
            changed = _with_constants(exercise, variant.changes, right)
            right[name] = changed.right
            twin = secret_twin(changed, int(rng.integers(2**32)))
            variant.exercises[name] = twin or changed
            continue
        if name in orders:
            letters = orders[name]["letters"]
            new = _drawn_order(exercise, letters, rng)
            same = {letter: letter for letter in letters}
            variant.orders[name] = new
            for place in orders[name]["places"]:
                variant.changes[place.format_map(same)] = place.format_map(new)
        variant.exercises[name] = _with_order(
            exercise, variant.orders.get(name, {}), variant.changes
        )
    return variant


def replaced(text: str, changes: Mapping[str, str]) -> str:
    """Return `text` with other texts in it, all put in at once."""
    if not changes:
        return text
    return re.sub("|".join(map(re.escape, changes)), lambda m: changes[m[0]], text)


def _with_constants(
    exercise: Exercise,
    changes: Mapping[str, str],
    right: Mapping[str, Function],
) -> Exercise:
    """Return an exercise with other constants; `right`: the functions before it, which it may call."""

    def changed(function: Function) -> Function:
        body = safely("", lambda: head_and_body(function)[1])
        here = {old: new for old, new in changes.items() if old in body}
        if here:
            function = edited(function, here)
        names = getattr(function, "__globals__", {})
        called = {name: other for name, other in right.items() if name in names}
        if not called or not isinstance(function, FunctionType):
            return function
        return FunctionType(
            function.__code__,
            function.__globals__ | called,
            function.__name__,
            function.__defaults__,
        )

    mistakes = []
    for one in exercise.mistakes:
        if callable(one.wrong):
            wrong: Any = changed(one.wrong)
        else:
            wrong = {
                replaced(old, changes): replaced(new, changes)
                for old, new in one.wrong.items()
            }
        mistakes.append(replace(one, hint=replaced(one.hint, changes), wrong=wrong))
    return replace(
        exercise,
        right=changed(exercise.right),
        mistakes=mistakes,
        hints=[replaced(hint, changes) for hint in exercise.hints],
        witnesses={},
    )


def _drawn_order(
    question: Question, letters: str, rng: np.random.Generator
) -> dict[str, str]:
    """Return new letters by the old ones; no mistake becomes the answer that the notebook shows as an example."""
    while True:
        order = dict(zip(letters, rng.permutation(list(letters)).tolist(), strict=True))
        turned = _with_order(question, order, {})
        wrong = [str(mistake.wrong) for mistake in turned.mistakes]
        if len({*wrong, str(turned.right)}) == len(wrong) + 1:
            return order


def _with_order(
    question: Question, order: Mapping[str, str], changes: Mapping[str, str]
) -> Question:
    """Return a question with other letters for its answers; of a list, the places change."""

    def turned(value: Any) -> Any:
        if isinstance(value, str):
            return "".join(sorted(order.get(letter, letter) for letter in value))
        if isinstance(value, list) and order:
            by_letter = dict(zip(order.values(), value, strict=True))
            return [by_letter[letter] for letter in sorted(by_letter)]
        return value

    def mistaken(one: Mistake) -> Mistake:
        wrong = one.wrong if one.id == "as_shown" else turned(one.wrong)
        return replace(one, hint=replaced(one.hint, changes), wrong=wrong)

    return replace(
        question,
        right=turned(question.right),
        mistakes=[mistaken(one) for one in question.mistakes],
        because=replaced(question.because, changes),
        hints=[replaced(hint, changes) for hint in question.hints],
        witnesses={},
    )
