"""Where a seed becomes random numbers."""

import numpy as np

from rlrobot_edu.task.messages import check_count

ENVIRONMENT = (1,)  # so that no robot is moved by the numbers that its agent has drawn


def generator(seed: int | np.random.SeedSequence | None, role: tuple[int, ...] = ()) -> np.random.Generator:
    """Random numbers that depend on `seed` and `role` alone; with None, fresh ones. An agent's role is ().

    A SeedSequence is taken as it is. Raises ValueError for what is no seed.
    """
    if seed is None or isinstance(seed, np.random.SeedSequence):
        return np.random.default_rng(seed)
    check_count("seed", seed, least=0)
    return np.random.default_rng(np.random.SeedSequence(int(seed), spawn_key=role))
