"""Worlds whose rewards need exactly k inputs at once; the robot's states are drawn evenly."""

from __future__ import annotations

from collections import namedtuple
from typing import Any

import gymnasium
import numpy as np
from similarity_split import of_order

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.kernel_world import NEVER, KernelWorld

SHAPE, ACTIONS = (4,) * 5, 9  # as in wander_1k
STATES = int(np.prod(SHAPE))
SPREAD = 2.0  # standard deviation of the rewards of a world

# rewards: array (states, actions); episode_steps: none end
Even = namedtuple("Even", "rewards episode_steps")


@compiled
def begin(world, rng):
    """The state in which the robot begins: any."""
    return int(rng.random() * world.rewards.shape[0])


@compiled
def outcome(world, s, a, rng):
    """What happens after (s, a): (s', r, terminated). The next state is any."""
    s_next = int(rng.random() * world.rewards.shape[0])
    return s_next, world.rewards[s, a], False


def rewards_of_order(k: int, rng: np.random.Generator) -> np.ndarray:
    """Random rewards of which every part needs exactly `k` inputs, array (states, actions).

    In each state they have the mean 0 over the actions; their standard deviation over all pairs is 2.
    """
    noise = rng.normal(size=(STATES, ACTIONS))
    rewards = of_order(noise - noise.mean(axis=1, keepdims=True), SHAPE, k)
    return rewards * SPREAD / rewards.std()


class EvenWorld(gymnasium.Env[Any, Any]):
    """A world that pays `rewards`, array (states, actions), and goes on to any state, whatever the robot does."""

    def __init__(self, rewards: np.ndarray, seed: np.random.SeedSequence) -> None:
        self.observation_space: gymnasium.Space[Any] = gymnasium.spaces.MultiDiscrete(
            list(SHAPE)
        )
        self.action_space = gymnasium.spaces.Discrete(ACTIONS)
        self.np_random = np.random.default_rng(seed)
        self.episode_step = 0
        self.state = 0
        self._world = Even(rewards, NEVER)

    def reset(self, **given: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin anywhere."""
        self.episode_step = 0
        self.state = begin(self._world, self.np_random)
        return self._observation(), {}

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """One step."""
        self.state, reward, end = outcome(
            self._world, self.state, action, self.np_random
        )
        self.episode_step += 1
        return self._observation(), float(reward), end, False, {}

    def kernel_world(self, steps: int) -> KernelWorld:
        """This world as kernels."""
        return KernelWorld(begin, outcome, self._world)

    def arrive(self, s: int) -> None:
        """Be in state `s`."""
        self.state = s

    def _observation(self) -> np.ndarray:
        return np.array(np.unravel_index(self.state, SHAPE))
