"""Which state an observation is."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from rlrobot_edu.learning.size import Env, Size
from rlrobot_edu.task.messages import existing


def state_numbers(env: Env) -> Callable[[Any], int]:
    """Function from an observation to the number of its state. It raises ValueError for one that `env` cannot show."""
    space: Any = env.observation_space
    first, bins = np.ravel(space.start).tolist(), Size.of(env).shape

    @lru_cache(maxsize=100_000)
    def number(observation: tuple[int, ...]) -> int:
        s = 0
        for bin, low, n in zip(observation, first, bins, strict=True):
            s = s * n + existing("bin", bin - low, n)
        return s

    def state_number(observation: Any) -> int:
        try:
            return number(tuple(np.ravel(observation).tolist()))
        except (TypeError, ValueError) as error:
            raise ValueError(f"{env} showed {observation!r:.200}, which is not in its {space}: {error}") from error

    return state_number
