"""A bug hunt: one line of a right function is sick. What the function does is shown; which line is it, and how?

The sick lines are those of the exercise's known mistakes that change one line, and that what is shown tells apart.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.replay import Outcome
from rlrobot_course.grading.source import edited, edited_body, head_and_body
from rlrobot_course.grading.values import differences, safely
from rlrobot_course.grading.verdict import Verdict, side_by_side
from rlrobot_course.my_functions import is_right

NARROW = 88  # characters of a line beside JupyterLab's files
SHOWN = 3  # cases in which the sick function does something else


class Bug(NamedTuple):
    """A sick line: its number, from 1, below the first line of the function; its text; and the function with it."""

    line: int
    text: str
    function: Callable[..., Any]


class BugHunt:
    """A sick function of an exercise, to be diagnosed by what it does.

    exercise: of a lesson, as ``check.update``; seed: chooses the bug
    folder: where my_functions.py is. The hunt begins when the learner's own function is right: it shows a right one.
    """

    def __init__(self, exercise: Exercise, seed: int, folder: str | Path = ".") -> None:
        self._exercise, self.name = exercise, exercise.right.__name__
        lesson = exercise.right.__module__.split(".")[1].removeprefix("lesson_")
        self.is_open = is_right(lesson, self.name, folder)
        self._seed = seed

    @cached_property
    def _bug(self) -> Bug:
        known = bugs(self._exercise)
        return known[int(np.random.default_rng(self._seed).integers(len(known)))]

    def diagnose(self, line: Any, sick: Any) -> Verdict:
        """Is this the sick line, and is that what stands in it? It is right if the function then does the same.

        line: its number; sick: its text, without the spaces before it
        """
        if line is ... or sick is ...:
            return Verdict(
                "waiting", "This hunt waits for your diagnosis: the number of the line, and what stands there."
            )
        if not self.is_open:
            return Verdict("waiting", f"This hunt begins when your {self.name} is green and kept.")
        body = healthy(self._exercise)
        if line not in range(1, len(body) + 1) or not isinstance(sick, str):
            return Verdict("wrong", f"A line from 1 to {len(body)} is asked for, and its text in quotation marks.")
        made = safely(None, _with_line, self._exercise, line, sick.strip())
        if made is None:
            return Verdict("wrong", f"Python cannot read the function with “{sick.strip()}” in line {line}.")
        for i, case in enumerate(self._exercise.cases):
            its, yours = self._exercise.mistaken(self._bug.function, i), self._exercise.outcome(made, case)
            if not its.equals(yours):
                where = "the line is right, but " if line == self._bug.line else ""
                told = f"{where}with yours it does something else in case {i + 1}.".capitalize()
                return Verdict("wrong", told, rows=_rows(its, yours))
        mended = f"Healthy it is “{body[line - 1].strip()}”."
        return Verdict(
            "right", f"With this line it does the same in all {len(self._exercise.cases)} cases.", gained=mended
        )

    def __repr__(self) -> str:
        if not self.is_open:
            return f"This hunt begins when your {self.name} is right: its check must have been green."
        exercise = self._exercise
        told = [f"A healthy {self.name}. In the one that is called below, one of these lines is sick:", ""]
        told += [f"{number:3}  {line}" for number, line in enumerate(healthy(exercise), 1)]
        for i in shown(exercise, self._bug.function):
            right, its = exercise.expected[i], exercise.mistaken(self._bug.function, i)
            told += ["", *textwrap.wrap(f"Case {i + 1}: called with {exercise._called(exercise.cases[i])}", NARROW)]
            told += side_by_side([("", "healthy", "sick"), *differences(right.values, its.values)])
        differ = exercise.differing(self._bug.function)
        told += ["", f"It does something else than the healthy one in {len(differ)} of {len(exercise.cases)} cases: "
                     f"{', '.join(str(i + 1) for i in differ)}."]  # fmt: skip
        return "\n".join(told)


def healthy(exercise: Exercise) -> list[str]:
    """The lines of the right function below its first one."""
    return textwrap.dedent(head_and_body(exercise.right)[1]).rstrip().split("\n")


def shown(exercise: Exercise, function: Callable[..., Any]) -> list[int]:
    """The cases in which a hunt shows what a sick function does."""
    return exercise.differing(function)[:SHOWN]


def tells_apart(exercise: Exercise, one: Callable[..., Any], other: Callable[..., Any]) -> bool:
    """Whether what is shown of `one` is not what would be seen of `other`."""
    if exercise.differing(one) != exercise.differing(other):
        return True
    return any(not exercise.mistaken(one, i).equals(exercise.mistaken(other, i)) for i in shown(exercise, one))


def bugs(exercise: Exercise) -> list[Bug]:
    """The sick lines that can be served, each told apart from all others by what is shown of it."""
    found: list[Bug] = []
    for bug in _sick_lines(exercise):
        if exercise.differing(bug.function) and all(
            tells_apart(exercise, bug.function, other.function) and tells_apart(exercise, other.function, bug.function)
            for other in found
        ):
            found.append(bug)
    return found


def _sick_lines(exercise: Exercise) -> Iterator[Bug]:
    for mistake, function in zip(exercise.mistakes, exercise.wrong_functions, strict=True):
        if not isinstance(mistake.wrong, Mapping):
            continue
        before, after = head_and_body(exercise.right)[1], edited_body(exercise.right, mistake.wrong)
        pairs = zip(before.split("\n"), after.split("\n"), strict=False)
        sick = [(i, b.strip()) for i, (a, b) in enumerate(pairs, 1) if a != b]
        stops = any(exercise.mistaken(function, i).failure for i in range(len(exercise.cases)))
        if len(sick) == 1 and before.count("\n") == after.count("\n") and not stops:
            yield Bug(*sick[0], function)


def _with_line(exercise: Exercise, line: int, sick: str) -> Callable[..., Any]:
    """The right function with another text in one of its lines."""
    body = head_and_body(exercise.right)[1].rstrip()
    lines = body.split("\n")
    old = lines[line - 1]
    lines[line - 1] = old[: len(old) - len(old.lstrip())] + sick
    return edited(exercise.right, {body: "\n".join(lines)})


def _rows(its: Outcome, yours: Outcome) -> tuple[tuple[str, str, str], ...]:
    if its.failure or yours.failure:
        return ()
    return differences(its.values, yours.values)
