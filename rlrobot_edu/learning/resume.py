"""Where an agent left its environment, so that it can go on there."""

from typing import NamedTuple

import gymnasium

from rlrobot_edu.checks import WHOLE
from rlrobot_edu.learning.size import Env

# Attributes by which environments and their wrappers tell where they stand; WALK is put there by our own loop.
WALK = "_walk_of_an_agent"
PLACE = ("state", "s", "episode_step", "_elapsed_steps", WALK)


class ResumePoint(NamedTuple):
    """Where an agent left its episode, so that it can go on there.

    steps, reward: number of steps of the episode so far, and the sum of their rewards
    place: what the environment said of where it stood, see `place_of`
    """

    steps: int = 0
    reward: float = 0.0
    place: dict[str, int] | None = None


def place_of(env: Env) -> dict[str, int]:
    """The whole numbers by which `env` and its wrappers tell where they stand."""
    place = place_of(env.env) if isinstance(env, gymnasium.Wrapper) else {}
    for name in PLACE:
        number = vars(env).get(name)
        if isinstance(number, WHOLE):
            place[name] = int(number)
    return place
