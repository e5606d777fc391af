"""The catalogue of mistakes: those that the lessons know, a line of JSON each; of the assignments it has none.

``rlrobot-edu course mistakes > mistakes.jsonl`` writes it, and docs/howto/mistakes.md says what stands in a line.
"""

import json
from collections.abc import Iterator
from importlib import import_module
from types import FunctionType
from typing import Any

from rlrobot_course.learner.my_functions import LESSONS
from rlrobot_grading.answers.source import head_and_body
from rlrobot_grading.answers.values import Function, differences, show
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question

Entry = dict[str, Any]


def entries() -> Iterator[Entry]:
    """The mistakes of all lessons, in their order."""
    for lesson in LESSONS:
        check = import_module(f"rlrobot_course.lesson_{lesson}.exercises").check
        for exercise in vars(check).values():
            yield from of(exercise, lesson)


def of(exercise: Exercise | Question, lesson: str) -> Iterator[Entry]:
    """The mistakes of one exercise."""
    for i, mistake in enumerate(exercise.mistakes):
        entry: Entry = {
            "id": f"{lesson}/{exercise.name}/{mistake.id}",
            "task": exercise.task,
            "hint": mistake.hint,
        }
        if isinstance(exercise, Question):
            entry |= {"right": show(exercise.right), "wrong": show(mistake.wrong)}
        else:
            wrong = exercise.wrong_functions[i]
            entry |= {
                "right": source(exercise.right),
                "wrong": source(wrong),
                "helpers": helpers(exercise.right, wrong),
                "first_case": first_case(exercise, wrong),
            }
        yield entry


def source(function: Function) -> str:
    """The text of a function."""
    return "".join(head_and_body(function))


def helpers(*functions: Function) -> dict[str, str]:
    """The text of each function of the course that these call, by its name."""
    found: dict[str, str] = {}
    waiting = list(functions)
    while waiting:
        function = waiting.pop()
        names = function.__globals__
        for name in function.__code__.co_names:
            other = names.get(name)
            is_ours = isinstance(other, FunctionType) and other.__module__.startswith(
                "rlrobot_course"
            )
            if is_ours and name not in found and other not in functions:
                found[name] = source(other)
                waiting.append(other)
    return found


def first_case(exercise: Exercise, wrong: Function) -> Entry:
    """The first case in which a wrong function differs: its arguments, and what differs in it."""
    pairs = zip(exercise.expected, exercise.outcomes(wrong), strict=False)
    i, right, got = next(
        (i, right, got) for i, (right, got) in enumerate(pairs) if not right.equals(got)
    )
    found: Entry = {"number": i + 1, "of": len(exercise.cases)}
    arguments = exercise.cases[i].items()
    found["arguments"] = {
        name: show(value) for name, value in arguments if " at 0x" not in repr(value)
    }
    rows = differences(right.values, got.values)
    found["expected"] = {what.strip(): value for what, value, _ in rows}
    found["got"] = {what.strip(): value for what, _, value in rows}
    if got.failure:
        found["got"] = {"stops": got.failure.text}
    elif got.spoilt:
        found["changes what it should read"] = list(got.spoilt)
    return found


def lines() -> Iterator[str]:
    """The catalogue, line by line."""
    for entry in entries():
        yield json.dumps(entry, ensure_ascii=False)
