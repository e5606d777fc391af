"""The p-value of a permutation test."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import WHOLE_DIVISION


def p_value(observed, shuffled):
    return sum(f >= observed for f in shuffled) / len(shuffled)


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the share of the shuffled numbers that are at least as large as the observed one",
    right=p_value,
    returns="p",
    tape=[
        {"observed": observed, "shuffled": np.array(shuffled)}
        for observed, shuffled in (
            (3.0, [0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 3.0, 1.5]),
            (26.0, [0.5, 1.5, 2.5, 0.1]),
            (0.5, [0.5, 1.5, 2.5, 0.1, 0.9, 0.3, 0.2]),
            (0.05, [0.7, 1.5, 2.5]),
            (2.0, [2.0, 0.4, 0.1, 0.3, 0.8, 1.2, 0.0, 1.9, 0.6, 0.5, 0.2, 0.9, 1.1]),
        )
    ],
    mistakes={
        "smaller": Mistake(
            "this is the share that is smaller. A small p must mean: chance hardly ever gets that far.", {">=": "<"}
        ),
        "equal_left_out": Mistake("at least as large: those that equal the observed one count, too.", {">=": ">"}),
        "count": Mistake("this is how many they are; divide by how many were shuffled.", {" / len(shuffled)": ""}),
        "at_most": Mistake(
            "this is the share that is at most as large as the observed one: the other side.", {">=": "<="}
        ),
        "equal_alone": Mistake(
            "this is the share that equals the observed one. Those that are larger count, too.", {">=": "=="}
        ),
        "per_cent": Mistake("this is in per cent. A share lies between 0 and 1.", {"sum(": "100 * sum("}),
        "mean_of_the_shuffled": Mistake(
            "this is the mean of the shuffled numbers. Compare each with the observed one first.",
            {"f >= observed for f": "f for f"},
        ),
        "sum_of_the_larger": Mistake(
            "the numbers are added up that are at least as large. Count them.",
            {"f >= observed for f in shuffled": "f for f in shuffled if f >= observed"},
        ),
        "compared_with_the_mean": Mistake(
            "you compare with the mean of the shuffled numbers. Compare with each of them.",
            {"sum(f >= observed for f in shuffled)": "(shuffled.mean() >= observed) * len(shuffled)"},
        ),
        "one_more_above_and_below": Mistake(
            "(n + 1) / (N + 1) counts the observed one among the shuffled, as many books advise, so that p is never 0. "
            "Asked is the plain share.",
            {
                "sum(f >= observed for f in shuffled) / len(shuffled)": "(sum(f >= observed for f in shuffled) + 1) / "
                "(len(shuffled) + 1)"
            },
        ),
        "counts_the_observed": Mistake(
            "the observed one is not among the shuffled: divide by how many were shuffled.",
            {"len(shuffled)": "(len(shuffled) + 1)"},
        ),
        "own_number": Mistake(
            "divide by how many were shuffled, len(shuffled). It need not be 2000.", {"len(shuffled)": "2000"}
        ),
        "whole_division": Mistake(WHOLE_DIVISION, {"/": "//"}),
        "yes_or_no": Mistake(
            "this says whether chance gets that far at all. How often does it?",
            {"sum(f >= observed for f in shuffled) / len(shuffled)": "any(f >= observed for f in shuffled)"},
        ),
        "largest_compared": Mistake(
            "this is the largest of the shuffled numbers, compared. How many of them get that far?",
            {"sum(f >= observed for f in shuffled) / len(shuffled)": "observed / max(shuffled)"},
        ),
    },
    hints=(
        "Go through the shuffled numbers, count those that get as far as the observed one, and divide.",
        "shuffled >= observed is an array of True and False, and the mean of these is a share.",
        "return np.mean(shuffled >= …), or the same with sum and len.",
    ),
    gained="You have written the test behind every p of the paper, and it needs no table and no formula.",
    witnesses=WITNESSES,
)
