"""Numbers that rounding alone makes unequal: equal again, so that a difference of nothing is none."""

from collections.abc import Sequence

import numpy as np

# Each operation rounds by half an ulp. Numbers that differ by less than this part of the largest are taken as equal.
ROUNDING = 64 * float(np.finfo(float).eps)


def without_rounding(
    groups: Sequence[np.ndarray], scale: float = 0.0
) -> list[np.ndarray]:
    """The same groups, arrays (n,), in which numbers that differ by rounding alone are equal.

    scale: the size of what was rounded, where that is larger than they are
    """
    ordered = np.sort(np.concatenate(groups))
    largest = max(scale, np.abs(ordered).max(initial=0))
    equals_previous = np.diff(ordered, prepend=np.nan) <= ROUNDING * largest
    distinct = ordered[~equals_previous]
    return [
        distinct[np.searchsorted(distinct, group, side="right") - 1] for group in groups
    ]


def average(x: np.ndarray) -> np.float64:
    """The mean; of equal numbers that number itself, which a sum that is rounded may miss."""
    return np.float64(x[0] if np.ptp(x) == 0 else np.mean(x))


def squares(x: np.ndarray) -> float:
    """Sum of the squared deviations from the mean; of equal numbers 0."""
    return float(np.sum((x - average(x)) ** 2))
