"""Lesson 06's first exercise: the λ-return, with many ways to get a weight or a power wrong."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake


def _back_from(g, rewards, values, gamma, lam):
    """The λ-return, worked out from the end, where it is `g`."""
    for r, v in zip(rewards[::-1], values[::-1], strict=True):
        g = r + gamma * ((1 - lam) * v + lam * g)
    return g


def _lambda_return(rewards, values, gamma, lam):
    return _back_from(values[-1], rewards, values, gamma, lam)


def _weigh(returns, lam, first=0, last=0, all_alike=False, share=True):
    """The sum of the n-step returns with weights that are right but for what the arguments spoil."""
    n = len(returns)
    weights = [(1 - lam if share else 1) * lam ** (k + first) for k in range(n)]
    if not all_alike:
        weights[-1] = lam ** (n - 1 + first + last)
    return sum(w * g for w, g in zip(weights, returns, strict=True))


def _returns(rewards, values, gamma, reward_power=0, value_power=1, gamma_once=False):
    """All n-step returns, right but for the powers of γ that the arguments shift."""
    found, total = [], 0.0
    for k, (r, v) in enumerate(zip(rewards, values, strict=True)):
        total += gamma ** (k + reward_power) * r
        found.append(total + (gamma if gamma_once else gamma ** (k + value_power)) * v)
    return found


lambda_return = Exercise(
    task="return the mean of all n-step returns, weighted by powers of λ",
    right=_lambda_return,
    returns="G",
    tape=[
        {"rewards": [10.0], "values": [4.0], "gamma": 0.9, "lam": 0.9},
        {"rewards": [10.0, 10.0], "values": [0.0, 5.0], "gamma": 0.9, "lam": 0.9},
        {"rewards": [1.0, -2.0], "values": [6.0, 3.0], "gamma": 0.9, "lam": 0.5},
        {"rewards": [10.0, -0.02, -2.0], "values": [7.0, 5.0, 4.0], "gamma": 0.9, "lam": 0.8},
        {"rewards": [-0.02, -0.02, 10.0, 10.0], "values": [1.0, 2.0, 3.0, 0.0], "gamma": 0.8, "lam": 0.9},
        {"rewards": [1.0, 2.0, 3.0], "values": [4.0, 5.0, 6.0], "gamma": 0.9, "lam": 0.0},
    ],
    mistakes=[
        Mistake(
            "the weights do not sum to 1. The last return, which stands for all the longer ones, has the weight "
            "λⁿ⁻¹, without the factor 1 − λ.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma), lam, all_alike=True),
        ),
        Mistake(
            "the longest return ends with γⁿ times the last value, in full. If you work back from the end, begin with "
            "the last value, not with 0.",
            lambda rewards, values, gamma, lam: _back_from(0.0, rewards, values, gamma, lam),
        ),
        Mistake(
            "the weights of all returns but the last have the factor 1 − λ, so that they sum to 1.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma), lam, share=False),
        ),
        Mistake(
            "this is the longest return alone. The shorter ones count, too, with the weights (1 − λ)λᵏ⁻¹.",
            lambda rewards, values, gamma, lam: _returns(rewards, values, gamma)[-1],
        ),
        Mistake(
            "this is the one-step return alone. The longer ones count, too.",
            lambda rewards, values, gamma, lam: _returns(rewards, values, gamma)[0],
        ),
        Mistake(
            "this is the plain mean of the returns. Each has a weight of its own, made of λ.",
            lambda rewards, values, gamma, lam: np.mean(_returns(rewards, values, gamma)),
        ),
        Mistake(
            "the powers of λ are one too high: the one-step return has the weight (1 − λ)λ⁰.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma), lam, first=1),
        ),
        Mistake(
            "the weights do not sum to 1: that of the last return is λⁿ⁻¹, not λⁿ.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma), lam, last=1),
        ),
        Mistake(
            "the powers of γ of the rewards are one too high: the first reward counts in full.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma, reward_power=1), lam),
        ),
        Mistake(
            "the value reached after k steps is one step further off than the k-th reward: it is multiplied by γᵏ.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma, value_power=0), lam),
        ),
        Mistake(
            "every value is multiplied by γ alone here. The one reached after k steps is multiplied by γᵏ.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, gamma, gamma_once=True), lam),
        ),
        Mistake(
            "the values are missing: a k-step return ends with γᵏ times the value reached.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, [0.0] * len(values), gamma), lam),
        ),
        Mistake(
            "γ is missing: the reward r_k is multiplied by γᵏ and the value after k steps by γᵏ.",
            lambda rewards, values, gamma, lam: _weigh(_returns(rewards, values, 1.0), lam),
        ),
    ],
)
