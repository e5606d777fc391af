"""Open challenge of lesson 05: the fewest steps to the goal, with traces."""

from __future__ import annotations

from typing import Any

import gymnasium

from rlrobot_course.challenge import Challenge, settings
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn

FIELD = ["S" + 7 * "F", *6 * [8 * "F"], 7 * "F" + "G"]  # a lake without holes: what is hard is the distance


def steps_an_arrival(given: dict[str, Any], seed: int) -> float:
    """Steps for each arrival at the goal of an agent in its first 2,000."""
    lake = gymnasium.make("FrozenLake-v1", desc=FIELD, is_slippery=False, max_episode_steps=500)
    history = learn(Agent(lake, seed=seed, loop_evasion=False, **given), lake, steps=2000, progress=False)
    return 2000 / max(1, int(history.terminated.sum()))


challenge = Challenge(
    "05",
    'Write my_settings = {"alpha": …, "gamma": …, "lam": …, "temperature": …}, with any of them left out. SARSA(λ) '
    "with softmax crosses a frozen lake of 8 × 8 squares without holes, corner to corner; the shortest way has 14 "
    "steps. What counts is how many of its first 2,000 steps each arrival took.",
    "steps an arrival",
    settings("SL+SR", alpha=(1e-6, 1), gamma=(0, 0.9999), lam=(0, 1), temperature=(1e-3, 1e3)),
    steps_an_arrival, seeds=20, least_wins=True,
)  # fmt: skip
