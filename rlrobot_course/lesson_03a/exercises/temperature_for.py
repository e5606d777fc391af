"""The temperature at which one action is so many times as probable as another."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def temperature_for(gap, odds):
    return gap / np.log(odds)


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the temperature at which an action whose x is larger by gap is odds times as probable",
    right=temperature_for,
    returns="T",
    tape=[
        {"gap": gap, "odds": odds}
        for gap, odds in ((2.0, 9.0), (10.0, 100.0), (0.5, 20.0), (1.0, math.e), (30.0, 1.5), (4.0, 2.0), (0.3, 1.01))
    ],
    mistakes={
        "log10": Mistake(
            "np.log10 is the logarithm to base 10. Softmax is made of powers of e, and their inverse is np.log.",
            {"np.log(": "np.log10("},
        ),
        "log2": Mistake(
            "np.log2 is the logarithm to base 2. Softmax is made of powers of e, and their inverse is np.log.",
            {"np.log(": "np.log2("},
        ),
        "log1p": Mistake(
            "nothing is added to the odds before the logarithm (np.log1p adds 1).", {"np.log(": "np.log1p("}
        ),
        "exp": Mistake("the inverse of e^y is the logarithm: np.log, not np.exp.", {"np.log(": "np.exp("}),
        "upside_down": Mistake(
            "you found 1 / T. Turn the fraction round.", {"gap / np.log(odds)": "np.log(odds) / gap"}
        ),
        "no_logarithm": Mistake(
            "odds = e^(gap/T). To get at T, take the logarithm of both sides first.", {"np.log(odds)": "odds"}
        ),
        "no_logarithm_upside_down": Mistake(
            "odds = e^(gap/T). To get at T, take the logarithm of both sides first.",
            {"gap / np.log(odds)": "odds / gap"},
        ),
        "multiplies": Mistake(
            "larger odds need a lower temperature. Here T grows with the odds: check how you isolated T.", {"/": "*"}
        ),
        "log_of_the_quotient": Mistake(
            "the logarithm is of the odds alone, not of gap / odds: first gap / T = log(odds), then T.",
            {"gap / np.log(odds)": "np.log(gap / odds)"},
        ),
        "log_of_the_gap": Mistake(
            "the logarithm is of the odds, not of the gap: gap / T = log(odds).",
            {"gap / np.log(odds)": "np.log(gap) / odds"},
        ),
        "both_logs": Mistake(
            "take the logarithm of the odds, and leave the gap as it is.",
            {"gap / np.log(odds)": "np.log(gap) / np.log(odds)"},
        ),
        "odds_of_a_temperature": Mistake(
            "these are the odds at T = gap, or at T = 1. What is asked is the T that leads to the given odds.",
            {"gap / np.log(odds)": "np.exp(gap / odds)"},
        ),
        "subtracts": Mistake(
            "log(odds) is gap / T, a quotient. So divide the gap by it, where you take it off.", {"/": "-"}
        ),
        "own_gap": Mistake("the gap is an argument: it is not always 1.", {"gap /": "1 /"}),
        "stops_before_t": Mistake("this is gap / T. One step is left to T itself.", {"gap / ": ""}),
        "negative": Mistake("the sign: the logarithm of odds above 1 is positive, and so is T.", {"gap /": "-gap /"}),
        "log_of_a_probability": Mistake(
            "odds compare two actions with each other. They are no probability: take the logarithm of odds itself.",
            {"np.log(odds)": "np.log(odds / (1 + odds))"},
        ),
    },
    hints=(
        "odds = P(a) / P(b) = e^(gap / T). T stands in an exponent: which function brings it down?",
        "The logarithm of both sides: log(odds) = gap / T. Now solve for T.",
        "T is the gap divided by np.log of the odds.",
    ),
    gained="You can now design a temperature: say how often the second best may be taken, and T follows.",
    witnesses=WITNESSES,
)
