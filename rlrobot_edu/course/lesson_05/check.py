"""Exercises of lesson 05: eligibility traces."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_05 import solutions
from rlrobot_edu.learning.memory import trace_steps

by_hand = Question(
    task="the new Q(s, a) of a pair that was visited two steps ago",
    right=solutions.by_hand,
    because="Its trace is (0.9 · 0.5)² = 0.2025, so Q ← 2 + 0.1 · (−10) · 0.2025 = 1.7975.",
    mistakes=[
        Mistake("this is what the pair of this very step gets, whose trace is 1. Ours has faded for two steps.", 1.0),
        Mistake("this trace has faded for one step only. Two steps make (γλ)².", 1.55),
        Mistake("this trace has faded for three steps. The collision comes two steps after the visit.", 1.908875),
        Mistake("you forgot λ: in each step the trace is multiplied by γ and by λ.", 1.19),
        Mistake("you forgot γ: in each step the trace is multiplied by γ and by λ.", 1.75),
        Mistake("you forgot α: the pair learns α · δ · e.", -0.025),
        Mistake("this is the trace itself. Q changes by α · δ · e.", 0.2025),
        Mistake("this is the change α · δ · e. Add it to the old value, 2.", -0.2025),
        Mistake("a collision makes Q smaller: δ is −10, not +10.", 2.2025),
    ],
)

# one episode; (0, 1) and (1, 2) come twice, and in the fourth step the next pair has a trace already
EPISODE = [TAPE[i] for i in (0, 1, 2, 3, 7)] + [
    {"s": 1, "a": 2, "r": -0.02, "s_next": 1, "a_next": 2, "terminated": False},
    TAPE[8],
]

sarsa_lambda_update = Exercise(
    task="compute δ, set the trace of (s, a) to 1, let every pair learn its share, and let every trace fade",
    right=solutions.sarsa_lambda_update,
    memory={"q": Q_START, "e": np.zeros_like(Q_START)},
    tape=[row | {"alpha": 0.1, "gamma": 0.9, "lam": 0.8} for row in EPISODE],
    mistakes=[
        Mistake("the traces fade too soon: the pair of this step should learn with its full trace, 1. Let them fade "
                "after q has learned.",
                {"q += alpha * delta * e": "e *= gamma * lam", "e *= gamma * lam": "q += alpha * delta * e"}),
        Mistake("your q is right, but e is handed on before it fades. Let the traces fade at the end of the step: the "
                "lessons to come go on from there.",
                {"e[s, a] = 1": "e *= gamma * lam; e[s, a] = 1", "e *= gamma * lam": "pass"}),
        Mistake("all traces fade at the end of a step, that of (s, a), too.",
                {"e *= gamma * lam": "e *= gamma * lam; e[s, a] = 1"}),
        Mistake("set the trace of (s, a) to 1 before q learns; otherwise this step's own pair misses its share.",
                {"e[s, a] = 1": "q += alpha * delta * e", "q += alpha * delta * e": "e[s, a] = 1"}),
        Mistake("the traces do not fade. Is that line missing, or does it make a new array? e = … does; e *= … "
                "changes the array that everybody sees.", {"e *= gamma": "e = e * gamma"}),
        Mistake("you forgot λ: a trace fades by γ · λ.", {" * lam": ""}),
        Mistake("you forgot γ: a trace fades by γ · λ.", {"gamma * lam": "lam"}),
        Mistake("these traces accumulate. A replacing trace goes to 1 at a visit, whatever it was: = instead of +=.",
                {"e[s, a] = 1": "e[s, a] += 1"}),
        Mistake("only the pair (s, a) learns. Every pair should, by α · δ times its own trace.",
                {"q += alpha * delta * e": "q[s, a] += alpha * delta"}),
        Mistake("every pair that has a trace learns the whole α · δ. Multiply by the trace: the older, the less.",
                {"delta * e": "delta * (e > 0)"}),
        Mistake("this bootstraps past the end. After a terminal step nothing follows: the target is the reward alone.",
                {"0 if terminated else ": ""}),
        Mistake("this takes the best action of s', as Q-learning does. SARSA takes a', which will really follow.",
                {"q[s_next, a_next]": "q[s_next].max()"}),
        Mistake("each pair has a δ of its own here. There is one δ, that of this step's (s, a), shared by all pairs.",
                {"q += alpha * delta * e": "q += alpha * (delta + q[s, a] - q) * e"}),
        Mistake("δ changes while q learns. Compute it once, before any entry of q changes.",
                {"q += alpha * delta * e": "for x, b in zip(*e.nonzero()):\n"
                 "        delta = r + gamma * (0 if terminated else q[s_next, a_next]) - q[s, a]\n"
                 "        q[x, b] += alpha * delta * e[x, b]"}),
        Mistake("all actions of s got a trace. Only the one that was taken should: e[s, a], not e[s].",
                {"e[s, a] = 1": "e[s] = 1"}),
        Mistake("q does not change. Does your line make a new array? q = q + … does; q += … changes the array that "
                "everybody sees.", {"q += alpha": "q = q + alpha"}),
        Mistake("neither q nor the fading is seen outside: q = … and e = … make new arrays. q += … and e *= … change "
                "those that everybody sees.", {"q += alpha": "q = q + alpha", "e *= gamma": "e = e * gamma"}),
        Mistake("clearing the traces is the loop's work, when it resets the world. The update leaves them to fade.",
                {"e *= gamma * lam": "e *= gamma * lam * (not terminated)"}),
    ],
)  # fmt: skip

n_traces = Exercise(
    task="return the largest whole number n of steps after which (γλ)ⁿ is still above the threshold",
    right=solutions.n_traces,
    library=trace_steps,
    returns="n",
    tape=[
        dict(zip(("gamma", "lam", "threshold"), row, strict=True))
        for row in ((0.9, 0.9, 0.01), (0.9, 0.5, 0.01), (0.99, 0.95, 0.01), (0.9, 0.9, 0.1), (0.5, 0.6, 0.05))
    ],
    mistakes=[
        Mistake("one too many: after that many steps the trace has already crossed the threshold. Round down.",
                {"math.floor": "math.ceil"}),
        Mistake("rounding to the nearest number can go up, past the threshold. Round down.", {"math.floor": "round"}),
        Mistake("this is the bound itself, and steps are whole numbers. Round it down.", {"math.floor": ""}),
        Mistake("you forgot λ: a trace fades by γ · λ in each step.", {" * lam": ""}),
        Mistake("you forgot γ: a trace fades by γ · λ in each step.", {"gamma * ": ""}),
        Mistake("the logarithms have changed places: it is log(threshold) divided by log(γλ).",
                {"threshold": "gamma * lam", "gamma * lam": "threshold"}),
        Mistake("the logarithm of γλ is log(γ) + log(λ), not their product.",
                {"math.log(gamma * lam)": "(math.log(gamma) * math.log(lam))"}),
        Mistake("a trace does not lose the same amount in each step, but the same share. That is a power, and it "
                "takes a logarithm to undo it.",
                {"math.log(threshold) / math.log(gamma * lam)": "(1 - threshold) / (1 - gamma * lam)"}),
    ],
)  # fmt: skip

lam_for = Exercise(
    task="return the λ with which a trace of 1 falls to the threshold in so many steps, 1.0 where none is enough",
    right=solutions.lam_for,
    returns="lam",
    tape=[
        dict(zip(("gamma", "steps", "threshold"), row, strict=True))
        for row in ((0.9, 10, 0.01), (0.95, 42, 0.01), (0.9, 210, 0.01), (0.99, 210, 0.01), (0.9, 5, 0.1))
    ],
    mistakes=[
        Mistake("λ may not be above 1. Where γ alone fades faster than you wish, 1.0 is the best you can do.",
                {"min(1.0, decay / gamma)": "decay / gamma"}),
        Mistake("this is the whole decay γλ. λ is what remains when you divide it by γ.",
                {"min(1.0, decay / gamma)": "decay"}),
        Mistake("γλ must be that root, so λ is the root divided by γ, not multiplied.",
                {"decay / gamma": "decay * gamma"}),
        Mistake("you took a power where a root is needed: (γλ)ⁿ = threshold, so γλ is the n-th root of the threshold.",
                {"(1 / steps)": "steps"}),
        Mistake("γ, too, counts once for each step: first take the root of the threshold, then divide by γ.",
                {"threshold **": "(threshold / gamma) **", "decay / gamma": "decay"}),
        Mistake("divided evenly, the threshold would be a sum. It is a product of n equal factors: take the n-th root.",
                {"** (1 / steps)": "/ steps"}),
        Mistake("this is the logarithm of γλ. Undo it with the exponential function, then divide by γ.",
                {"min(1.0, decay / gamma)": "math.log(threshold) / steps"}),
        Mistake("max takes the larger of two numbers. λ may not exceed 1, so you need the smaller: min.",
                {"min": "max"}),
    ],
)  # fmt: skip
