"""Exercises of lesson 09, TOSL+QBIASSR: how it chooses stands here, how it learns in `learners`."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.lesson_09 import solutions
from rlrobot_edu.course.lesson_09.learners import LENDERS, learn, learn_and_evade

__all__ = ["choose", "learn", "learn_and_evade", "preferences"]

SMALL = np.array([[1.0, -2.0], [4.0, 0.5], [7.0, 3.0], [0.0, 6.0], [5.0, 2.5], [-8.0, 9.0]])  # shown in full
SHAPE, OTHER = (2, 2, 3, 2), (3, 4)
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
P = np.random.default_rng(4).normal(-1.0, 5.0, size=(12, 4)).round(1)
TABLES = ((SMALL, (2, 3), 4, 4.0, 0.8), (Q, SHAPE, 13, 4.0, 0.8), (Q, SHAPE, 0, 4.0, 0.9), (P, OTHER, 5, 10.0, 0.5),
          (P, OTHER, 11, 7.0, 0.95), (Q, SHAPE, 23, 0.5, 0.9), (Q, SHAPE, 5, 10.0, 0.0))  # fmt: skip

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
        Mistake("these are preferences for the whole table. Asked are those in s alone: q[s] + bias(q, shape, s).",
                {"q[s] + ": "q + "}),
        Mistake("your bias has done its division by the number of inputs already. Add it as it is.",
                {"bias(q, shape, s)": "bias(q, shape, s) / len(shape)"}),
        Mistake("the bias counts in full, like Q(s): their sum is taken.",
                {"bias(q, shape, s)": "0.5 * bias(q, shape, s)"}),
        Mistake("the bias counts once, like Q(s): their sum is taken.",
                {"bias(q, shape, s)": "2 * bias(q, shape, s)"}),
        Mistake("upside down: times 100, divided by Qmax.", {"* 100 / q_max": "* q_max / 100"}),
        Mistake("Qmax is Rmax / (1 − γ): one minus γ, not one plus γ.", {"(1 - gamma)": "(1 + gamma)"}),
        Mistake("100 / Qmax is for both. Here the bias goes without the 100.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "q[s] * 100 / q_max + bias(q, shape, s) / q_max"}),
        Mistake("temperature comes in with the softmax, and so does e to a power. Preferences are only scaled.",
                {"(q[s] + bias(q, shape, s)) * 100 / q_max": "np.exp((q[s] + bias(q, shape, s)) * 100 / q_max)"}),
    ],
    hints=(
        "Three numbers go into each preference: Q, the bias and Qmax. NumPy does all actions in one line.",
        "q[s] + bias(q, shape, s) is an array, one number an action. Qmax is r_max / (1 - gamma).",
        "return (q[s] + …) * 100 / q_max",
    ),
    gained="This one line is QBIASSR: what the state has learned itself, and what its likes think.",
)  # fmt: skip


def at_the_border(q: np.ndarray, shape: tuple[int, ...], temperature: float, r_max: float, gamma: float) -> list[Case]:
    """Cases in which u lies just below, or just above, the border between two actions.

    So whoever computes other probabilities takes another action in one of the two.
    """
    cases: list[Case] = []
    for s in range(0, len(q), len(q) // 6):
        p = solutions.softmax(solutions.preferences(q, shape, s, r_max, gamma), temperature)
        border = min(np.cumsum(p)[:-1], key=lambda reached: abs(reached - 0.5))
        about = {"q": q, "shape": shape, "s": s, "temperature": temperature, "r_max": r_max, "gamma": gamma}
        if 0.05 < border < 0.95:
            cases += [about | {"u": round(float(border) + beside, 3)} for beside in (-0.02, 0.02)]
    return cases


CHOICES = [
    case
    for q, shape, temperature, r_max, gamma in ((SMALL, (2, 3), 12.0, 10.0, 0.8), (Q, SHAPE, 10.0, 4.0, 0.9),
                                                (P, OTHER, 12.0, 6.0, 0.8), (Q, SHAPE, 3.0, 20.0, 0.95),
                                                (P, OTHER, 20.0, 10.0, 0.5), (Q / 10, SHAPE, 0.5, 4.0, 0.9))
    for case in at_the_border(q, shape, temperature, r_max, gamma)
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
        Mistake("draw takes u as it is, not 1 − u. (That would be as fair, but it is the argument u that decides.)",
                {", u)": ", 1 - u)"}),
        Mistake("γ is the argument gamma, not always 0.9.", {"r_max, gamma": "r_max, 0.9"}),
        Mistake("Rmax is the argument r_max, not always 10.", {"r_max, gamma": "10, gamma"}),
        Mistake("u and the temperature have changed places: softmax takes the temperature, draw takes u.",
                {"temperature), u)": "u), temperature)"}),
        Mistake("the bias is in the preferences already. Here it is added once more.",
                {"preferences(q, shape, s, r_max, gamma)":
                 "preferences(q, shape, s, r_max, gamma) + bias(q, shape, s)"}),
        Mistake("Q(s) is in the preferences already. Here it is added once more.",
                {"preferences(q, shape, s, r_max, gamma)": "q[s] + preferences(q, shape, s, r_max, gamma)"}),
        Mistake("softmax takes the temperature as it is, and divides by it itself.",
                {"temperature), u)": "1 / temperature), u)"}),
        Mistake("no single probability need be above u: they are added up until their sum is. Call your draw.",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)":
                 "int((softmax(preferences(q, shape, s, r_max, gamma), temperature) > u).argmax())"}),
        Mistake("these are the probabilities. Which action is taken with them? draw(…, u) says it.",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)":
                 "softmax(preferences(q, shape, s, r_max, gamma), temperature)"}),
        Mistake("preferences divided by their sum are no probabilities, for some may be negative. Call softmax.",
                {"softmax(preferences(q, shape, s, r_max, gamma), temperature)":
                 "preferences(q, shape, s, r_max, gamma) / preferences(q, shape, s, r_max, gamma).sum()"}),
        Mistake("the most probable action is not always taken: draw(…, u) takes each as often as it is probable.",
                {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)":
                 "softmax(preferences(q, shape, s, r_max, gamma), temperature)[int(u * q.shape[1])]"}),
    ],
    hints=(
        "Three of your functions, one inside the other: preferences, then softmax, then draw.",
        "softmax(…, temperature) makes probabilities of the preferences; draw(…, u) takes an action.",
        "return draw(softmax(preferences(q, shape, s, r_max, gamma), …), …)",
    ),
    gained="Your robot decides now as the paper's does. What is missing is the loop in which it lives.",
)  # fmt: skip
