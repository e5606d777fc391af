"""Exercises of lesson 09, TOSL+QBIASSR: how it chooses stands here, how it learns in `learners`."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.lesson_09 import solutions
from rlrobot_edu.course.lesson_09.learners import LENDERS, learn, learn_and_evade

__all__ = ["choose", "learn", "learn_and_evade", "preferences"]

SHAPE, OTHER = (2, 2, 3, 2), (3, 4)
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
P = np.random.default_rng(4).normal(-1.0, 5.0, size=(12, 4)).round(1)
TABLES = ((Q, SHAPE, 13, 4.0, 0.8), (Q, SHAPE, 0, 4.0, 0.9), (P, OTHER, 5, 10.0, 0.5), (P, OTHER, 11, 7.0, 0.95),
          (Q, SHAPE, 23, 0.5, 0.9), (Q, SHAPE, 5, 10.0, 0.0))  # fmt: skip

preferences = Exercise(
    task="return the preferences of QBIASSR in state s, one number an action",
    right=solutions.preferences,
    returns="preferences",
    lenders=LENDERS,
    tape=[{"q": q, "shape": shape, "s": s, "r_max": r_max, "gamma": gamma} for q, shape, s, r_max, gamma in TABLES],
    mistakes=[
        Mistake("the bias is missing: these are the preferences of softmax regression without it.",
                {" + bias(q, shape, s)": ""}),
        Mistake("this is the bias alone. What the state itself has learned counts, too: Q(s) + bias(s).",
                {"q[s] + ": ""}),
        Mistake("Q(s) + bias(s) still has to be normalised: times 100 / Qmax.", {" * 100 / q_max": ""}),
        Mistake("it is divided by Qmax, but the factor 100 is missing.", {" * 100 / q_max": " / q_max"}),
        Mistake("the division by Qmax is missing.", {" / q_max": ""}),
        Mistake("only Q(s) was normalised. The bias is made of Q values, too: first add, then normalise.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "q[s] * 100 / q_max + bias(q, shape, s)"}),
        Mistake("only the bias was normalised: brackets around Q(s) + bias(s) are missing.",
                {"(q[s] + bias(q, shape, s))": "q[s] + bias(q, shape, s)"}),
        Mistake("Qmax is Rmax / (1 − γ), the most that can be earned from here on, not Rmax.", {" / (1 - gamma)": ""}),
        Mistake("Qmax is Rmax divided by (1 − γ), not multiplied with it. (Or are brackets missing? "
                "x / r_max / (1 − γ) divides by both.)", {"/ (1 - gamma)": "* (1 - gamma)"}),
        Mistake("brackets are missing: r_max / 1 - gamma is r_max minus gamma. Write r_max / (1 - gamma).",
                {"(1 - gamma)": "1 - gamma"}),
        Mistake("Qmax is Rmax / (1 − γ): one minus γ, not γ itself.", {"(1 - gamma)": "(gamma or 1e-12)"}),
        Mistake("Qmax is not the largest value in the table now, but the largest there can be: Rmax / (1 − γ).",
                {"r_max / (1 - gamma)": "q.max()"}),
        Mistake("this is the mean of Q(s) and bias(s). QBIASSR takes their sum.", {"100": "50"}),
        Mistake("Q(s) less the bias: QBIASSR adds what the similar states think.", {"q[s] + ": "q[s] - "}),
        Mistake("Q(s) and bias(s) are added, not multiplied.", {"q[s] + bias": "q[s] * bias"}),
        Mistake("these are probabilities. Preferences come before the softmax: leave it out here.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max":
                 "softmax((q[s] + bias(q, shape, s)) * 100 / q_max, 1.0)"}),
        Mistake("this is the best action. What is asked is one preference for each.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "((q[s] + bias(q, shape, s)) * 100 / q_max).argmax()"}),
        Mistake("this is the largest preference only. What is asked is one for each action.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "((q[s] + bias(q, shape, s)) * 100 / q_max).max()"}),
    ],
    hints=(
        "Three numbers go into each preference: Q, the bias and Qmax. NumPy does all actions in one line.",
        "q[s] + bias(q, shape, s) is an array, one number an action. Qmax is r_max / (1 - gamma).",
        "return (q[s] + …) * 100 / q_max",
    ),
    gained="This one line is QBIASSR: what the state has learned itself, and what its likes think.",
)  # fmt: skip

# values so close to one another, and numbers u so spread, that every wrong way to choose shows somewhere
CHOICES = [
    {"q": q / 10, "shape": shape, "s": s, "temperature": temperature, "r_max": r_max, "gamma": gamma, "u": u}
    for q, shape, temperature, r_max, gamma in ((Q, SHAPE, 0.4, 4.0, 0.9), (P, OTHER, 3.0, 6.0, 0.8),
                                                (Q, SHAPE, 3.0, 2.0, 0.95), (P, OTHER, 0.8, 10.0, 0.5))
    for s, u in zip((0, 2, 3, 5, 6, 8, 9, 11), (0.5, 0.05, 0.95, 0.3, 0.7, 0.6, 0.85, 0.15), strict=True)
]  # fmt: skip

choose = Exercise(
    task="return the action that QBIASSR takes in s, drawn with the number u",
    right=solutions.choose,
    returns="action",
    lenders={**LENDERS, "preferences": "the function of the exercise above: write it, and run its cell"},
    tape=CHOICES,
    mistakes=[
        Mistake("the best action is not always taken: draw one, with the probabilities of the softmax.",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)":
                 "int(preferences(q, shape, s, r_max, gamma).argmax())"}),
        Mistake("the temperature plays no part in your choice: it goes into the softmax.", {"temperature": "1.0"}),
        Mistake("your choice does not know the bias.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s] * 100 * (1 - gamma) / r_max"}),
        Mistake("your choice knows neither the bias nor the normalisation: start from your preferences.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s]"}),
        Mistake("the preferences are not normalised by 100 / Qmax.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s] + bias(q, shape, s)"}),
        Mistake("all actions are equally probable in your choice. Are the preferences handed to the softmax?",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": "int(u * q.shape[1])"}),
        Mistake("r_max and gamma have changed places.", {"r_max, gamma": "gamma, r_max"}),
        Mistake("the softmax comes after the preferences, and only once: here it is done twice.",
                {"softmax(preferences(q, shape, s, r_max, gamma), temperature)":
                 "softmax(softmax(preferences(q, shape, s, r_max, gamma), temperature), temperature)"}),
        Mistake("draw wants probabilities, and got preferences: the softmax is missing.",
                {"softmax(preferences(q, shape, s, r_max, gamma), temperature)":
                 "preferences(q, shape, s, r_max, gamma)"}),
        Mistake("the preferences are divided by the temperature twice: softmax does it already.",
                {"r_max, gamma), temperature": "r_max, gamma) / temperature, temperature"}),
        Mistake("the number that is drawn with is the argument u.", {", u)": ", 0.5)"}),
        Mistake("γ is the argument gamma, not always 0.9.", {"r_max, gamma": "r_max, 0.9"}),
        Mistake("Rmax is the argument r_max, not always 10.", {"r_max, gamma": "10, gamma"}),
    ],
    hints=(
        "Three of your functions, one inside the other: preferences, then softmax, then draw.",
        "softmax(…, temperature) makes probabilities of the preferences; draw(…, u) takes an action.",
        "return draw(softmax(preferences(q, shape, s, r_max, gamma), …), …)",
    ),
    gained="Your robot decides now as the paper's does. What is missing is the loop in which it lives.",
)  # fmt: skip
