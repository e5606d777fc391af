"""Exercises of lesson 05: eligibility traces."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake, Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.learning.memory import trace_steps

by_hand = Question(
    task="the new Q(s, a) of a pair that was visited two steps ago",
    right=1.7975,
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


def _delta(q, s, a, r, s_next, a_next, terminated, gamma):
    return r + (0.0 if terminated else gamma * q[s_next, a_next]) - q[s, a]


def _in_order(*lines):
    """The update with δ first, and then these lines in this order: set the trace, learn, fade."""

    def update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
        delta = _delta(q, s, a, r, s_next, a_next, terminated, gamma)
        for line in lines:
            if line == "set":
                e[s, a] = 1.0
            elif line == "add":
                e[s, a] += 1.0
            elif line == "learn":
                q += alpha * delta * e
            elif line == "fade":
                e *= gamma * lam

    return update


_update = _in_order("set", "learn", "fade")


def _forgets_lam(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    _update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, 1.0)


def _forgets_gamma(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    _update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam / gamma)


def _only_the_visited_pair_learns(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q[s, a] += alpha * _delta(q, s, a, r, s_next, a_next, terminated, gamma)
    e[s, a] = 1.0
    e *= gamma * lam


def _all_pairs_learn_alike(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = _delta(q, s, a, r, s_next, a_next, terminated, gamma)
    e[s, a] = 1.0
    q += alpha * delta * (e > 0)
    e *= gamma * lam


def _past_the_end(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    _update(q, e, s, a, r, s_next, a_next, False, alpha, gamma, lam)


def _takes_the_best(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    _update(q, e, s, a, r, s_next, q[s_next].argmax(), terminated, alpha, gamma, lam)


def _one_delta_a_pair(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    target = _delta(q, s, a, r, s_next, a_next, terminated, gamma) + q[s, a]
    e[s, a] = 1.0
    q += alpha * (target - q) * e
    e *= gamma * lam


def _delta_in_the_loop(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e[s, a] = 1.0
    for pair in np.ndindex(*q.shape):
        q[pair] += alpha * _delta(q, s, a, r, s_next, a_next, terminated, gamma) * e[pair]
    e *= gamma * lam


def _traces_the_row(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    delta = _delta(q, s, a, r, s_next, a_next, terminated, gamma)
    e[s] = 1.0
    q += alpha * delta * e
    e *= gamma * lam


def _clears_at_the_end(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    _update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
    e *= not terminated


# one episode; (0, 1) and (1, 2) come twice, and in the fourth step the next pair has a trace already
_EPISODE = [TAPE[i] for i in (0, 1, 2, 3, 7)] + [
    {"s": 1, "a": 2, "r": -0.02, "s_next": 1, "a_next": 2, "terminated": False},
    TAPE[8],
]

sarsa_lambda_update = Exercise(
    task="compute δ, set the trace of (s, a) to 1, let every pair learn its share, and let every trace fade",
    right=_update,
    memory={"q": Q_START, "e": np.zeros_like(Q_START)},
    tape=[row | {"alpha": 0.1, "gamma": 0.9, "lam": 0.8} for row in _EPISODE],
    mistakes=[
        Mistake("the traces fade too soon: the pair of this step should learn with its full trace, 1. Let them fade "
                "after q has learned.", _in_order("set", "fade", "learn")),
        Mistake("your q is right, but e is handed on before it fades. Let the traces fade at the end of the step: "
                "the lessons to come go on from there.", _in_order("fade", "set", "learn")),
        Mistake("all traces fade at the end of a step, that of (s, a), too.", _in_order("set", "learn", "fade", "set")),
        Mistake("set the trace of (s, a) to 1 before q learns; otherwise this step's own pair misses its share.",
                _in_order("learn", "set", "fade")),
        Mistake("the traces do not fade. Is that line missing, or does it make a new array? e = … does; e *= … changes "
                "the array that everybody sees.", _in_order("set", "learn")),
        Mistake("you forgot λ: a trace fades by γ · λ.", _forgets_lam),
        Mistake("you forgot γ: a trace fades by γ · λ.", _forgets_gamma),
        Mistake("these traces accumulate. A replacing trace goes to 1 at a visit, whatever it was: = instead of +=.",
                _in_order("add", "learn", "fade")),
        Mistake("only the pair (s, a) learns. Every pair should, by α · δ times its own trace.",
                _only_the_visited_pair_learns),
        Mistake("every pair that has a trace learns the whole α · δ. Multiply by the trace: the older, the less.",
                _all_pairs_learn_alike),
        Mistake("this bootstraps past the end. After a terminal step nothing follows: the target is the reward alone.",
                _past_the_end),
        Mistake("this takes the best action of s', as Q-learning does. SARSA takes a', which will really follow.",
                _takes_the_best),
        Mistake("each pair has a δ of its own here. There is one δ, that of this step's (s, a), shared by all pairs.",
                _one_delta_a_pair),
        Mistake("δ changes while q learns. Compute it once, before any entry of q changes.", _delta_in_the_loop),
        Mistake("all actions of s got a trace. Only the one that was taken should: e[s, a], not e[s].",
                _traces_the_row),
        Mistake("q does not change. Does your line make a new array? q = q + … does; q += … changes the array that "
                "everybody sees.", _in_order("set", "fade")),
        Mistake("neither q nor the fading is seen outside: q = … and e = … make new arrays. q += … and e *= … change "
                "those that everybody sees.", _in_order("set")),
        Mistake("clearing the traces is the loop's work, when it resets the world. The update leaves them to fade.",
                _clears_at_the_end),
    ],
)  # fmt: skip


def _bound(gamma, lam, threshold):
    return math.log(threshold) / math.log(gamma * lam)


n_traces = Exercise(
    task="return the largest whole number n of steps after which (γλ)ⁿ is still above the threshold",
    right=trace_steps,
    returns="n",
    tape=[
        dict(zip(("gamma", "lam", "threshold"), row, strict=True))
        for row in ((0.9, 0.9, 0.01), (0.9, 0.5, 0.01), (0.99, 0.95, 0.01), (0.9, 0.9, 0.1), (0.5, 0.6, 0.05))
    ],
    mistakes=[
        Mistake("one too many: after that many steps the trace has already crossed the threshold. Round down.",
                lambda gamma, lam, threshold: math.ceil(_bound(gamma, lam, threshold))),
        Mistake("rounding to the nearest number can go up, past the threshold. Round down.",
                lambda gamma, lam, threshold: round(_bound(gamma, lam, threshold))),
        Mistake("this is the bound itself, and steps are whole numbers. Round it down.", _bound),
        Mistake("you forgot λ: a trace fades by γ · λ in each step.",
                lambda gamma, lam, threshold: math.floor(_bound(gamma, 1.0, threshold))),
        Mistake("you forgot γ: a trace fades by γ · λ in each step.",
                lambda gamma, lam, threshold: math.floor(_bound(1.0, lam, threshold))),
        Mistake("the logarithms have changed places: it is log(threshold) divided by log(γλ).",
                lambda gamma, lam, threshold: math.floor(1 / _bound(gamma, lam, threshold))),
        Mistake("the logarithm of γλ is log(γ) + log(λ), not their product.",
                lambda gamma, lam, threshold: math.floor(math.log(threshold) / (math.log(gamma) * math.log(lam)))),
        Mistake("a trace does not lose the same amount in each step, but the same share. That is a power, and it takes "
                "a logarithm to undo it.",
                lambda gamma, lam, threshold: math.floor((1 - threshold) / (1 - gamma * lam))),
    ],
)  # fmt: skip


def _lam_for(gamma, steps, threshold):
    return min(1.0, threshold ** (1 / steps) / gamma)


lam_for = Exercise(
    task="return the λ with which a trace of 1 falls to the threshold in so many steps, 1.0 where none is enough",
    right=_lam_for,
    returns="lam",
    tape=[
        dict(zip(("gamma", "steps", "threshold"), row, strict=True))
        for row in ((0.9, 10, 0.01), (0.95, 42, 0.01), (0.9, 210, 0.01), (0.99, 210, 0.01), (0.9, 5, 0.1))
    ],
    mistakes=[
        Mistake("λ may not be above 1. Where γ alone fades faster than you wish, 1.0 is the best you can do.",
                lambda gamma, steps, threshold: threshold ** (1 / steps) / gamma),
        Mistake("this is the whole decay γλ. λ is what remains when you divide it by γ.",
                lambda gamma, steps, threshold: threshold ** (1 / steps)),
        Mistake("γλ must be that root, so λ is the root divided by γ, not multiplied.",
                lambda gamma, steps, threshold: min(1.0, threshold ** (1 / steps) * gamma)),
        Mistake("you took a power where a root is needed: (γλ)ⁿ = threshold, so γλ is the n-th root of the threshold.",
                lambda gamma, steps, threshold: min(1.0, threshold**steps / gamma)),
        Mistake("γ, too, counts once for each step: first take the root of the threshold, then divide by γ.",
                lambda gamma, steps, threshold: min(1.0, (threshold / gamma) ** (1 / steps))),
        Mistake("divided evenly, the threshold would be a sum. It is a product of n equal factors: take the n-th root.",
                lambda gamma, steps, threshold: min(1.0, threshold / steps / gamma)),
        Mistake("this is the logarithm of γλ. Undo it with the exponential function, then divide by γ.",
                lambda gamma, steps, threshold: math.log(threshold) / steps),
        Mistake("max takes the larger of two numbers. λ may not exceed 1, so you need the smaller: min.",
                lambda gamma, steps, threshold: max(1.0, threshold ** (1 / steps) / gamma)),
    ],
)  # fmt: skip
