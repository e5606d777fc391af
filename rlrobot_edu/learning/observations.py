"""The number of the state that an environment shows."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from rlrobot_edu.checks import check_index
from rlrobot_edu.learning.size import Env, Size


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
