"""Preferences: Q times 100 / Qmax."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def normalise(q_s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return q_s * 100 / q_max


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return q_s · 100 / Qmax, with Qmax = Rmax / (1 − γ)",
    right=normalise,
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
    mistakes={
        "largest_of_the_row": Mistake(
            "you divided by the largest value of the row. Qmax is the most that Q can ever become: Rmax / (1 − "
            "γ). It must not change from state to state.",
            {"r_max / (1 - gamma)": "q_s.max()"},
        ),
        "sum_of_the_row": Mistake(
            "this divides by the sum of the row. Qmax is Rmax / (1 − γ), the same in every state.",
            {"r_max / (1 - gamma)": "q_s.sum()"},
        ),
        "r_max_alone": Mistake(
            "this divides by the largest reward alone. Rewards add up over the steps: Qmax = Rmax / (1 − γ).",
            {" / (1 - gamma)": ""},
        ),
        "one_minus_gamma_multiplies": Mistake(
            "Qmax is Rmax / (1 − γ), larger than one reward. Did you multiply by 1 − γ where you should divide? "
            "Or are there brackets missing, as in 100 / r_max / (1 − γ)?",
            {"/ (1 - gamma)": "* (1 - gamma)"},
        ),
        "no_brackets": Mistake(
            "brackets: r_max / 1 − γ is r_max − γ. Write r_max / (1 − γ).", {"(1 - gamma)": "1 - gamma"}
        ),
        "one_plus_gamma": Mistake("below the line stands 1 − γ, not 1 + γ.", {"1 - gamma": "1 + gamma"}),
        "no_100": Mistake("the factor 100 is missing.", {" * 100": ""}),
        "gamma_for_one_minus_gamma": Mistake(
            "it is 1 − γ below the line, not γ.", {"100 / q_max": "100 * gamma / r_max"}
        ),
        "upside_down": Mistake(
            "the fraction is upside down: multiply by 100 and divide by Qmax.", {"100 / q_max": "q_max / 100"}
        ),
        "multiplies_by_both": Mistake(
            "multiply by 100 and divide by Qmax. You multiply by both.", {"/ q_max": "* q_max"}
        ),
        "one_stands_alone": Mistake(
            "brackets are missing around 1 − γ: here 1 stands alone, and γ is taken off at the end.",
            {"q_s * 100 / q_max": "q_s * 100 / r_max * 1 - gamma"},
        ),
        "adds": Mistake("the row is multiplied by 100 / Qmax. You add it.", {"q_s * 100": "q_s + 100"}),
        "q_max_itself": Mistake(
            "this is Qmax itself. Return x, an array: the row times 100 / Qmax.", {"q_s * 100 / q_max": "q_max"}
        ),
        "factor_itself": Mistake("this is 100 / Qmax, the factor. Multiply the row by it.", {"q_s * 100": "100"}),
        "own_gamma": Mistake("γ is an argument. Use it in place of the number 0.9.", {"1 - gamma": "1 - 0.9"}),
        "own_r_max": Mistake("r_max is an argument. Use it in place of a number.", {"r_max /": "10 /"}),
        "abs_of_q": Mistake("values below 0 stay below 0: leave the sign.", {"q_s *": "abs(q_s) *"}),
        "negative_as_0": Mistake(
            "values below 0 stay as they are: nothing is cut off.", {"q_s *": "np.maximum(q_s, 0) *"}
        ),
        "less_the_largest": Mistake(
            "this also subtracts the largest value. Only multiply.", {"q_s *": "(q_s - q_s.max()) *"}
        ),
        "unchanged": Mistake("nothing has been normalised: this is q_s itself.", {" * 100 / q_max": ""}),
    },
    hints=(
        "One factor for the whole row: it makes the largest Q that is possible 100.",
        "First q_max = r_max / (1 - gamma). Then the row, times 100, divided by it.",
        "return q_s * 100 / q_max, below the line that computes q_max.",
    ),
    gained="One temperature now fits rewards in any unit. The paper's agents use it for all four robots, and you will "
    "need it again in lesson 09.",
    witnesses=WITNESSES,
)
