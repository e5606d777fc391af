"""An action chosen by QBIASSR."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case
from rlrobot_course.grading.shared_hints import OWN_GAMMA, OWN_R_MAX
from rlrobot_course.lesson_03.solutions import draw, softmax
from rlrobot_course.lesson_07.solutions import bias
from rlrobot_course.lesson_09.exercises.preferences import preferences
from rlrobot_course.lesson_09.given import LENDERS, OTHER, SHAPE, SMALL, P, Q


def choose(q, shape, s, temperature, r_max, gamma, u):
    return draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)


def at_the_border(q: np.ndarray, shape: tuple[int, ...], temperature: float, r_max: float, gamma: float) -> list[Case]:
    """Cases in which u lies just below, or just above, the border between two actions.

    So whoever computes other probabilities takes another action in one of the two.
    """
    cases: list[Case] = []
    for s in range(0, len(q), len(q) // 6):
        p = softmax(preferences(q, shape, s, r_max, gamma), temperature)
        border = min(np.cumsum(p)[:-1], key=lambda reached: abs(reached - 0.5))
        about = {"q": q, "shape": shape, "s": s, "temperature": temperature, "r_max": r_max, "gamma": gamma}
        if 0.05 < border < 0.95:
            cases += [about | {"u": round(float(border) + beside, 3)} for beside in (-0.02, 0.02)]
    return cases


CHOICES = [
    case
    for q, shape, temperature, r_max, gamma in (
        (SMALL, (2, 3), 12.0, 10.0, 0.8),
        (Q, SHAPE, 10.0, 4.0, 0.9),
        (P, OTHER, 12.0, 6.0, 0.8),
        (Q, SHAPE, 3.0, 20.0, 0.95),
        (P, OTHER, 20.0, 10.0, 0.5),
        (Q / 10, SHAPE, 0.5, 4.0, 0.9),
    )
    for case in at_the_border(q, shape, temperature, r_max, gamma)
]

WITNESSES = read_answers(__file__, {"bias": bias, "draw": draw, "preferences": preferences, "softmax": softmax})[1]

exercise = Exercise(
    task="return the action that QBIASSR takes in s, drawn with the number u",
    right=choose,
    returns="action",
    lenders={**LENDERS, "preferences": "the function of the exercise above: write it, and run its cell"},
    tape=CHOICES,
    mistakes={
        "always_the_best": Mistake(
            "the best action is not always taken: draw one, with the probabilities of the softmax.",
            {
                "draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": (
                    "int(preferences(q, shape, s, r_max, gamma).argmax())"
                )
            },
        ),
        "no_temperature": Mistake(
            "the temperature plays no part in your choice: it goes into the softmax.", {"temperature": "1.0"}
        ),
        "no_bias": Mistake(
            "your choice does not know the bias.",
            {"preferences(q, shape, s, r_max, gamma)": "q[s] * 100 * (1 - gamma) / r_max"},
        ),
        "q_alone": Mistake(
            "your choice knows neither the bias nor the normalisation: start from your preferences.",
            {"preferences(q, shape, s, r_max, gamma)": "q[s]"},
        ),
        "not_normalised": Mistake(
            "the preferences are not normalised by 100 / Qmax.",
            {"preferences(q, shape, s, r_max, gamma)": "q[s] + bias(q, shape, s)"},
        ),
        "equal": Mistake(
            "all actions are equally probable in your choice. Are the preferences handed to the softmax?",
            {"draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": "int(u * q.shape[1])"},
        ),
        "r_max_and_gamma_swapped": Mistake("r_max and gamma have changed places.", {"r_max, gamma": "gamma, r_max"}),
        "softmax_twice": Mistake(
            "the softmax comes after the preferences, and only once: here it is done twice.",
            {
                "softmax(preferences(q, shape, s, r_max, gamma), temperature)": (
                    "softmax(softmax(preferences(q, shape, s, r_max, gamma), temperature), temperature)"
                )
            },
        ),
        "no_softmax": Mistake(
            "draw wants probabilities, and got preferences: the softmax is missing.",
            {"softmax(preferences(q, shape, s, r_max, gamma), temperature)": "preferences(q, shape, s, r_max, gamma)"},
        ),
        "temperature_twice": Mistake(
            "the preferences are divided by the temperature twice: softmax does it already.",
            {"r_max, gamma), temperature": "r_max, gamma) / temperature, temperature"},
        ),
        "own_u": Mistake("the number that is drawn with is the argument u.", {", u)": ", 0.5)"}),
        "one_minus_u": Mistake(
            "draw takes u as it is, not 1 − u. (That would be as fair, but it is the argument u that decides.)",
            {", u)": ", 1 - u)"},
        ),
        "own_gamma": Mistake(OWN_GAMMA, {"r_max, gamma": "r_max, 0.9"}),
        "own_r_max": Mistake(OWN_R_MAX, {"r_max, gamma": "10, gamma"}),
        "u_and_temperature_swapped": Mistake(
            "u and the temperature have changed places: softmax takes the temperature, draw takes u.",
            {"temperature), u)": "u), temperature)"},
        ),
        "bias_twice": Mistake(
            "the bias is in the preferences already. Here it is added once more.",
            {"preferences(q, shape, s, r_max, gamma)": "preferences(q, shape, s, r_max, gamma) + bias(q, shape, s)"},
        ),
        "q_twice": Mistake(
            "Q(s) is in the preferences already. Here it is added once more.",
            {"preferences(q, shape, s, r_max, gamma)": "q[s] + preferences(q, shape, s, r_max, gamma)"},
        ),
        "one_over_temperature": Mistake(
            "softmax takes the temperature as it is, and divides by it itself.",
            {"temperature), u)": "1 / temperature), u)"},
        ),
        "each_alone": Mistake(
            "no single probability need be above u: they are added up until their sum is. Call your draw.",
            {
                "draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": (
                    "int((softmax(preferences(q, shape, s, r_max, gamma), temperature) > u).argmax())"
                )
            },
        ),
        "probabilities": Mistake(
            "these are the probabilities. Which action is taken with them? draw(…, u) says it.",
            {
                "draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": (
                    "softmax(preferences(q, shape, s, r_max, gamma), temperature)"
                )
            },
        ),
        "shares_of_preferences": Mistake(
            "preferences divided by their sum are no probabilities, for some may be negative. Call softmax.",
            {
                "softmax(preferences(q, shape, s, r_max, gamma), temperature)": (
                    "preferences(q, shape, s, r_max, gamma) / preferences(q, shape, s, r_max, gamma).sum()"
                )
            },
        ),
        "most_probable": Mistake(
            "the most probable action is not always taken: draw(…, u) takes each as often as it is probable.",
            {
                "draw(softmax(preferences(q, shape, s, r_max, gamma), temperature), u)": (
                    "softmax(preferences(q, shape, s, r_max, gamma), temperature)[int(u * q.shape[1])]"
                )
            },
        ),
    },
    hints=(
        "Three of your functions, one inside the other: preferences, then softmax, then draw.",
        "softmax(…, temperature) makes probabilities of the preferences; draw(…, u) takes an action.",
        "return draw(softmax(preferences(q, shape, s, r_max, gamma), …), …)",
    ),
    gained="Your robot decides now as the paper's does. What is missing is the loop in which it lives.",
    witnesses=WITNESSES,
)
