"""A robot that is rewarded by a function of its own."""

from collections.abc import Callable, Mapping
from typing import Any

import gymnasium
import numpy as np

from rlrobot_edu.learning.size import Env

Readings = Mapping[str, float]
Reward = Callable[[Readings, Readings, float, bool], float]


class OwnReward(gymnasium.Wrapper[np.ndarray, int, np.ndarray, int]):
    """A robot that is rewarded by a function of its own: anything, not only the values that its task lists.

    env: of a robot; reward: (readings before, readings after, the task's own reward, terminated) -> reward
    """

    def __init__(self, env: Env, reward: Reward) -> None:
        super().__init__(env)
        self.reward = reward
        self._readings: Readings = {}

    def reset(self, **options: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Start an episode."""
        observation, info = self.env.reset(**options)
        self._readings = info["readings"]
        return observation, info

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Do an action, and be rewarded for it."""
        observation, r, terminated, truncated, info = self.env.step(action)
        before, self._readings = self._readings, info["readings"]
        return (
            observation,
            self.reward(before, self._readings, float(r), terminated),
            terminated,
            truncated,
            info,
        )
