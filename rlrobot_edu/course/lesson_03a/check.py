"""Exercises of lesson 03a: temperatures and units."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.lesson_03a import solutions

temperature_for = Exercise(
    task="return the temperature at which an action whose x is larger by gap is odds times as probable",
    right=solutions.temperature_for,
    returns="T",
    tape=[
        {"gap": gap, "odds": odds}
        for gap, odds in ((2.0, 9.0), (10.0, 100.0), (0.5, 20.0), (1.0, math.e), (30.0, 1.5), (4.0, 2.0), (0.3, 1.01))
    ],
    mistakes=[
        Mistake("np.log10 is the logarithm to base 10. Softmax is made of powers of e, and their inverse is np.log.",
                {"np.log(": "np.log10("}),
        Mistake("np.log2 is the logarithm to base 2. Softmax is made of powers of e, and their inverse is np.log.",
                {"np.log(": "np.log2("}),
        Mistake("nothing is added to the odds before the logarithm (np.log1p adds 1).", {"np.log(": "np.log1p("}),
        Mistake("the inverse of e^y is the logarithm: np.log, not np.exp.", {"np.log(": "np.exp("}),
        Mistake("you found 1 / T. Turn the fraction round.", {"gap / np.log(odds)": "np.log(odds) / gap"}),
        Mistake("odds = e^(gap/T). To get at T, take the logarithm of both sides first.", {"np.log(odds)": "odds"}),
        Mistake("odds = e^(gap/T). To get at T, take the logarithm of both sides first.",
                {"gap / np.log(odds)": "odds / gap"}),
        Mistake("larger odds need a lower temperature. Here T grows with the odds: check how you isolated T.",
                {"/": "*"}),
        Mistake("the logarithm is of the odds alone, not of gap / odds: first gap / T = log(odds), then T.",
                {"gap / np.log(odds)": "np.log(gap / odds)"}),
        Mistake("the logarithm is of the odds, not of the gap: gap / T = log(odds).",
                {"gap / np.log(odds)": "np.log(gap) / odds"}),
        Mistake("take the logarithm of the odds, and leave the gap as it is.",
                {"gap / np.log(odds)": "np.log(gap) / np.log(odds)"}),
        Mistake("these are the odds at T = gap, or at T = 1. What is asked is the T that leads to the given odds.",
                {"gap / np.log(odds)": "np.exp(gap / odds)"}),
        Mistake("log(odds) is gap / T, a quotient. So divide the gap by it, where you take it off.", {"/": "-"}),
        Mistake("the gap is an argument: it is not always 1.", {"gap /": "1 /"}),
        Mistake("this is gap / T. One step is left to T itself.", {"gap / ": ""}),
        Mistake("the sign: the logarithm of odds above 1 is positive, and so is T.", {"gap /": "-gap /"}),
        Mistake("odds compare two actions with each other. They are no probability: take the logarithm of odds itself.",
                {"np.log(odds)": "np.log(odds / (1 + odds))"}),
    ],
    hints=(
        "odds = P(a) / P(b) = e^(gap / T). T stands in an exponent: which function brings it down?",
        "The logarithm of both sides: log(odds) = gap / T. Now solve for T.",
        "T is the gap divided by np.log of the odds.",
    ),
    gained="You can now design a temperature: say how often the second best may be taken, and T follows.",
)  # fmt: skip

normalise = Exercise(
    task="return q_s · 100 / Qmax, with Qmax = Rmax / (1 − γ)",
    right=solutions.normalise,
    returns="x",
    tape=[
        {"q_s": np.array(q_s), "r_max": r_max, "gamma": gamma}
        for q_s, r_max, gamma in (
            ([5.0, 2.5, -1.0], 1.0, 0.9),
            ([30.0, 10.0, 0.0, -7.123], 10.0, 0.5),
            ([3.0, 7.0], 5.0, 0.99),
            ([8.0, -2.0], 10.0, 0.0),
            ([60.0, 40.0, 1.0], 10.0, 0.9),
            ([-0.31, -0.12, -1.7, -0.4], 0.3, 0.7),
            ([0.0, 0.0, 0.0], 2.0, 0.8),
        )
    ],
    mistakes=[
        Mistake("you divided by the largest value of the row. Qmax is the most that Q can ever become: Rmax / (1 − "
                "γ). It must not change from state to state.", {"r_max / (1 - gamma)": "q_s.max()"}),
        Mistake("this divides by the sum of the row. Qmax is Rmax / (1 − γ), the same in every state.",
                {"r_max / (1 - gamma)": "q_s.sum()"}),
        Mistake("this divides by the largest reward alone. Rewards add up over the steps: Qmax = Rmax / (1 − γ).",
                {" / (1 - gamma)": ""}),
        Mistake("Qmax is Rmax / (1 − γ), larger than one reward. Did you multiply by 1 − γ where you should divide? "
                "Or are there brackets missing, as in 100 / r_max / (1 − γ)?", {"/ (1 - gamma)": "* (1 - gamma)"}),
        Mistake("brackets: r_max / 1 − γ is r_max − γ. Write r_max / (1 − γ).", {"(1 - gamma)": "1 - gamma"}),
        Mistake("below the line stands 1 − γ, not 1 + γ.", {"1 - gamma": "1 + gamma"}),
        Mistake("the factor 100 is missing.", {" * 100": ""}),
        Mistake("it is 1 − γ below the line, not γ.", {"100 / q_max": "100 * gamma / r_max"}),
        Mistake("the fraction is upside down: multiply by 100 and divide by Qmax.", {"100 / q_max": "q_max / 100"}),
        Mistake("multiply by 100 and divide by Qmax. You multiply by both.", {"/ q_max": "* q_max"}),
        Mistake("brackets are missing around 1 − γ: here 1 stands alone, and γ is taken off at the end.",
                {"q_s * 100 / q_max": "q_s * 100 / r_max * 1 - gamma"}),
        Mistake("the row is multiplied by 100 / Qmax. You add it.", {"q_s * 100": "q_s + 100"}),
        Mistake("this is Qmax itself. Return x, an array: the row times 100 / Qmax.", {"q_s * 100 / q_max": "q_max"}),
        Mistake("this is 100 / Qmax, the factor. Multiply the row by it.", {"q_s * 100": "100"}),
        Mistake("γ is an argument. Use it in place of the number 0.9.", {"1 - gamma": "1 - 0.9"}),
        Mistake("r_max is an argument. Use it in place of a number.", {"r_max /": "10 /"}),
        Mistake("values below 0 stay below 0: leave the sign.", {"q_s *": "abs(q_s) *"}),
        Mistake("values below 0 stay as they are: nothing is cut off.", {"q_s *": "np.maximum(q_s, 0) *"}),
        Mistake("this also subtracts the largest value. Only multiply.", {"q_s *": "(q_s - q_s.max()) *"}),
        Mistake("nothing has been normalised: this is q_s itself.", {" * 100 / q_max": ""}),
    ],
    hints=(
        "One factor for the whole row: it makes the largest Q that is possible 100.",
        "First q_max = r_max / (1 - gamma). Then the row, times 100, divided by it.",
        "return q_s * 100 / q_max, below the line that computes q_max.",
    ),
    gained="One temperature now fits rewards in any unit. The paper's agents use it for all four robots, and you will "
    "need it again in lesson 09.",
)  # fmt: skip
