"""A robot that is rewarded by a function of its own."""

from collections.abc import Callable, Mapping
from typing import Any

import gymnasium
import numpy as np

from rlrobot_edu.learning.size import Env

Readings = Mapping[str, float]
Pay = Callable[[Readings, Readings, float, bool], float]


class Paid(gymnasium.Wrapper[np.ndarray, int, np.ndarray, int]):
    """A robot that is rewarded by a function of its own: anything, not only the values that its task lists.

    env: of a robot; pay: (readings before, readings after, the task's own reward, terminated) -> reward
    """

    def __init__(self, env: Env, pay: Pay) -> None:
        super().__init__(env)
        self.pay, self._readings = pay, dict[str, float]()

    def reset(self, **options: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Start an episode."""
        observation, info = self.env.reset(**options)
        self._readings = info["readings"]
        return observation, info

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Do an action, and be paid for it."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        before, self._readings = self._readings, info["readings"]
        return (
            observation,
            self.pay(before, self._readings, float(reward), terminated),
            terminated,
            truncated,
            info,
        )
