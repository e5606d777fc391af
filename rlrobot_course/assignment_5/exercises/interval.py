"""The confidence interval of a mean."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_5.given import EARNED
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def interval(values, t):
    mean, n = np.mean(values), len(values)
    half = t * np.std(values, ddof=1) / np.sqrt(n)
    return [mean - half, mean + half]


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the two ends of the interval of the mean",
    right=interval,
    returns="interval",
    tape=[
        {"values": EARNED, "t": 2.78},
        {"values": [0.5, -1.5], "t": 12.7},
        {"values": [1.25, 1.25, 1.25], "t": 4.3},
        {"values": [10.5, 0.25, -3.5, 8.75, 2.0, 2.25, 1.5], "t": 2.45},
        {"values": [-0.5, -0.75, -1.0, -0.25], "t": 3.18},
    ],
    mistakes={
        "divides_by_n": Mistake("divide the sum of squares by n − 1, not by n: np.std(…, ddof=1).", {", ddof=1": ""}),
        "spread_of_robots": Mistake(
            "this is how far single robots spread. The mean of n is surer: divide by the root of n.",
            {" / np.sqrt(n)": ""},
        ),
        "no_root": Mistake("the spread of a mean goes with the root of n, not with n.", {"np.sqrt(n)": "n"}),
        "no_t": Mistake("t is missing.", {"t * ": ""}),
        "variance": Mistake("this is the variance. Take its root, the standard deviation.", {"np.std": "np.var"}),
        "around_0": Mistake(
            "these are the ends of an interval around 0. Add the mean.", {"[mean - half, mean + half]": "[-half, half]"}
        ),
        "half_alone": Mistake(
            "asked are the two ends, the lower first: mean − half and mean + half.",
            {"[mean - half, mean + half]": "[mean, half]"},
        ),
        "ends_swapped": Mistake(
            "the lower end comes first.", {"[mean - half, mean + half]": "[mean + half, mean - half]"}
        ),
        "twice_as_wide": Mistake(
            "the interval is twice as wide as it should be: half of it lies on each side.", {"half = t": "half = 2 * t"}
        ),
        "median": Mistake(
            "this is the median. The interval is around the mean.", {"np.mean(values)": "np.median(values)"}
        ),
        "extremes": Mistake(
            "these are the smallest and the largest value. The interval is that of their mean.",
            {"[mean - half, mean + half]": "[np.min(values), np.max(values)]"},
        ),
    },
    hints=(
        "Mean first. Then half the width: t times the standard deviation of one robot, divided by the root of n.",
        "np.std(values, ddof=1) divides by n − 1, and np.sqrt(len(values)) is the root of n.",
        "half = t * np.std(values, ddof=1) / np.sqrt(n), and then [mean - half, …].",
    ),
    gained="With four times as many robots it is half as wide: that is what a second decimal costs.",
    witnesses=WITNESSES,
)
