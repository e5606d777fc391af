"""Holm's correction of p for many tests, as all studies apply it."""

from collections.abc import Sequence

import numpy as np


def holm_corrected(p_values: Sequence[float]) -> list[float]:
    """p corrected for all of these tests: the smallest times their number, the next times one less, never falling."""
    p = np.array(p_values, dtype=float)
    order = np.argsort(p)
    factors = np.arange(len(p), 0, -1)
    rising = np.maximum.accumulate(p[order] * factors)
    corrected = np.empty(len(p))
    corrected[order] = np.minimum(rising, 1.0)
    return corrected.tolist()
