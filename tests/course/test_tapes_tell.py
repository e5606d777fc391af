"""The tapes tell: an answer that rounds, or that works within a part of what is promised, is wrong in some case."""

import json
import re
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


def is_right(exercise: Exercise, answer) -> bool:
    """Whether an answer is right. It is tried up to its first wrong case, and gets no hint."""
    if type(exercise) is RewardExercise:  # its cases are not what it is judged by
        return bool(exercise.judge(answer))
    cases = zip(exercise.expected, exercise.cases, strict=True)
    return all(right.equals(exercise.outcome(answer, case)) for right, case in cases)


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
    assert not is_right(exercise, that_rounds(exercise, argument, digits)), (
        f"an answer that first rounds {argument} to {digits} digits is called right: add a case with more digits"
    )


def near_one(x) -> bool:
    return 0.99 <= x < 1


# By the name of an argument, which values the lessons say that it has, in which sentence, and both ends of them.
RANGES = {
    "gamma": ("a number from 0 to just below 1", lambda x: x == 0, near_one),
    "lam": ("a number from 0 to 1", lambda x: x == 0, lambda x: x == 1),
    "u": ("from 0 up to, but not including, 1", lambda x: x == 0, near_one),
}


def n_states(case) -> int:
    return int(np.prod(case["shape"]))


# What the text of an exercise promises of single ones: the words, and what some case must be like for each end of it.
PROMISED = {
    ("lesson_01", "bin_of"): {
        "from 0 to `len(cuts)`": [
            lambda case: case["x"] <= min(case["cuts"], default=9),
            lambda case: case["cuts"] and case["x"] > case["cuts"][-1],
        ],
    },
    ("lesson_01", "state_number"): {
        "from 0 to 23": [
            lambda case: not any(case["bins"]),
            lambda case: case["bins"] == [1, 1, 2, 1],
        ]
    },
    ("lesson_02", "discounted_return"): {
        "which may be empty": [lambda case: not case["rewards"]]
    },
    ("lesson_04", "softmax"): {
        "a number above 0": [lambda case: case["temperature"] <= 0.001]
    },
    ("lesson_05", "siblings"): {
        "an input, from 0": [
            lambda case: case["s"] == case["i"] == 0 or case["i"] == 0,
            lambda case: case["i"] == len(case["shape"]) - 1,
            lambda case: case["s"] == 0,
            lambda case: case["s"] == n_states(case) - 1,
        ]
    },
    ("lesson_10", "learn_and_evade"): {
        "max(4, min(21, n_states // 4))": [
            lambda case: n_states(case) // 4 < 4,
            lambda case: n_states(case) // 4 > 21,
            lambda case: 4 < n_states(case) / 4 < 21 and n_states(case) % 4,
        ]
    },
    ("lesson_18", "nearest_ahead"): {
        "within 60 degrees to each side": [
            lambda case: -1.048 < case["angle_min"] < -np.pi / 3,
            lambda case: -np.pi / 3 < case["angle_min"] < -1.047,
            lambda case: 1.047 < case["angle_min"] < np.pi / 3,
            lambda case: np.pi / 3 < case["angle_min"] < 1.048,
        ]
    },
    ("lesson_18", "allowed"): {
        "older than 0.5 s": [lambda case: case["age"] == 0.5],
        "(even 0 or less)": [
            lambda case: case["ahead"] == 0,
            lambda case: case["ahead"] < 0,
        ],
        "less room than 0.18 m": [lambda case: case["ahead"] == 0.18],
    },
    ("assignment_1", "state_of"): {
        "a whole number from 0 on": [lambda case: case["cell"] == 0],
        "a list of any length": [
            lambda case: not case["cuts"],
            lambda case: len(case["cuts"]) > 4,
        ],
    },
    ("assignment_2", "epsilon_at"): {
        "from 0 on": [lambda case: case["t"] == 0],
        "never below": [lambda case: case["t"] > 20 * case["half_life"]],
    },
    ("assignment_2", "policy_value"): {
        "as large as 1000 and $T$ as small as 0.1": [
            lambda case: case["q_s"].max() == 1000 and case["temperature"] == 0.1,
            lambda case: case["q_s"].min() == -1000 and case["temperature"] == 0.1,
        ]
    },
    ("assignment_4", "near_states"): {
        "(2 or more)": [
            lambda case: min(case["shape"]) == 2,
            lambda case: max(case["shape"]) > 4,
        ]
    },
    ("assignment_4", "next_temperature"): {
        r"\min\!\left(50": [lambda case: case["temperature"] > 50]
    },
}
# words by which a range is promised
PROMISING = re.compile(
    r"[^.]*(?:\bfrom 0 (?:on|to|up)|\b0 to 1\b|\bfrom 0\b(?! to| on| up| in)|as small as|or more\)|any length"
    r"|may be empty|or less\)|never below)[^.]*"
)


