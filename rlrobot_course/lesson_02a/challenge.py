"""Open challenge of lesson 02a: the best α, γ and ε for 200 steps."""

from __future__ import annotations

from functools import cache
from typing import Any

from rlrobot_course.challenge import Challenge, settings
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.models.formats.reading import read_recording
from rlrobot_edu.models.sample_model import SampleModel


@cache
def model() -> SampleModel:
    """The robot in its four cells, as it was recorded."""
    return SampleModel.from_recording(read_recording("worked_example"))


def earned(given: dict[str, Any], seed: int) -> float:
    """Reward a step of one agent in its first 200 steps."""
    agent = Agent(model(), seed=seed, **given)
    return float(learn(agent, make_env(model(), seed=seed), steps=200, progress=False).rewards.mean())


challenge = Challenge(
    "02a",
    'Write my_settings = {"alpha": …, "gamma": …, "epsilon": …}. With them Q-learning moves the robot in its four '
    "cells, in the model of this lesson; epsilon is the share of the steps in which it takes any action. What counts "
    "is the reward a step in the first 200 steps, the blunders included.",
    "reward a step", settings("Q+EG", alpha=(1e-6, 1), gamma=(0, 0.9999), epsilon=(0, 1)), earned, seeds=200,
)  # fmt: skip
