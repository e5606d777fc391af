"""What an agent must know about a world: how many states and actions it has, and its largest reward."""

import math
from numbers import Real
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete

from rlrobot_edu.checks import check_count, check_table
from rlrobot_edu.task.task import Task

Env = gymnasium.Env[Any, Any]
OLD_GYM = "one of the old Gym needs shimmy.GymV21CompatibilityV0(env=…), which `pip install shimmy` brings"


class Size(NamedTuple):
    """How large a world is.

    shape, n_actions: bins of each input variable, number of actions
    r_max: largest reward
    episode_steps: steps of a whole episode; a goal counts for the rest of them. None where it does not
    """

    shape: tuple[int, ...]
    n_actions: int
    r_max: float = 1.0
    episode_steps: int | None = None

    @classmethod
    def of(cls, world: Any) -> "Size":
        """Size of a task, an environment, or of a model, which has the same fields; else it raises ValueError."""
        if isinstance(world, Task):
            return cls(
                world.states.shape,
                world.actions.n,
                max(world.rewards),
                world.episode_steps,
            )
        if isinstance(world, gymnasium.Env):
            space, actions = world.observation_space, world.action_space
            if not isinstance(space, Discrete | MultiDiscrete):
                raise ValueError(
                    f"a tabular agent needs MultiDiscrete or Discrete observations, not {space}"
                )
            if not isinstance(actions, Discrete) or actions.start != 0:
                raise ValueError(
                    f"a tabular agent needs Discrete actions that start at 0, not {actions}"
                )
            bins = np.ravel(space.n if isinstance(space, Discrete) else space.nvec)
            r_max = getattr(world.unwrapped, "r_max", None)
            episode_steps = getattr(world.unwrapped, "episode_steps", None)
            size = cls(
                tuple(bins.tolist()),
                int(actions.n),
                1.0 if r_max is None else r_max,
                episode_steps,
            )
        elif all(hasattr(world, name) for name in cls._fields):
            size = cls(
                tuple(world.shape),
                world.n_actions,
                world.r_max,
                world.episode_steps,
            )
        else:
            given = f"got {type(world).__name__}"
            if hasattr(world, "step"):
                given += f"; {OLD_GYM}"
            raise ValueError(
                f"a world is a Task, SampleModel or Gymnasium environment, {given}"
            )
        for n in (*size.shape, size.n_actions):
            check_count("the number of bins of an input, or of actions,", n)
        check_table(size.n_states, size.n_actions)
        check_count("episode_steps of a world", size.episode_steps, or_none=True)
        if not (isinstance(size.r_max, Real) and math.isfinite(size.r_max)):
            raise ValueError(
                f"r_max of a world must be a finite number, got {size.r_max!r:.200}"
            )
        return size

    @property
    def n_states(self) -> int:
        """Number of states."""
        return math.prod(self.shape)


def can_end(world: object) -> bool:
    """Whether episodes can end for good: in a task by its goal, in a model as recorded, elsewhere as far as known."""
    task = task_of(world)
    if task is not None:
        return task.goal is not None
    inner = getattr(world, "unwrapped", world)
    recorded = getattr(getattr(inner, "model", inner), "terminated", None)
    return not isinstance(recorded, np.ndarray) or bool(recorded.any())


def task_of(world: object) -> Task | None:
    """The task that `world` is, or that an environment runs; None for a world without one."""
    if isinstance(world, Task):
        return world
    inner = getattr(world, "unwrapped", world)
    task = getattr(inner, "task", None)
    return task if isinstance(task, Task) else None
