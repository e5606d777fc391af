"""What repetitions prove: bands around mean curves, analysis of variance, Tukey's test, effect sizes."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy import special, stats

from rlrobot_edu.experiments.rounding import average, squares, without_rounding
from rlrobot_edu.experiments.tables import Table, Tabled

# SciPy's noncentral quantiles fail for a statistic above 2500. There a noncentrality is nearly proportional to its
# statistic: it is computed for a smaller statistic, and multiplied by the same factor again.
LARGE = 2500.0


def mean_band(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Student's t 95 % interval of the mean of n ≥ 2 samples, at every point of a curve.

    samples: array (n, points). Returns two arrays (points,), low and high; where all are equal, both are that number.
    A bootstrap of so few would be too narrow: of 5 repetitions its "95 %" hold the mean in 84 of 100 cases.
    """
    # rounding can put the mean of equal samples beside them
    mean = np.clip(samples.mean(axis=0), samples.min(axis=0), samples.max(axis=0))
    half = stats.t.ppf(0.975, len(samples) - 1) * stats.sem(samples - mean)
    return mean - half, mean + half


class Interval(NamedTuple):
    """An estimate and its 95 % confidence interval."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:.2f} [{self.low:.2f}, {self.high:.2f}]"


@dataclass(frozen=True, repr=False)
class Anova(Tabled):
    """A one-way analysis of variance, from its sums of squares and degrees of freedom."""

    ss_between: float
    df_between: int
    ss_within: float
    df_within: int

    @classmethod
    @np.errstate(over="ignore")
    def of(cls, groups: Sequence[np.ndarray]) -> "Anova":
        """The analysis of groups, arrays (n,). Raises ValueError unless there are two, of two each."""
        if len(groups) < 2 or min(map(len, groups)) < 2:
            raise ValueError(
                "an analysis of variance needs at least two methods with two repetitions each"
            )
        groups = without_rounding(groups)
        everything = np.concatenate(groups)
        between = sum(len(g) * (average(g) - average(everything)) ** 2 for g in groups)
        within = sum(map(squares, groups))
        return cls(
            float(between), len(groups) - 1, within, len(everything) - len(groups)
        )

    @property
    def ms_between(self) -> float:
        """Mean square between the groups."""
        return self.ss_between / self.df_between

    @property
    def ms_within(self) -> float:
        """Mean square within the groups: the variance that repetitions of one method have."""
        return self.ss_within / self.df_within

    @property
    @np.errstate(all="ignore")
    def f(self) -> float:
        """How many times larger the variance between the groups is than chance would make it; infinity, NaN for 0."""
        return float(np.divide(self.ms_between, self.ms_within))

    @property
    def p(self) -> float:
        """Probability of such an F, or a larger one, if all methods were equally good."""
        return float(stats.f.sf(self.f, self.df_between, self.df_within))

    @property
    def eta_squared(self) -> Interval:
        """Share of all variance that the method explains; interval from the noncentral F (Steiger 2004)."""
        n = self.df_between + self.df_within + 1
        total = self.ss_between + self.ss_within
        scale = max(1.0, self.f * self.df_between / LARGE)
        # noncentralities, for which this F is at either end of the distribution
        ends = scale * special.ncfdtrinc(
            self.df_between, self.df_within, [0.975, 0.025], self.f / scale
        )
        low, high = ends / (ends + n)
        return Interval(
            self.ss_between / total if total else math.nan, float(low), float(high)
        )

    def table(self) -> Table:
        """The table in the paper's layout."""
        rows: list[list[object]] = [
            [
                "between groups",
                self.ss_between,
                self.df_between,
                self.ms_between,
                self.f,
                shown_p(self.p),
            ],
            [
                "within groups",
                self.ss_within,
                self.df_within,
                self.ms_within,
                None,
                None,
            ],
            [
                "total",
                self.ss_between + self.ss_within,
                self.df_between + self.df_within,
                None,
                None,
                None,
            ],
        ]
        columns = ["source", "sum of squares", "df", "mean square", "F", "p-value"]
        return Table(f"ANOVA: η² = {self.eta_squared}", columns, rows)


