"""Where a seed becomes random numbers."""

import numpy as np

from rlrobot_edu.checks import check_count

# An agent and its robot with the same seed draw different numbers.
ENVIRONMENT = (1,)


def generator(
    seed: int | np.random.SeedSequence | None, role: tuple[int, ...] = ()
) -> np.random.Generator:
    """Random numbers that depend on `seed` and `role` alone; if `seed` is None, they differ each time.

    role: `ENVIRONMENT`, or nothing for an agent, whose numbers are those of ``np.random.default_rng(seed)``. A
    SeedSequence is used unchanged, whatever the role. Raises ValueError if `seed` is not a seed.
    """
    if seed is not None and not isinstance(seed, np.random.SeedSequence):
        check_count("seed", seed, least=0)
        seed = np.random.SeedSequence(int(seed), spawn_key=role)
    return np.random.default_rng(seed)
