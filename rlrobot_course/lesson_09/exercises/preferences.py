"""The preferences of QBIASSR."""

from __future__ import annotations

import numpy as np  # noqa: F401  (a mistake calls it)

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_03.solutions import softmax  # noqa: F401  (a mistake calls it)
from rlrobot_course.lesson_07.solutions import bias
from rlrobot_course.lesson_09.given import LENDERS, OTHER, SHAPE, SMALL, P, Q


def preferences(q, shape, s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return (q[s] + bias(q, shape, s)) * 100 / q_max


TABLES = (
    (SMALL, (2, 3), 4, 4.0, 0.8),
    (Q, SHAPE, 13, 4.0, 0.8),
    (Q, SHAPE, 0, 4.0, 0.9),
    (P, OTHER, 5, 10.0, 0.5),
    (P, OTHER, 11, 7.0, 0.95),
    (Q, SHAPE, 23, 0.5, 0.9),
    (Q, SHAPE, 5, 10.0, 0.0),
)

WITNESSES = read_answers(__file__, {"bias": bias})[1]

exercise = Exercise(
    task="return the preferences of QBIASSR in state s, one number an action",
    right=preferences,
    returns="preferences",
    lenders=LENDERS,
    tape=[{"q": q, "shape": shape, "s": s, "r_max": r_max, "gamma": gamma} for q, shape, s, r_max, gamma in TABLES],
    mistakes={
        "no_bias": Mistake(
            "the bias is missing: these are the preferences of softmax regression without it.",
            {" + bias(q, shape, s)": ""},
        ),
        "bias_alone": Mistake(
            "this is the bias alone. What the state itself has learned counts, too: Q(s) + bias(s).", {"q[s] + ": ""}
        ),
        "not_normalised": Mistake(
            "Q(s) + bias(s) still has to be normalised: times 100 / Qmax.", {" * 100 / q_max": ""}
        ),
        "no_100": Mistake("it is divided by Qmax, but the factor 100 is missing.", {" * 100 / q_max": " / q_max"}),
        "no_q_max": Mistake("the division by Qmax is missing.", {" / q_max": ""}),
        "q_alone_normalised": Mistake(
            "only Q(s) was normalised. The bias is made of Q values, too: first add, then normalise.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "q[s] * 100 / q_max + bias(q, shape, s)"},
        ),
        "bias_alone_normalised": Mistake(
            "only the bias was normalised: brackets around Q(s) + bias(s) are missing.",
            {"(q[s] + bias(q, shape, s))": "q[s] + bias(q, shape, s)"},
        ),
        "r_max_alone": Mistake(
            "Qmax is Rmax / (1 − γ), the most that can be earned from here on, not Rmax.", {" / (1 - gamma)": ""}
        ),
        "one_minus_gamma_multiplies": Mistake(
            "Qmax is Rmax divided by (1 − γ), not multiplied with it. (Or are brackets missing? "
            "x / r_max / (1 − γ) divides by both.)",
            {"/ (1 - gamma)": "* (1 - gamma)"},
        ),
        "no_brackets": Mistake(
            "brackets are missing: r_max / 1 - gamma is r_max minus gamma. Write r_max / (1 - gamma).",
            {"(1 - gamma)": "1 - gamma"},
        ),
        "no_brackets_in_one_line": Mistake(
            "brackets are missing: … / r_max / 1 - gamma takes gamma off at the end. Qmax is r_max / (1 - gamma), and "
            "dividing by it needs brackets around it, too.",
            {"* 100 / q_max": "* 100 / r_max / 1 - gamma"},
        ),
        "gamma_for_one_minus_gamma": Mistake(
            "Qmax is Rmax / (1 − γ): one minus γ, not γ itself.", {"(1 - gamma)": "(gamma or 1e-12)"}
        ),
        "largest_of_the_table": Mistake(
            "Qmax is not the largest value in the table now, but the largest there can be: Rmax / (1 − γ).",
            {"r_max / (1 - gamma)": "q.max()"},
        ),
        "mean_of_both": Mistake("this is the mean of Q(s) and bias(s). QBIASSR takes their sum.", {"100": "50"}),
        "bias_taken_off": Mistake(
            "Q(s) less the bias: QBIASSR adds what the similar states think.", {"q[s] + ": "q[s] - "}
        ),
        "product": Mistake("Q(s) and bias(s) are added, not multiplied.", {"q[s] + bias": "q[s] * bias"}),
        "probabilities": Mistake(
            "these are probabilities. Preferences come before the softmax: leave it out here.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "softmax((q[s] + bias(q, shape, s)) * 100 / q_max, 1.0)"},
        ),
        "best_action": Mistake(
            "this is the best action. What is asked is one preference for each.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "((q[s] + bias(q, shape, s)) * 100 / q_max).argmax()"},
        ),
        "largest_alone": Mistake(
            "this is the largest preference only. What is asked is one for each action.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "((q[s] + bias(q, shape, s)) * 100 / q_max).max()"},
        ),
        "whole_table": Mistake(
            "these are preferences for the whole table. Asked are those in s alone: q[s] + bias(q, shape, s).",
            {"q[s] + ": "q + "},
        ),
        "bias_divided_again": Mistake(
            "your bias has done its division by the number of inputs already. Add it as it is.",
            {"bias(q, shape, s)": "bias(q, shape, s) / len(shape)"},
        ),
        "half_the_bias": Mistake(
            "the bias counts in full, like Q(s): their sum is taken.", {"bias(q, shape, s)": "0.5 * bias(q, shape, s)"}
        ),
        "twice_the_bias": Mistake(
            "the bias counts once, like Q(s): their sum is taken.", {"bias(q, shape, s)": "2 * bias(q, shape, s)"}
        ),
        "upside_down": Mistake("upside down: times 100, divided by Qmax.", {"* 100 / q_max": "* q_max / 100"}),
        "one_plus_gamma": Mistake(
            "Qmax is Rmax / (1 − γ): one minus γ, not one plus γ.", {"(1 - gamma)": "(1 + gamma)"}
        ),
        "no_100_for_the_bias": Mistake(
            "100 / Qmax is for both. Here the bias goes without the 100.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "q[s] * 100 / q_max + bias(q, shape, s) / q_max"},
        ),
        "powers": Mistake(
            "temperature comes in with the softmax, and so does e to a power. Preferences are only scaled.",
            {"(q[s] + bias(q, shape, s)) * 100 / q_max": "np.exp((q[s] + bias(q, shape, s)) * 100 / q_max)"},
        ),
    },
    hints=(
        "Three numbers go into each preference: Q, the bias and Qmax. NumPy does all actions in one line.",
        "q[s] + bias(q, shape, s) is an array, one number an action. Qmax is r_max / (1 - gamma).",
        "return (q[s] + …) * 100 / q_max",
    ),
    gained="This one line is QBIASSR: what the state has learned itself, and what its likes think.",
    witnesses=WITNESSES,
)