class Pair(NamedTuple):
    """Two methods in Tukey's test.

    difference: of their means; q: the test's statistic; p: its probability, or that of a larger one, if all methods
    were equally good; g: Hedges' g, the difference in SDs
    """

    first: str
    second: str
    difference: float
    q: float
    p: float
    g: Interval

    @property
    def inference(self) -> str:
        """What may be concluded, in the paper's words: "p<0.01", "p<0.05" or nothing."""
        if self.p < 0.01:
            return "p<0.01"
        if self.p < 0.05:
            return "p<0.05"
        return ""


@dataclass(frozen=True, repr=False)
class Tukey(Tabled):
    """Tukey's honestly significant difference test: all pairs, with one chance of error for all together."""

    pairs: tuple[Pair, ...]

    @classmethod
    def of(cls, groups: Mapping[str, np.ndarray]) -> "Tukey":
        """The test of these groups (unequal sizes: Tukey–Kramer)."""
        anova = Anova.of(list(groups.values()))
        rounded = without_rounding(list(groups.values()))
        # Where all numbers are equal they become 0, whose mean and variance are exact.
        shifted = [group - rounded[0][0] for group in rounded]
        with np.errstate(all="ignore"):
            p_values = stats.tukey_hsd(*shifted).pvalue
        pairs = []
        for (i, first), (j, second) in combinations(enumerate(groups), 2):
            x, y = rounded[i], rounded[j]
            difference = float(average(x) - average(y))
            error = math.sqrt(anova.ms_within / 2 * (1 / len(x) + 1 / len(y)))
            with np.errstate(all="ignore"):
                q = float(np.divide(abs(difference), error))
            p = float(p_values[i, j])
            pairs.append(Pair(first, second, difference, q, p, hedges_g(x, y)))
        return cls(tuple(pairs))

    def table(self) -> Table:
        """The table in the paper's layout, with the size of each difference."""
        rows = []
        for pair in self.pairs:
            rows.append(
                [
                    f"{pair.first} vs {pair.second}",
                    pair.q,
                    shown_p(pair.p),
                    pair.inference,
                    pair.difference,
                    pair.g,
                ]
            )
        columns = [
            "pair",
            "HSD Q statistic",
            "HSD p-value",
            "HSD inference",
            "difference",
            "Hedges g [95 %]",
        ]
        return Table("Post-hoc Tukey HSD test", columns, rows)


def shown_p(p: float) -> float | str:
    """A p-value as a table shows it. Of those below 1e-15 only the bound is known: the rest is rounding."""
    return "p < 1e-15" if p < 1e-15 else p


def hedges_g(x: np.ndarray, y: np.ndarray) -> Interval:
    """Difference of two means in SDs, without small-sample bias; interval from the noncentral t.

    Source: Hedges (1981). Positive where `x` has the larger mean. x, y: arrays (n,) without rounding
    """
    df = len(x) + len(y) - 2
    unit = math.sqrt(1 / len(x) + 1 / len(y))
    sd = math.sqrt((squares(x) + squares(y)) / df)
    if sd == 0 or df < 2:
        return Interval(math.nan, math.nan, math.nan)
    correction = math.exp(math.lgamma(df / 2) - math.lgamma((df - 1) / 2)) / math.sqrt(
        df / 2
    )
    t = float(average(x) - average(y)) / sd / unit
    scale = max(1.0, abs(t) / LARGE)
    low = scale * float(special.nctdtrinc(df, 0.975, t / scale))
    high = scale * float(special.nctdtrinc(df, 0.025, t / scale))
    to_sds = correction * unit
    return Interval(to_sds * t, to_sds * low, to_sds * high)
