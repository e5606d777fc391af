"""Open challenge of lesson 06: a trace of one's own."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_course.challenge import Challenge, Watched, number, rewards_of
from rlrobot_edu.environments import make_env

ALPHA, GAMMA, LAM = 0.4, 0.9, 0.9


def read(trace: Any) -> Watched:
    """The learner's trace, a number from 0 to 100."""
    return Watched(trace, "my_trace(e, alpha)", number(0, 100))


def earned(trace: Watched, seed: int) -> float:
    """Reward a step of a robot of SARSA(λ) with that trace, in its first 800 steps."""
    q, e = np.zeros((1024, 9)), np.zeros((1024, 9))

    def choose(s: int, t: int) -> np.ndarray:
        powers = np.exp(q[s] - q[s].max())
        return powers / powers.sum()

    def update(s: int, a: int, r: float, s_next: int, a_next: int, terminated: bool) -> None:
        delta = r + GAMMA * q[s_next, a_next] - q[s, a]
        e[s, a] = trace(float(e[s, a]), ALPHA)
        q[:] = np.clip(q + ALPHA * delta * e, -1e6, 1e6)
        e[:] *= GAMMA * LAM

    return float(rewards_of(make_env("wander_1k", seed=seed), choose, update, 800, seed).mean())


challenge = Challenge(
    "06",
    "Write my_trace(e, alpha): the new trace, 0 to 100, of the pair that is visited now, whose trace is e. A robot of "
    "wander_1k learns with it by SARSA(λ) with softmax, α = 0.4 and γ = λ = 0.9. What counts is the reward a step in "
    "its first 800 steps.",
    "reward a step", read, earned, seeds=10,
)  # fmt: skip
