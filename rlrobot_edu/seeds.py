"""Where a seed becomes random numbers."""

import numpy as np

from rlrobot_edu.checks import check_count

ENVIRONMENT = (1,)  # so that no robot is moved by the numbers that its agent has drawn


def generator(
    seed: int | np.random.SeedSequence | None, role: tuple[int, ...] = ()
) -> np.random.Generator:
    """Random numbers that depend on `seed` and `role` alone, those of each role its own; with None, fresh ones.

    role: `ENVIRONMENT`, or nothing for an agent, whose numbers are those of ``np.random.default_rng(seed)``. It says
    nothing to a SeedSequence, which is taken as it is. Raises ValueError for what is no seed.
    """
    if seed is not None and not isinstance(seed, np.random.SeedSequence):
        check_count("seed", seed, least=0)
        seed = np.random.SeedSequence(int(seed), spawn_key=role)
    return np.random.default_rng(seed)
