"""Exercises of lesson 03: exploration."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading import tapes
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.kernels import probabilities
from rlrobot_edu.course.lesson_03 import mistakes, solutions

by_hand = Question(
    task="the three probabilities of ε-greedy, computed by hand",
    right=solutions.by_hand,
    because="0.3 / 3 = 0.1 for each action, and the remaining 0.7 in two halves for the two best: 0.1 + 0.35 = 0.45.",
    mistakes=[
        Mistake("actions 0 and 2 are equally good. Do not favour the first one: they share 1 − ε.", [0.8, 0.1, 0.1]),
        Mistake("these sum to more than 1: the best actions share 1 − ε, not each of them gets it.", [0.8, 0.1, 0.8]),
        Mistake("this is greedy: it never explores. Each action first gets its part of ε.", [0.5, 0.0, 0.5]),
        Mistake("to explore is to take any action, also one of the best. Divide ε by 3.", [0.35, 0.3, 0.35]),
        Mistake("these sum to less than 1: the best actions, too, get their part of ε.", [0.35, 0.1, 0.35]),
        Mistake("actions 0 and 2 are equally good. Do not favour the last one: they share 1 − ε.", [0.1, 0.1, 0.8]),
        Mistake("this is the share of ε alone. The best two have 1 − ε on top, half each.", [0.1, 0.1, 0.1]),
        Mistake("the sum is above 1. Divide ε by 3, the number of actions, before you add it.", [0.65, 0.3, 0.65]),
        Mistake("each of the best gets only half of 1 − ε.", [0.7, 0.3, 0.7]),
        Mistake(
            "ε and 1 − ε have changed places: ε is the probability to explore.",
            [0.7 / 3 + 0.15, 0.7 / 3, 0.7 / 3 + 0.15],
        ),
        Mistake(
            "this gives each best action a third of 1 − ε. There are two of them: half each.",
            [0.1 + 0.7 / 3, 0.1, 0.1 + 0.7 / 3],
        ),
        Mistake("these are equal shares. The best two get 1 − ε on top of ε / 3.", [1 / 3, 1 / 3, 1 / 3]),
        Mistake("action 1 is the worst here, not the best.", [0.1, 0.8, 0.1]),
        Mistake("there are three actions here, not four: each gets ε / 3.", [0.425, 0.075, 0.425]),
        Mistake("action 1 gets its ε / 3 = 0.1 and nothing more. What remains goes to the two best.", [0.4, 0.2, 0.4]),
        Mistake("they sum to 1, but to explore is to take any action: action 1 has ε / 3.", [0.475, 0.05, 0.475]),
        Mistake("the two best are equally good, and get the same: half of 1 − ε each.", [0.55, 0.1, 0.35]),
        Mistake("this never explores, and it leaves out that action 2 is as good as action 0.", [1.0, 0.0, 0.0]),
        Mistake("Q does not grade them: the best two share 1 − ε, and each action gets ε / 3.", [4 / 9, 1 / 9, 4 / 9]),
    ],
    hints=(
        "Each action gets its part of ε. What remains, 1 − ε, goes to the best. How many are they?",
        "ε / A = 0.3 / 3. The two best share 1 − 0.3 = 0.7.",
        "The list is [0.1 + 0.7 / …, 0.1, 0.1 + 0.7 / …].",
    ),
    gained="They sum to 1, and the tie is shared. That is more than many published programs do.",
)

epsilon_greedy = Exercise(
    task="return the probability of each action: ε / A each, and 1 − ε shared by the best",
    right=solutions.epsilon_greedy,
    returns="p",
    tape=[
        {"q_s": np.array(q_s), "epsilon": epsilon}
        for q_s, epsilon in (
            ([2.0, 5.0, 1.0, 5.0, 0.0], 0.2),
            ([-3.0, -2.0, -5.0], 0.61),
            ([3.0, 1.0, 2.0, -8.0], 0.137),
            ([4.0, 4.0, 1.0, 4.0, 3.0, 2.0], 0.25),
            ([2.0, 2.004, 2.002], 0.3),
            ([-0.2, 0.0, -2.0, 0.0], 0.5),
            ([0.0, 0.0, 0.0, 0.0], 0.1),
            ([-1.0, -2.0, -1.0], 0.0),
            ([1.0, 2.0], 1.0),
        )
    ],
    mistakes=mistakes.EPSILON_GREEDY,
    hints=(
        "Two parts: each action gets the same share of ε; the best get 1 − ε on top, in equal parts.",
        "best = q_s == q_s.max() marks the best, and best.sum() is their number.",
        "return epsilon / len(q_s) + (1 - epsilon) * best / …: by what must the share of the best be divided?",
    ),
    gained="No tie is left to chance or to argmax: your robot will try every action while it knows nothing.",
)  # fmt: skip

draw = Exercise(
    task="return the first action at which the running sum of p exceeds u",
    right=solutions.draw,
    library=tapes.draw,
    returns="action",
    tape=[
        {"p": np.array(p), "u": u}
        for p, u in (
            ([0.2, 0.3, 0.1, 0.4], 0.45),
            ([0.3, 0.3, 0.4], 0.35),
            ([0.2, 0.5, 0.3], 0.1),
            ([0.2, 0.5, 0.3], 0.9),
            ([0.6, 0.1, 0.1, 0.2], 0.75),
            ([0.1, 0.2, 0.7], 0.25),
            ([0.25, 0.25, 0.25, 0.25], 0.5),
            ([0.0, 1.0, 0.0], 0.0),
            ([0.5, 0.0, 0.5], 0.5),
            ([1.0], 0.3),
            ([0.4, 0.05, 0.3, 0.1, 0.15], 0.97),
            ([0.7, 0.3], 0.65),
        )
    ],
    mistakes=mistakes.DRAW,
    hints=(
        "Walk along the line from the left. In which piece does u lie?",
        "total begins at 0; for each action add p[a] to it, and stop at the first at which u < total.",
        "for a in range(len(p)): total += p[a]; if u < total: return a. (Each on a line of its own.)",
    ),
    gained="One number u, one action: with the same random numbers your robot will do exactly what the library's does.",
)  # fmt: skip

softmax = Exercise(
    task="return the probability of each action, e^(x/T) divided by the sum of all e^(x/T)",
    right=solutions.softmax,
    library=probabilities,
    returns="p",
    tape=[
        {"x": np.array(x), "temperature": temperature}
        for x, temperature in (
            ([1.0, 2.5, 0.5], 2.0),
            ([1.0, 2.5, 0.5], 0.5),
            ([3.0, 2.0, 0.0, -1.5], 1.0),
            ([0.0, 0.0, 0.0, 0.0], 1.0),
            ([-30.0, 40.0, 10.0], 25.0),
            ([1000.0, 999.0, 0.0], 1.0),
            ([-999.0, -1000.0], 1.0),
            ([60.0, 59.9], 0.05),
            ([3000.0, 0.0, 0.0], 1.0),
            ([2.0, 20000.0, 19999.5, 0.0], 1.0),
            ([7.0, 8.0, 6.5, 9.0, 3.0], 3.0),
            ([-5.0, 3.0], 0.001),
        )
    ],
    mistakes=mistakes.SOFTMAX,
    hints=(
        "The largest exponent must be 0. Then no power is too large.",
        "powers = np.exp((x - x.max()) / temperature). One line is left: they must sum to 1.",
        "return powers / (what all of them sum to).",
    ),
    gained="Cold or hot, with x of 1 or of 1000, it holds. Softmax is the choice in most of the paper's experiments.",
)  # fmt: skip
