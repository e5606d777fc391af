"""Where a seed becomes random numbers."""

import numpy as np


def check_number(seed: object) -> None:
    """Raises ValueError unless the seed is a number, one that a file can keep."""
    if not (isinstance(seed, int | np.integer) and seed >= 0):
        kind = type(seed).__name__ if isinstance(seed, np.random.SeedSequence) else f"{seed!r:.200}"
        raise ValueError(f"seed must be a whole number of at least 0, got {kind}")


def generator(seed: int | np.random.SeedSequence | None) -> np.random.Generator:
    """Random numbers that depend on `seed` alone; with None, fresh ones. Raises ValueError for what is no seed."""
    if seed is not None and not isinstance(seed, np.random.SeedSequence):
        check_number(seed)
    return np.random.default_rng(seed)
