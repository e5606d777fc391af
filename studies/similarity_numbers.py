"""What the numbers of similarity.json say: means with intervals, trends, ranks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy import stats
from similarity_split import factors

LENGTHS = (3600, 20_000, 200_000)  # steps over which rewards are averaged
METHOD = "TOSL+QBIASSR"  # whose spectrum is shown
LONG_WORKED_EXAMPLE = 50_000  # steps of a teacher: 24 states, and no compiled world
TRIED = 10  # times that a teacher must have tried every action of a state
Found = Mapping[str, Any]


class Estimate(NamedTuple):
    """A mean and half of its 95 % interval (Student's t)."""

    mean: float
    half: float

    def __str__(self) -> str:
        return f"{self.mean:+.2f} ± {self.half:.2f}".replace("-", "−")


def estimate(values: Sequence[float] | np.ndarray) -> Estimate:
    """Mean and interval of independent numbers."""
    half = stats.t.ppf(0.975, len(values) - 1) * stats.sem(values)
    return Estimate(float(np.mean(values)), float(half))


def gains(found: Found, temperature: str, rival: str) -> np.ndarray:
    """What QBIASSR earns more than the rival, array (orders, worlds, lengths)."""
    orders = found["orders"][temperature]
    return np.array(
        [np.subtract(rows["QBIASSR"], rows[rival]) for rows in orders], dtype=float
    )


def slope(found: Found, temperature: str, length: int) -> Estimate:
    """By how much the gain over SR changes with each order: the slope of a line in each world, and their mean."""
    its = gains(found, temperature, "SR")[:, :, length]
    orders = np.arange(len(its))
    return estimate(np.polyfit(orders, its, 1)[0])


def mean_factors(shares: np.ndarray) -> np.ndarray:
    """The mean of 2 - k / n over the orders, weighed by spectra, arrays (…, n + 1)."""
    return shares @ factors(shares.shape[-1] - 1)


def low(shares: np.ndarray) -> float:
    """What orders 0 and 1 have, in per cent."""
    return float(100 * shares[..., :2].sum(axis=-1).mean())


def gain_of_robots(its: Mapping[str, Sequence[float]]) -> Estimate:
    """What robots with the bias earn more than others without it (Welch's interval)."""
    test = stats.ttest_ind(its["QBIASSR"], its["SR"], equal_var=False)
    interval = test.confidence_interval(0.95)
    return Estimate(
        float(interval.low + interval.high) / 2,
        float(interval.high - interval.low) / 2,
    )


class Rank(NamedTuple):
    """Spearman's rank correlation, its exact p by all permutations, and from where on p is below 0.05."""

    rho: float
    p: float
    critical: float


def rank_correlation(found: Found) -> Rank:
    """Of the advice skill with the gain, over the tasks."""
    skills = [np.mean(its["skill"]) for its in found["advice"].values()]
    gained = [gain_of_robots(its).mean for its in found["advice"].values()]

    def rho_of(gained: np.ndarray) -> float:
        return float(stats.spearmanr(skills, gained).statistic)

    test = stats.permutation_test(
        (gained,), rho_of, permutation_type="pairings", n_resamples=np.inf
    )
    null = np.sort(np.abs(test.null_distribution))
    exceeded = 1 - np.searchsorted(null, null - 1e-9) / len(null)
    return Rank(
        float(test.statistic), float(test.pvalue), float(null[exceeded < 0.05][0])
    )
