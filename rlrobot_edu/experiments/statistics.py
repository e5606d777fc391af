"""What repetitions prove: bands around mean curves, analysis of variance, tests of all pairs, effect sizes."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations
from typing import NamedTuple

import numpy as np
from scipy import special, stats

from rlrobot_edu.experiments.rounding import average, squares, without_rounding
from rlrobot_edu.experiments.tables import Table, Tabled, as_text

# SciPy's noncentral quantiles fail for a statistic above 2500. There a noncentrality is nearly proportional to its
# statistic: it is computed for a smaller statistic, and multiplied by the same factor again.
LARGE = 2500.0
LEVEL = 0.05  # a p-value below it counts as evidence of a difference
DISAGREE = "≠"  # the mark of a pair on which two tests disagree


def mean_band(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Student's t 95 % interval of the mean of n ≥ 2 samples, at every point of a curve.

    samples: array (n, points). Returns two arrays (points,), low and high; where all are equal, both are that number.
    It is exact for samples of a bell curve. Of averages as robots have them it holds the mean in 92 to 97 of 100 cases
    if their skewness is below 1 and n ≥ 10. Above 2, as with some arms, it may be 60 with n = 5 and 78 with n = 30.
    Bootstraps do not keep 95 % either (docs/studies/intervals.md). Of agents in one sample model it says nothing about
    the model of another recording.
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
    were equally good; games_howell: p of the test by Games and Howell; g: Hedges' g, the difference in SDs
    """

    first: str
    second: str
    difference: float
    q: float
    p: float
    games_howell: float
    g: Interval

    @property
    def inference(self) -> str:
        """What may be concluded, in the paper's words: "p<0.01", "p<0.05" or nothing."""
        if self.p < 0.01:
            return "p<0.01"
        if self.p < LEVEL:
            return "p<0.05"
        return ""

    @property
    def tests_disagree(self) -> bool:
        """Whether only one of the two tests finds a difference at the level of 0.05."""
        return (self.p < LEVEL) != (self.games_howell < LEVEL)


@dataclass(frozen=True, repr=False)
class Tukey(Tabled):
    """Tukey's honestly significant difference test: all pairs, with one chance of error for all together.

    It takes all groups to spread alike. Beside its p stands that of the test by Games and Howell (1976), in which each
    pair has the spread of its own two groups. Where one group spreads much more than the others, trust the second.
    """

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
        unequal = games_howell(shifted)
        pairs = []
        for (i, first), (j, second) in combinations(enumerate(groups), 2):
            x, y = rounded[i], rounded[j]
            difference = float(average(x) - average(y))
            error = math.sqrt(anova.ms_within / 2 * (1 / len(x) + 1 / len(y)))
            with np.errstate(all="ignore"):
                q = float(np.divide(abs(difference), error))
            pair = Pair(
                first,
                second,
                difference,
                q,
                float(p_values[i, j]),
                float(unequal[i, j]),
                hedges_g(x, y),
            )
            pairs.append(pair)
        return cls(tuple(pairs))

    def table(self) -> Table:
        """The paper's columns; p by Games and Howell, with ≠ where it says otherwise; the size of each difference."""
        rows: list[list[object]] = []
        for pair in self.pairs:
            rows.append(
                [
                    f"{pair.first} vs {pair.second}",
                    pair.q,
                    shown_p(pair.p),
                    pair.inference,
                    marked_p(pair.games_howell, pair.tests_disagree),
                    pair.difference,
                    pair.g,
                ]
            )
        columns = [
            "pair",
            "HSD Q",
            "HSD p",
            "HSD inference",
            "Games-Howell p",
            "difference",
            "Hedges g [95 %]",
        ]
        caption = "Post-hoc Tukey HSD test"
        if any(pair.tests_disagree for pair in self.pairs):
            caption += f" ({DISAGREE}: the tests disagree at 0.05)"
        return Table(caption, columns, rows)


def shown_p(p: float) -> float | str:
    """A p-value as a table shows it. Of those below 1e-15 only the bound is known: the rest is rounding."""
    return "p < 1e-15" if p < 1e-15 else p


def marked_p(p: float, disagrees: bool) -> float | str:
    """The same, with the mark of a test that says otherwise than the one beside it."""
    if not disagrees:
        return shown_p(p)
    return f"{as_text(shown_p(p))} {DISAGREE}"


def games_howell(groups: Sequence[np.ndarray]) -> np.ndarray:
    """p of every pair by the test of Games and Howell (1976), array (groups, groups).

    Each pair has the spread and the degrees of freedom of its own two groups (Welch, Satterthwaite). The p of two
    constant groups is 0, or NaN where both are one number. groups: arrays (n,) without rounding
    """
    with np.errstate(all="ignore"):
        p_values = stats.tukey_hsd(*groups, equal_var=False).pvalue
    # Of two constant groups the degrees of freedom are 0 / 0.
    for i, j in permutations(range(len(groups)), 2):
        x, y = groups[i], groups[j]
        if np.ptp(x) == np.ptp(y) == 0 and x[0] != y[0]:
            p_values[i, j] = 0.0
    return np.asarray(p_values)


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
