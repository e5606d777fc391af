"""What is seen while a task's robot acts: states, actions, rewards, and what the actions did."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.task import Task

LEAST_CHANGE = 1e-6  # of a reading, in its unit; a simulator is never quite at rest


class Trial(NamedTuple):
    """So many steps of a robot.

    transitions: columns (steps,); states and actions by number
    moved: whether any reading changed in each step, array (steps,) of bool
    """

    transitions: Transitions
    moved: NDArray[np.bool_]


def at_random(task: Task, steps: int, seed: np.random.SeedSequence) -> Trial:
    """The robot does any action at any time."""
    env_seed, action_seed = seed.spawn(2)
    return acting(task, np.random.default_rng(action_seed).integers(task.actions.n, size=steps).tolist(), env_seed)


def acting(task: Task, actions: list[int], seed: int | np.random.SeedSequence) -> Trial:
    """The robot does these actions, one after the other."""
    rows, moved = [], []
    with make_env(task, seed) as env:
        ended, info = True, {}
        for a in actions:
            if ended:
                info = env.reset()[1]
            before = info
            _, r, terminated, truncated, info = env.step(a)
            ended = terminated or truncated
            rows.append((before["state"], a, float(r), info["state"], terminated, truncated))
            changes = (abs(value - before["readings"][name]) for name, value in info["readings"].items())
            moved.append(max(changes) > LEAST_CHANGE)
    return Trial(Transitions(*map(np.array, zip(*rows, strict=True))), np.array(moved))


def learning(task: Task, steps: int, seed: np.random.SeedSequence) -> Transitions:
    """An agent learns with the defaults; what it sees there."""
    agent_seed, env_seed = seed.spawn(2)
    with make_env(task, env_seed) as env:
        history = learn(Agent(task, seed=agent_seed), env, steps, keep=True, progress=False)
    return history.transitions
