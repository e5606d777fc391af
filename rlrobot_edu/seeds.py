"""Where a seed becomes random numbers."""

import numpy as np


def check_seed(seed: object) -> None:
    """Raises ValueError for what is no seed."""
    whole = isinstance(seed, int | np.integer) and seed >= 0
    if not (seed is None or whole or isinstance(seed, np.random.SeedSequence)):
        raise ValueError(
            f"seed must be None, a whole number of at least 0 or a numpy.random.SeedSequence, got {seed!r:.200}"
        )


def generator(seed: int | np.random.SeedSequence | None) -> np.random.Generator:
    """Random numbers that depend on `seed` alone. Raises ValueError for what is none."""
    check_seed(seed)
    return np.random.default_rng(seed)
