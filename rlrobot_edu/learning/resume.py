"""Where an agent left its environment, so that it can go on there."""

import weakref
from typing import NamedTuple
from uuid import uuid4

import gymnasium

from rlrobot_edu.checks import WHOLE
from rlrobot_edu.learning.size import Env

# Attributes that show where environments and their wrappers are
COUNTS = ("episode_step", "_elapsed_steps")
PLACE = ("state", "s", *COUNTS)

# The last call of `learn` or `steps` in the environment with this id. Some environments have none of these attributes:
# only this shows that another agent has acted there. It is kept here, because the environment may not be ours.
_last_walk: dict[int, int] = {}


class Place(NamedTuple):
    """Where an environment is, as far as this can be seen from outside.

    walk: number of the last call of `learn` or `steps` in it; None without any, as for a copy
    numbers: its state and the steps of its episode, if it and its wrappers have them
    """

    walk: int | None
    numbers: dict[str, int]


class ResumePoint(NamedTuple):
    """Where an agent left its episode, so that it can go on there.

    It holds no environment: an agent can be copied and sent away without it.

    steps, reward: number of steps of the episode so far, and the sum of their rewards
    place: where the environment was then
    """

    steps: int = 0
    reward: float = 0.0
    place: Place | None = None


def place_of(env: Env) -> Place:
    """Where `env` is now."""
    return Place(_last_walk.get(id(env.unwrapped)), _numbers_of(env))


def _numbers_of(env: Env) -> dict[str, int]:
    numbers = _numbers_of(env.env) if isinstance(env, gymnasium.Wrapper) else {}
    attributes = vars(env)
    for name in PLACE:
        number = attributes.get(name)
        if isinstance(number, WHOLE):
            numbers[name] = int(number)
    return numbers


def begin_walk(env: Env) -> Place:
    """Note that an agent begins to act in `env`, so that no other agent can resume there. Returns where it is."""
    inner = env.unwrapped
    key = id(inner)
    if key not in _last_walk:
        weakref.finalize(inner, _last_walk.pop, key, None)  # another one may get its id
    _last_walk[key] = uuid4().int  # no number of another process either
    return place_of(env)


def is_at(env: Env, place: Place | None) -> bool:
    """Whether `env` is where it was left, and no other agent has acted in it since, as far as this can be seen.

    A copy of the environment can take its place, if it counts the steps of its episode.
    """
    if place is None:
        return False
    here = place_of(env)
    if here.walk is None and not here.numbers.keys().isdisjoint(COUNTS):
        return here.numbers == place.numbers
    return here == place
