"""Open challenge of lesson 04b: to live through one's learning beside the cliff."""

from __future__ import annotations

from typing import Any

from rlrobot_course.challenge import Challenge, settings
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.widgets.playground.cliff import cliff_model

METHODS = ("SARSA+EG", "Q+EG", "SARSA+SR", "Q+SR")


def paid(given: dict[str, Any], seed: int) -> float:
    """Sum of the rewards of an episode, mean over all in 10,000 steps."""
    agent, cliff = Agent(cliff_model(), seed=seed, r_max=1, **given), make_env(cliff_model(), seed=seed)
    history = learn(agent, cliff, steps=10_000, progress=False)
    return float(history.rewards.sum() / max(1, history.terminated.sum()))


challenge = Challenge(
    "04b",
    'Write my_settings = {"method": …, "alpha": …, "gamma": …, "epsilon": …, "temperature": …}, with any of them left '
    'out; methods are "Q+EG", "SARSA+EG", "Q+SR", "SARSA+SR". The agent walks beside the cliff for 10,000 steps, and '
    "there is no rehearsal. What counts is what an episode paid, the first ones included.",
    "reward an episode",
    settings(*METHODS, alpha=(1e-6, 1), gamma=(0, 0.9999), epsilon=(0, 1), temperature=(1e-3, 1e3)),
    paid, seeds=40,
)  # fmt: skip
