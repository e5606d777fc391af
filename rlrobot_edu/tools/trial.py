"""A record of a task's robot while it acts: states, actions, rewards, readings, and what the actions did."""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.task import Task

LEAST_CHANGE = 1e-6  # of a reading, in its unit; a simulator is never quite at rest
Seed = int | np.random.SeedSequence


class Trial(NamedTuple):
    """Some steps of a robot.

    transitions: columns (steps,); states and actions by number
    moved: whether any reading changed in each step, array (steps,) of bool
    read: by the name of a reading, the smallest and the largest that was seen [unit of its card]
    """

    transitions: Transitions
    moved: NDArray[np.bool_]
    read: dict[str, tuple[float, float]]


class Watched(gymnasium.Wrapper[np.ndarray, int, np.ndarray, int]):
    """A task's robot, and a record of what it does."""

    def __init__(self, task: Task, seed: Seed) -> None:
        super().__init__(make_env(task, seed))
        self._rows: list[tuple[Any, ...]] = []
        self._readings: list[tuple[list[float], list[float]]] = []

    def reset(self, **given: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode."""
        observation, self._info = super().reset(**given)
        return observation, self._info

    def step(self, action: int) -> tuple[np.ndarray, Any, bool, bool, dict[str, Any]]:
        """Act, and note it down."""
        before = self._info
        observation, r, terminated, truncated, after = super().step(action)
        self._info = after
        ends = (terminated, truncated)
        self._rows.append((before["state"], action, float(r), after["state"], *ends))
        readings = ([*before["readings"].values()], [*after["readings"].values()])
        self._readings.append(readings)
        return observation, r, terminated, truncated, after

    @property
    def trial(self) -> Trial:
        """All that has been noted down."""
        readings = np.array(self._readings)  # (steps, before and after, names)
        moved = (abs(readings[:, 1] - readings[:, 0]) > LEAST_CHANGE).any(axis=1)
        low = readings.min(axis=(0, 1)).round(4) + 0.0  # never −0
        high = readings.max(axis=(0, 1)).round(4) + 0.0
        spans = zip(low.tolist(), high.tolist(), strict=True)
        read = dict(zip(self._info["readings"], spans, strict=True))
        return Trial(Transitions.of_rows(self._rows), moved, read)


def acting(task: Task, actions: list[int], seed: Seed) -> Trial:
    """The robot does these actions, one after the other."""
    with Watched(task, seed) as env:
        has_ended = True
        for a in actions:
            if has_ended:
                env.reset()
            _, _, terminated, truncated, _ = env.step(a)
            has_ended = terminated or truncated
    return env.trial


def learning(
    task: Task, steps: int, seed: np.random.SeedSequence, method: str = "TOSL+QBIASSR"
) -> Trial:
    """An agent learns with its default parameters; with the method Q+RANDOM it acts at random."""
    agent_seed, env_seed = seed.spawn(2)
    with Watched(task, env_seed) as env:
        learn(Agent(task, method, seed=agent_seed), env, steps, progress=False)
    return env.trial
