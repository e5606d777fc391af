"""Exercises of lesson 09: all pieces together, TOSL+QBIASSR."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake
from rlrobot_edu.course.grading.tapes import draw
from rlrobot_edu.course.lesson_09.tosl_loop import learn, learn_and_evade
from rlrobot_edu.learning.qbiassr import bias_of
from rlrobot_edu.learning.softmax import probabilities

__all__ = ["choose", "learn", "learn_and_evade", "p_value", "preferences"]

SHAPE = (2, 2, 3, 2)
Q = np.random.default_rng(9).normal(3.0, 6.0, size=(24, 3)).round(1)
R_MAX, GAMMA = 4.0, 0.9


def _preferences(q, shape, s, r_max, gamma):
    return (q[s] + bias_of(q, shape, s)) * 100 * (1 - gamma) / r_max


preferences = Exercise(
    task="return the preferences of QBIASSR in state s, one number an action",
    right=_preferences,
    returns="preferences",
    tape=[{"q": Q, "shape": SHAPE, "s": s, "r_max": R_MAX, "gamma": GAMMA} for s in (0, 5, 13, 23)],
    mistakes=[
        Mistake("the bias is missing: these are the preferences of softmax regression without it.",
                lambda q, shape, s, r_max, gamma: q[s] * 100 * (1 - gamma) / r_max),
        Mistake("this is the bias alone. What the state itself has learned counts, too: Q(s) + bias(s).",
                lambda q, shape, s, r_max, gamma: bias_of(q, shape, s) * 100 * (1 - gamma) / r_max),
        Mistake("Q(s) + bias(s) still has to be normalised: times 100 / Qmax.",
                lambda q, shape, s, r_max, gamma: q[s] + bias_of(q, shape, s)),
        Mistake("only Q(s) was normalised. The bias is made of Q values, too: first add, then normalise.",
                lambda q, shape, s, r_max, gamma: q[s] * 100 * (1 - gamma) / r_max + bias_of(q, shape, s)),
        Mistake("only the bias was normalised: brackets around Q(s) + bias(s) are missing.",
                lambda q, shape, s, r_max, gamma: q[s] + bias_of(q, shape, s) * 100 * (1 - gamma) / r_max),
        Mistake("Qmax is Rmax / (1 − γ), the most that can be earned from here on, not Rmax.",
                lambda q, shape, s, r_max, gamma: (q[s] + bias_of(q, shape, s)) * 100 / r_max),
        Mistake("this is the mean of Q(s) and bias(s). QBIASSR takes their sum.",
                lambda q, shape, s, r_max, gamma: (q[s] + bias_of(q, shape, s)) * 50 * (1 - gamma) / r_max),
    ],
)  # fmt: skip


def _choose(q, shape, s, temperature, r_max, gamma, u):
    return draw(probabilities(_preferences(q, shape, s, r_max, gamma), temperature), u)


# values so close to one another, and numbers u so spread, that every wrong way to choose shows somewhere
_CHOICES = [
    {"q": Q / 10, "shape": SHAPE, "s": s, "temperature": temperature, "r_max": R_MAX, "gamma": GAMMA, "u": u}
    for temperature in (0.4, 3.0)
    for s, u in zip(range(0, 24, 2), (0.5, 0.05, 0.95, 0.3, 0.7, 0.6, 0.4, 0.8, 0.2, 0.55, 0.35, 0.65), strict=True)
]

choose = Exercise(
    task="return the action that QBIASSR takes in s, drawn with the number u",
    right=_choose,
    returns="action",
    tape=_CHOICES,
    mistakes=[
        Mistake("the best action is not always taken: draw one, with the probabilities of the softmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: int(
                    _preferences(q, shape, s, r_max, gamma).argmax())),
        Mistake("the temperature plays no part in your choice: it goes into the softmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: _choose(q, shape, s, 1.0, r_max, gamma, u)),
        Mistake("your choice does not know the bias.",
                lambda q, shape, s, temperature, r_max, gamma, u: draw(
                    probabilities(q[s] * 100 * (1 - gamma) / r_max, temperature), u)),
        Mistake("the preferences are not normalised by 100 / Qmax.",
                lambda q, shape, s, temperature, r_max, gamma, u: draw(
                    probabilities(q[s] + bias_of(q, shape, s), temperature), u)),
        Mistake("all actions are equally probable in your choice. Are the preferences handed to the softmax?",
                lambda q, shape, s, temperature, r_max, gamma, u: int(u * q.shape[1])),
    ],
)  # fmt: skip


def _p_value(observed, shuffled):
    return float(np.mean(np.asarray(shuffled) >= observed))


p_value = Exercise(
    task="return the share of the shuffled numbers that are at least as large as the observed one",
    right=_p_value,
    returns="p",
    tape=[
        {"observed": 3.0, "shuffled": np.array([0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 1.5])},
        {"observed": 26.0, "shuffled": np.array([0.5, 1.5, 2.5, 0.1])},
        {"observed": 0.5, "shuffled": np.array([0.5, 1.5, 2.5, 0.1, 0.9])},
    ],
    mistakes=[
        Mistake("this is the share that is smaller. A small p must mean: chance hardly ever gets that far.",
                lambda observed, shuffled: np.mean(shuffled < observed)),
        Mistake("at least as large: those that equal the observed one count, too.",
                lambda observed, shuffled: np.mean(shuffled > observed)),
        Mistake("this is how many they are; divide by how many were shuffled.",
                lambda observed, shuffled: np.sum(shuffled >= observed)),
        Mistake("this is the share that is at most as large as the observed one: the other side.",
                lambda observed, shuffled: np.mean(shuffled <= observed)),
        Mistake("this is in per cent. A share lies between 0 and 1.",
                lambda observed, shuffled: 100 * np.mean(shuffled >= observed)),
        Mistake("this is the mean of the shuffled numbers. Compare each with the observed one first.",
                lambda observed, shuffled: np.mean(shuffled)),
    ],
)  # fmt: skip
