"""The number of the state that an environment shows, and where an agent left that environment."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from rlrobot_edu.checks import WHOLE, check_index
from rlrobot_edu.learning.size import Env, Size

# Attributes by which environments and their wrappers tell where they stand; WALK is put there by our own loop.
WALK = "_walk_of_an_agent"
PLACE = ("state", "s", "episode_step", "_elapsed_steps", WALK)


class Left(NamedTuple):
    """Where an agent left its episode, so that it can go on there.

    steps, reward: number of steps of the episode so far, and the sum of their rewards
    place: what the environment told of where it stood, see `place_of`
    """

    steps: int = 0
    reward: float = 0.0
    place: dict[str, int] | None = None


def place_of(env: Env) -> dict[str, int]:
    """The whole numbers by which `env` and its wrappers tell where they stand."""
    inner = place_of(env.env) if isinstance(env, gymnasium.Wrapper) else {}
    own = vars(env)
    return inner | {n: int(own[n]) for n in PLACE if isinstance(own.get(n), WHOLE)}


def state_numbers(env: Env) -> Callable[[Any], int]:
    """Function from an observation to the number of its state. It raises ValueError for one that `env` cannot show."""
    space: Any = env.observation_space
    first = np.ravel(space.start).tolist()
    bins = Size.of(env).shape

    @lru_cache(maxsize=100_000, typed=True)
    def number(*observation: int) -> int:
        s = 0
        for bin, low, n in zip(observation, first, bins, strict=True):
            s = s * n + check_index("bin", bin - low, n)
        return s

    def state_number(observation: Any) -> int:
        try:
            return number(*np.ravel(observation).tolist())
        except (TypeError, ValueError) as error:
            showed = f"{env} showed {observation!r:.200}"
            raise ValueError(
                f"{showed}, which is not in its {space}: {error}"
            ) from error

    return state_number
