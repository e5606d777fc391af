"""Which detectors have looked at a wrong answer, which of them have spoken, and what they said."""

from __future__ import annotations

import importlib
import runpy
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import safely
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.hints.evidence import Hint


def explain(number: str, name: str, answer: str) -> str:
    """What a check says of an answer, and what each detector says of it, a line each.

    number, name: of lesson and exercise, as in 03 and update
    answer: a Python file that defines the function under its name; for a question the value itself
    Raises ValueError if there is no such exercise, or no such function in the file.
    """
    try:
        known = vars(
            importlib.import_module(f"rlrobot_course.lesson_{number}.exercises").check
        )
    except ModuleNotFoundError:
        raise ValueError(
            f"lesson {number!r} has no exercises: write the number as in 03"
        ) from None
    if name not in known:
        raise ValueError(
            f"there is no exercise {name!r} in lesson {number}; there are {', '.join(known)}"
        )
    exercise = known[name]
    if isinstance(exercise, Question):
        value = safely(
            answer, eval, answer, {"np": np}
        )  # a word may stand without quotation marks
        return "\n".join([repr(exercise(value)), *_told_of_value(exercise, value)])
    function = _function(name, answer)
    return "\n".join([repr(exercise.judge(function)), *_told(exercise, function)])


def _function(name: str, file: str) -> Any:
    if not Path(file).is_file():
        raise ValueError(
            f"{file} is no file; the answer to {name} is a Python file that defines it"
        )
    names = runpy.run_path(file)
    if name not in names:
        raise ValueError(f"{file} defines no {name}")
    return names[name]


def _told_of_value(question: Question, value: Any) -> Iterator[str]:
    """A line for each mistake that has this value, and one for what nobody had to write."""
    if question.equals(value, question.right):
        return
    for mistake in question.mistakes:
        if question.equals(value, mistake.wrong):
            yield f"  mistake {mistake.id}: {mistake.hint}"
    found = question.found(value)
    yield f"  {found.id or 'form, formula'}: {found.text or 'nothing'}"


def _told(exercise: Any, answer: Any) -> Iterator[str]:
    """A line for each detector, in their order: the hint that it has, or that it has none."""
    seen = exercise.evidence(answer, exercise.outcomes(answer))
    if not seen.wrong:
        return
    yield f"  wrong in the cases {', '.join(str(i + 1) for i in seen.wrong)} of {len(exercise.cases)}"
    if failure := seen.got[seen.wrong[0]].failure:
        yield f"  no detector looks at an answer that fails: {failure.text}"
        return
    for name, detector in DETECTORS.items():
        found = detector(seen)
        told = f"({found.id}) {found.text}" if isinstance(found, Hint) else found
        yield f"  {name}: {told or 'nothing'}"
