"""What an agent must know about a world: how many states and actions it has, and its largest reward."""

import math
import warnings
from copy import copy
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete
from numpy.typing import NDArray

from rlrobot_edu.checks import (
    LARGEST_NUMBER,
    check_between,
    check_count,
    check_table,
    describe_error,
)
from rlrobot_edu.task.task import Task

Env = gymnasium.Env[Any, Any]
# Behind one of these an agent sees, does or earns something else than the task says.
CHANGING = (
    gymnasium.ObservationWrapper,
    gymnasium.ActionWrapper,
    gymnasium.RewardWrapper,
)
OLD_GYM = "one of the old Gym needs shimmy.GymV21CompatibilityV0(env=…), which `pip install shimmy` brings"


class Size(NamedTuple):
    """How large a world is.

    shape, n_actions: bins of each input variable, number of actions
    r_max: largest reward, also behind wrappers that change it, see `rewards_of`
    episode_steps: steps of a whole episode, or of what a time limit leaves of it; a goal counts for the rest of them.
        None where it does not
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
            rewards = rewards_of(world)
            size = cls(
                tuple(bins.tolist()),
                int(actions.n),
                max(rewards) if rewards else 1.0,
                _said_by(world, "episode_steps"),
            )
            limit = time_limit(world)
        elif all(hasattr(world, name) for name in cls._fields):
            size = cls(
                tuple(world.shape),
                world.n_actions,
                world.r_max,
                world.episode_steps,
            )
            limit = getattr(world, "time_limit", None)
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
        check_between("r_max of a world", size.r_max, -LARGEST_NUMBER, LARGEST_NUMBER)
        if limit is not None and size.episode_steps is not None:
            size = size._replace(episode_steps=min(limit, size.episode_steps))
        return size

    @property
    def n_states(self) -> int:
        """Number of states."""
        return math.prod(self.shape)


def _said_by(env: Env, name: str) -> Any:
    """The attribute `name` of the outermost wrapper that has it, or of the environment itself; None without it."""
    while isinstance(env, gymnasium.Wrapper):
        if getattr(env, name, None) is not None:
            break
        env = env.env
    return getattr(env, name, None)


def rewards_of(env: Env) -> tuple[float, ...]:
    """The rewards that `env` can give: those of its task or model, as its wrappers change them; empty if unknown.

    Of a world that names an ``r_max`` alone, it is that one. A wrapper that changes rewards in a `step` of its own
    needs such an attribute, too. Raises ValueError if a wrapper cannot change one of the rewards.
    """
    r_max = getattr(env, "r_max", None)
    if isinstance(env, gymnasium.Wrapper):
        if r_max is not None:
            return (r_max,)
        rewards = rewards_of(env.env)
        if isinstance(env, gymnasium.RewardWrapper):
            rewards = tuple(_changed(env, r) for r in rewards)
        return rewards
    if r_max is None:
        return ()
    task = getattr(env, "task", None)
    if isinstance(task, Task):
        return tuple(task.rewards)
    recorded = getattr(getattr(env, "model", None), "rewards", None)
    if isinstance(recorded, np.ndarray):
        return tuple(recorded.tolist())
    return (r_max,)


def _changed(wrapper: gymnasium.RewardWrapper[Any, Any], r: float) -> float:
    """What a wrapper makes of a reward."""
    try:
        # Of a copy, so that a wrapper that counts in its attributes goes on undisturbed.
        changed = np.asarray(copy(wrapper).reward(r)).item()
        check_between("a reward", changed, -LARGEST_NUMBER, LARGEST_NUMBER)
        return float(changed)
    except Exception as error:
        advice = "if it never comes, give the wrapper the largest reward as its attribute r_max"
        raise ValueError(
            f"{wrapper} cannot change the reward {r!r:.80}: {describe_error(error)}; {advice}"
        ) from error


def warn_of_other_rewards(env: Env, rewards: NDArray[np.float64]) -> None:
    """Say so if a wrapper paid what the world within it never pays: then Rmax may be another one."""
    known = rewards_of(env)
    # A single one is the largest, not all of them.
    if not isinstance(env, gymnasium.Wrapper) or len(known) < 2:
        return
    others = np.setdiff1d(rewards, known)
    if len(others):
        warnings.warn(
            f"{env} paid {others[-1]:g}, which is none of the rewards {known!s:.200} that it wraps; "
            f"so {max(known):g} may not be the largest: give the wrapper an attribute r_max, "
            "the largest reward, and make the agent anew",
            stacklevel=3,
        )


def time_limit(env: Env) -> int | None:
    """Steps after which Gymnasium's TimeLimit cuts an episode off, or a model of such an environment."""
    inner = time_limit(env.env) if isinstance(env, gymnasium.Wrapper) else None
    return min(filter(None, (inner, vars(env).get("_max_episode_steps"))), default=None)


def longest_episode(env: Env) -> int | None:
    """Steps after which an episode is cut off, by the world or by a time limit; None if nothing cuts it off."""
    return Size.of(env).episode_steps or time_limit(env)


def can_end(world: Any) -> bool:
    """Whether episodes can end for good: in a task by its goal, in a model as recorded, elsewhere as far as known."""
    while isinstance(world, gymnasium.Wrapper):
        # Gymnasium's own wrappers end no episode, others may.
        if type(world).step.__module__.partition(".")[0] != "gymnasium":
            return True
        world = world.env
    task = task_of(world)
    if task is not None:
        return task.goal is not None
    recorded = getattr(getattr(world, "model", world), "terminated", None)
    return not isinstance(recorded, np.ndarray) or bool(recorded.any())


def task_of(world: Any) -> Task | None:
    """The task that `world` is, or that an environment runs.

    None for a world without one, and behind a wrapper that changes what is seen, done or earned there.
    """
    while isinstance(world, gymnasium.Wrapper):
        if isinstance(world, CHANGING):
            return None
        world = world.env
    task = getattr(world, "task", None)
    for candidate in (world, task):
        if isinstance(candidate, Task):
            return candidate
    return None
