"""Open challenge of lesson 09: one setting for three tasks."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_course.challenge import Challenge, settings
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.methods import SELECTIONS

METHODS = ("TOSL+QBIASSR", *(f"{a}+{s}" for a in ("Q", "SARSA", "SL", "TOSL") for s in SELECTIONS))
TASKS = ("wander_simple", "wander_1k", "giraff_wander_1k")


def earned(given: dict[str, Any], seed: int) -> float:
    """Reward a step in the first 600 steps of each task, mean over the tasks."""
    return float(
        np.mean([
            learn(Agent(name, seed=seed, **given), make_env(name, seed=seed), steps=600, progress=False).rewards.mean()
            for name in TASKS
        ])
    )  # fmt: skip


challenge = Challenge(
    "09",
    'Write my_settings = {"method": …, "alpha": …, "gamma": …, "lam": …, "temperature": …, "epsilon": …}, with any of '
    "them left out. The same settings learn wander_simple, wander_1k and giraff_wander_1k. What counts is the reward a "
    "step in the first 600 steps, mean over the tasks.",
    "reward a step",
    settings(*METHODS, alpha=(1e-6, 1), gamma=(0, 0.9999), lam=(0, 1), temperature=(1e-3, 1e3), epsilon=(0, 1)),
    earned, seeds=10,
)  # fmt: skip
