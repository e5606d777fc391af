"""Where a seed becomes random numbers."""

import numpy as np

from rlrobot_edu.task.messages import check_count


def generator(seed: int | np.random.SeedSequence | None) -> np.random.Generator:
    """Random numbers that depend on `seed` alone; with None, fresh ones. Raises ValueError for what is no seed."""
    if seed is not None and not isinstance(seed, np.random.SeedSequence):
        check_count("seed", seed, least=0)
    return np.random.default_rng(seed)
