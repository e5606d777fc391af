"""The tapes tell: an answer that rounds, or that works within a part of what is promised, is wrong in some case."""

from pathlib import Path

import numpy as np
import pytest
from test_checks import EVERY, exercises

from rlrobot_course.exercises.design import Design
from rlrobot_course.lesson_13.reward_exercise import RewardExercise
from rlrobot_grading.exercises.exercise import Exercise

ROOT = Path(__file__).parents[2]
FUNCTIONS = [
    (lesson, name)
    for lesson, name in EVERY
    if isinstance(exercises(lesson)[name], Exercise)
]


def of_cases(kind: type) -> list[tuple[str, str]]:
    return [(x, y) for x, y in FUNCTIONS if isinstance(exercises(x)[y], kind)]


def is_right(exercise: Exercise, answer) -> bool:
    """Whether an answer is right, without a hint where it is not."""
    if type(exercise) is RewardExercise:  # its cases are not what it is judged by
        return bool(exercise.judge(answer))
    return exercise.share(answer) == 1


def rounded(value, digits: int):
    """`value` with all its numbers rounded."""
    if isinstance(value, np.ndarray):
        return value.round(digits)
    if isinstance(value, float):
        return round(value, digits)
    if type(value) in (list, tuple):
        return type(value)(rounded(part, digits) for part in value)
    if isinstance(value, dict):
        return {key: rounded(part, digits) for key, part in value.items()}
    return value


def has_fractions(value) -> bool:
    """Whether a value holds numbers that may have a fraction."""
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "f"
    if isinstance(value, list | tuple):
        return any(map(has_fractions, value))
    if isinstance(value, dict):
        return any(map(has_fractions, value.values()))
    return isinstance(value, float)


def that_rounds(exercise: Exercise, name: str, digits: int):
    """The right answer, which rounds one of its arguments first; of a table that it changes, the table itself."""
    place = exercise.parameters.index(name)

    def answer(*given):
        given = list(given)
        if name in exercise.memory and isinstance(given[place], np.ndarray):
            given[place][...] = given[place].round(digits)
        else:
            given[place] = rounded(given[place], digits)
        return exercise.right(*given)

    return answer


def can_be_rounded() -> list[tuple[str, str, str]]:
    """All arguments, of all exercises, that hold numbers with a fraction in some case."""
    found = []
    for lesson, name in FUNCTIONS:
        exercise = exercises(lesson)[name]
        for argument in exercise.parameters:
            # the arguments of a design's function are the readings that a situation holds
            if isinstance(exercise, Design) or any(
                has_fractions(case[argument]) for case in exercise.cases
            ):
                found.append((lesson, name, argument))
    return found


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("digits", [1, 2])
@pytest.mark.parametrize(("lesson", "name", "argument"), can_be_rounded())
def test_an_answer_that_rounds_what_it_is_given_is_wrong(
    lesson, name, argument, digits
):
    exercise = exercises(lesson)[name]
    assert not is_right(exercise, that_rounds(exercise, argument, digits))
