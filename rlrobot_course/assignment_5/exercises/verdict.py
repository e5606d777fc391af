"""Which of two methods is better, by the interval of their differences."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_5.exercises.interval import interval
from rlrobot_course.assignment_5.given import EARNED
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def verdict(first, second, t):
    low, high = interval(np.subtract(first, second), t)
    if low > 0:
        return "first"
    if high < 0:
        return "second"
    return "open"


LIKE = [x - 0.25 + 0.0625 * i for i, x in enumerate(EARNED)]  # a little less, nearly the same pair by pair

CHANGED, WITNESSES = read_answers(__file__, {"interval": interval, "right_interval": interval})

exercise = Exercise(
    task='return "first", "second" or "open"',
    right=verdict,
    returns="verdict",
    lenders={"interval": "your function of exercise 4"},
    tape=[
        {"first": EARNED, "second": LIKE, "t": 2.0},
        {"first": LIKE, "second": EARNED, "t": 2.0},
        {"first": EARNED, "second": EARNED[::-1], "t": 2.78},
        {"first": EARNED, "second": EARNED, "t": 2.78},
        {"first": [5.5, 6.25, 5.75], "second": [1.25, 0.5, 2.5], "t": 4.3},
        {"first": [1.25, 0.5, 2.5], "second": [5.5, 6.25, 5.75], "t": 4.3},
        {"first": [1.0, 3.5, 1.25, 2.5], "second": [1.5, 2.0, 1.5, 1.75], "t": 3.18},
        {"first": [1.5, 2.0, 1.5, 1.75], "second": [1.0, 3.5, 1.25, 2.5], "t": 3.18},
        {"first": [2.5, 2.75, 3.0, 3.5, 4.0, 4.5], "second": [2.625, 2.0, 2.25, 2.75, 3.0, 3.5], "t": 2.57},
    ],
    mistakes={
        "mean_alone": Mistake(
            "this only asks whose mean is larger, and chance alone makes one of them larger. Look at the interval.",
            {"low > 0": "low + high > 0", "high < 0": "low + high < 0"},
        ),
        "unpaired": Mistake(
            "the robots are compared as if they were strangers. Number i of both had the same world: take the "
            "differences of the pairs first.",
            CHANGED["unpaired"],
        ),
        "swapped": Mistake(
            "first and second have changed places.",
            {'return "first"': 'return "second"', 'return "second"': 'return "first"'},
        ),
        "zero_decides": Mistake(
            "an interval that reaches 0 leaves it open: only above 0, or below it, is decided.", {"low > 0": "low >= 0"}
        ),
        "never_second": Mistake(
            "this never finds the second better: what if the whole interval lies below 0?",
            {'return "second"': 'return "open"'},
        ),
        "never_open": Mistake(
            "this never leaves it open. Where the interval holds 0, nobody knows.", {'return "open"': 'return "second"'}
        ),
        "upper_end": Mistake(
            "low is the end nearer to minus infinity: first is better if even that end lies above 0.",
            {"low > 0": "high > 0"},
        ),
    },
    hints=(
        "Number i of both lists had the same luck with its world. What is left if you take one from the other?",
        "low, high = interval(np.subtract(first, second), t). Where does 0 lie?",
        'if low > 0: return "first"; if high < 0: return "second"; and below both return "open".',
    ),
    gained="Open is a result, too, and the honest one more often than papers tell.",
    witnesses=WITNESSES,
)
