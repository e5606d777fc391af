"""Exercises of lesson 03: exploration."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_edu.course.grading import tapes
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.kernels import probabilities
from rlrobot_edu.course.lesson_03 import solutions

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
    ],
)

epsilon_greedy = Exercise(
    task="return the probability of each action: ε / A each, and 1 − ε shared by the best",
    right=solutions.epsilon_greedy,
    returns="p",
    tape=[
        {"q_s": np.array(q_s), "epsilon": epsilon}
        for q_s, epsilon in (
            ([2.0, 5.0, 1.0, 0.0], 0.2),
            ([-3.0, -2.0, -5.0], 0.6),
            ([4.0, 1.0, 4.0], 0.3),
            ([0.0, 0.0, 0.0, 0.0], 0.1),
            ([-1.0, -2.0, -1.0], 0.0),
            ([1.0, 2.0], 1.0),
        )
    ],
    mistakes=[
        Mistake("several actions are equally good here, and only the first gets the share of the best. argmax does "
                "that. Find all actions with the largest value.",
                {"q_s == q_s.max()": "np.arange(len(q_s)) == q_s.argmax()"}),
        Mistake("the probabilities sum to more than 1: equally good actions share 1 − ε, they do not get it each.",
                {" / best.sum()": ""}),
        Mistake("to explore is to take any action, also the best: divide ε by the number of all actions.",
                {"return": "return 1 / len(q_s) + 0 * q_s if best.all() else",
                 "epsilon / len(q_s)": "epsilon * ~best / (~best).sum()"}),
        Mistake("the best action gets its part of ε, too: without it the sum is below 1.",
                {"epsilon / len(q_s)": "epsilon / len(q_s) * ~best"}),
        Mistake("ε and 1 − ε have changed places: ε is the probability to explore.",
                {"epsilon / len": "(1 - epsilon) / len", "(1 - epsilon) * best": "epsilon * best"}),
        Mistake("this is an action. Return the probabilities of all actions.",
                {"epsilon / len(q_s) + (1 - epsilon) * best / best.sum()": "int(q_s.argmax())"}),
        Mistake("this never explores: ε has no effect.", {"epsilon": "0"}),
        Mistake("each action has its ε / A, but the best still lack their 1 − ε.",
                {"(1 - epsilon) * best": "0 * best"}),
    ],
)  # fmt: skip

draw = Exercise(
    task="return the first action at which the running sum of p exceeds u",
    right=solutions.draw,
    library=tapes.draw,
    returns="action",
    tape=[
        {"p": np.array(p), "u": u}
        for p, u in (
            ([0.3, 0.3, 0.4], 0.35),
            ([0.2, 0.5, 0.3], 0.1),
            ([0.2, 0.5, 0.3], 0.9),
            ([0.6, 0.1, 0.1, 0.2], 0.75),
            ([0.1, 0.2, 0.7], 0.25),
            ([0.25, 0.25, 0.25, 0.25], 0.5),
            ([0.0, 1.0, 0.0], 0.0),
        )
    ],
    mistakes=[
        Mistake("u is compared with the probability of each action alone. Add up: p(0), then p(0) + p(1), and so on.",
                {"+=": "="}),
        Mistake("this takes the most probable action, whatever u is.", {"total = 0.0": "return int(p.argmax())"}),
        Mistake("u lies exactly on a border here. The running sum must exceed u: write u < sum, not u <= sum. "
                "Otherwise u = 0 may draw an action whose probability is 0.", {"u < total": "u <= total"}),
        Mistake("this is one action too early: the running sum counts p of the action itself, too.",
                {"return a": "return max(a - 1, 0)"}),
        Mistake("this is one action too late. Actions count from 0.", {"return a": "return a + 1"}),
        Mistake("here all actions are equally probable: p has no effect.", {"total = 0.0": "return int(u * len(p))"}),
        Mistake("this is the probability of the action. Return its number.", {"return a": "return p[a]"}),
    ],
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
            ([3.0, 2.0, 0.0], 1.0),
            ([0.0, 0.0, 0.0, 0.0], 1.0),
            ([-30.0, 40.0, 10.0], 25.0),
            ([1000.0, 999.0, 0.0], 1.0),
            ([-999.0, -1000.0], 1.0),
            ([60.0, 59.9], 0.05),
        )
    ],
    mistakes=[
        Mistake("nan means not a number. e to the power of 1000 is too large for the computer; it becomes infinity, "
                "and infinity divided by infinity is nan. Subtract the largest x from all x first: no probability "
                "changes.", {"(x - x.max())": "x"}),
        Mistake("the temperature has no effect. Divide by T, and mind the brackets: (x − largest) / T.",
                {" / temperature": ""}),
        Mistake("divide x by T, do not multiply: heat makes the actions more alike.",
                {"/ temperature": "* temperature"}),
        Mistake("the exponential is missing: it is e^(x/T), in Python np.exp.",
                {"np.exp((x - x.max()) / temperature)": "x"}),
        Mistake("these do not sum to 1. Divide them by their sum.", {" / powers.sum()": ""}),
        Mistake("these do not sum to 1. Divide them by their sum.", {"(x - x.max())": "x", " / powers.sum()": ""}),
        Mistake("subtract the largest x; dividing by it changes the probabilities.", {"x - x.max()": "x / x.max()"}),
        Mistake("the sign is turned round: the best action gets the least.", {"x - x.max()": "x.min() - x"}),
        Mistake("this is an action. Return the probabilities of all actions.",
                {"powers / powers.sum()": "int(x.argmax())"}),
    ],
)  # fmt: skip

temperature_for = Exercise(
    task="return the temperature at which an action whose x is larger by gap is odds times as probable",
    right=solutions.temperature_for,
    returns="T",
    tape=[
        {"gap": gap, "odds": odds}
        for gap, odds in ((2.0, 9.0), (10.0, 100.0), (0.5, 20.0), (1.0, math.e), (30.0, 1.5), (4.0, 2.0))
    ],
    mistakes=[
        Mistake("np.log10 is the logarithm to base 10. Softmax is made of powers of e, and their inverse is np.log.",
                {"np.log(": "np.log10("}),
        Mistake("you found 1 / T. Turn the fraction round.", {"gap / np.log(odds)": "np.log(odds) / gap"}),
        Mistake("odds = e^(gap/T). To get at T, take the logarithm of both sides first.", {"np.log(odds)": "odds"}),
        Mistake("larger odds need a lower temperature. Here T grows with the odds: check how you isolated T.",
                {"/": "*"}),
        Mistake("this is gap / T. One step is left to T itself.", {"gap / ": ""}),
    ],
)  # fmt: skip

normalise = Exercise(
    task="return q_s · 100 / Qmax, with Qmax = Rmax / (1 − γ)",
    right=solutions.normalise,
    returns="x",
    tape=[
        {"q_s": np.array(q_s), "r_max": r_max, "gamma": gamma}
        for q_s, r_max, gamma in (
            ([5.0, 2.5, -1.0], 1.0, 0.9),
            ([30.0, 10.0, 0.0], 10.0, 0.5),
            ([3.0, 7.0], 5.0, 0.99),
            ([8.0, -2.0], 10.0, 0.0),
            ([60.0, 40.0, 1.0], 10.0, 0.9),
        )
    ],
    mistakes=[
        Mistake("you divided by the largest value of the row. Qmax is the most that Q can ever become: Rmax / (1 − "
                "γ). It must not change from state to state.", {"r_max / (1 - gamma)": "q_s.max()"}),
        Mistake("this divides by the largest reward alone. Rewards add up over the steps: Qmax = Rmax / (1 − γ).",
                {" / (1 - gamma)": ""}),
        Mistake("Qmax is Rmax / (1 − γ), larger than one reward. Did you multiply by 1 − γ where you should divide? "
                "Or are there brackets missing, as in 100 / r_max / (1 − γ)?", {"/ (1 - gamma)": "* (1 - gamma)"}),
        Mistake("the factor 100 is missing.", {" * 100": ""}),
        Mistake("it is 1 − γ below the line, not γ.", {"100 / q_max": "100 * gamma / r_max"}),
        Mistake("the fraction is upside down: multiply by 100 and divide by Qmax.", {"100 / q_max": "q_max / 100"}),
    ],
)  # fmt: skip
