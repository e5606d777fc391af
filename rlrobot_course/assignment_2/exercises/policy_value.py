"""What a state is worth under softmax."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def policy_value(q_s, temperature):
    powers = np.exp((q_s - q_s.max()) / temperature)
    return sum(powers * q_s) / sum(powers)


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the mean of the values in q_s, each with the probability that softmax gives its action",
    right=policy_value,
    returns="value",
    tape=[
        {"q_s": np.array([1.0, 2.5]), "temperature": 0.75},
        {"q_s": np.array([1.0, 2.5, -3.0]), "temperature": 20.0},
        {"q_s": np.array([0.5, -0.5, 0.25, 1.5]), "temperature": 0.125},
        {"q_s": np.array([2.5, 2.5]), "temperature": 1.5},
        {"q_s": np.array([900.5, 899.5, 100.25]), "temperature": 0.5},
        {"q_s": np.array([-7.5, -6.25, -9.5]), "temperature": 2.5},
    ],
    mistakes={
        "overflows": Mistake(
            "e to the power of some hundreds is too large for a computer. Take the largest value off first: "
            "the probabilities stay the same.",
            {"(q_s - q_s.max()) / temperature": "q_s / temperature"},
        ),
        "best_alone": Mistake(
            "this is what the best action is worth. The policy takes the others, too, now and then.",
            {"sum(powers * q_s) / sum(powers)": "q_s.max()"},
        ),
        "plain_mean": Mistake(
            "this is the plain mean. Each value counts with its probability.",
            {"sum(powers * q_s) / sum(powers)": "q_s.mean()"},
        ),
        "no_sum": Mistake("the probabilities must sum to 1: divide by the sum of the powers.", {" / sum(powers)": ""}),
        "temperature_multiplies": Mistake(
            "the temperature divides the values: a high one makes them alike.", {"/ temperature": "* temperature"}
        ),
        "no_temperature": Mistake("the temperature is not used.", {" / temperature": ""}),
        "values_less_the_best": Mistake(
            "this is 0 for the best action: the values that are averaged are those of q_s, with nothing taken off.",
            {"powers * q_s": "powers * (q_s - q_s.max())"},
        ),
        "inverted": Mistake(
            "the sign is the wrong way round: this policy prefers the worst action.",
            {"(q_s - q_s.max())": "(q_s.min() - q_s)"},
        ),
    },
    hints=(
        "Two steps: the probabilities that softmax gives, as in lesson 03, and then the mean in which each value "
        "counts with its probability.",
        "powers = np.exp((q_s - q_s.max()) / temperature): nothing gets too large so, and the probabilities are "
        "powers / sum(powers).",
        "sum(powers * q_s) / …: what is it divided by, so that the probabilities sum to 1?",
    ),
    gained="With T near 0 this is the maximum of Q-learning, with a very large T the plain mean. In between it is the "
    "target of a robot that counts its own curiosity in.",
    witnesses=WITNESSES,
)