def text_of(lesson: str) -> str:
    """The words of the notebook of a lesson or an assignment."""
    number = lesson.split("_")[1]
    folder = "notebooks/homework" if lesson.startswith("assignment") else "notebooks"
    (path,) = [*(ROOT / folder).glob(f"{number}_*.ipynb")] or [
        *(ROOT / "notebooks/more").glob(f"{number}_*.ipynb")
    ]
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells)


@pytest.mark.parametrize(("lesson", "name"), PROMISED)
def test_there_is_a_case_at_both_ends_of_what_is_promised(lesson, name):
    cases, text = exercises(lesson)[name].cases, text_of(lesson)
    for words, ends in PROMISED[lesson, name].items():
        assert words in text
        for i, end in enumerate(ends):
            assert any(end(case) for case in cases), f"{words}, {i}"


@pytest.mark.parametrize(
    ("lesson", "name", "argument"),
    [
        (lesson, name, argument)
        for lesson, name in FUNCTIONS
        for argument in exercises(lesson)[name].parameters
        if argument in RANGES
    ],
)
def test_there_is_a_case_at_both_ends_of_what_is_said_of_an_argument(
    lesson, name, argument
):
    values = [case[argument] for case in exercises(lesson)[name].cases]
    _, *ends = RANGES[argument]
    for end in ends:
        assert any(map(end, values))


def test_what_is_said_of_an_argument_stands_in_a_lesson():
    for lesson, argument in (
        ("lesson_02", "gamma"),
        ("lesson_07", "lam"),
        ("lesson_04", "u"),
        ("lesson_14", "u"),
    ):
        assert RANGES[argument][0] in text_of(lesson)


@pytest.mark.parametrize(("lesson", "name"), FUNCTIONS)
def test_whatever_range_a_task_promises_is_known_here(lesson, name):
    text = text_of(lesson)
    task = re.search(rf"### Exercise: [^\n]*`{name}`.*?\n(?=def )", text, re.DOTALL)
    known = [
        *PROMISED.get((lesson, name), ()),
        *(words for words, *_ in RANGES.values()),
    ]
    for promise in PROMISING.findall(task[0] if task else ""):
        assert any(words in promise for words in known), promise


def tables() -> list[tuple[str, str, str]]:
    """All exercises with a table, by state and action, of which the row of a state s is asked for."""
    found = []
    for lesson, name in FUNCTIONS:
        case = exercises(lesson)[name].cases[0]
        for argument, value in case.items():
            if "s" in case and np.ndim(value) == 2 and isinstance(value, np.ndarray):
                found.append((lesson, name, argument))
    return found


@pytest.mark.parametrize(("lesson", "name", "table"), tables())
def test_in_some_case_the_row_of_the_state_holds_two_that_differ(lesson, name, table):
    rows = [case[table][case["s"]] for case in exercises(lesson)[name].cases]
    assert any(len(set(row[row != 0])) > 1 for row in rows)


def cleared(row, kept):
    row[np.arange(len(row)) != kept] = 0


def evened(row, kept):
    row[:] = row.mean()


def mirrored(row, kept):
    row[:] = row[::-1].copy()


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("change", [cleared, evened, mirrored])
@pytest.mark.parametrize(("lesson", "name", "table"), tables())
def test_an_answer_to_which_a_row_is_one_value_is_wrong(lesson, name, table, change):
    """It changes the row of s first: what else stands there is 0, or the mean, or stands in another order."""
    exercise = exercises(lesson)[name]
    place = exercise.parameters.index

    def answer(*given):
        given = list(given)
        q = given[place(table)]
        if table not in exercise.memory:
            q = given[place(table)] = q.copy()
        a = given[place("a")] if "a" in exercise.parameters else 0
        change(q[given[place("s")]], a)
        return exercise.right(*given)

    assert not is_right(exercise, answer)
