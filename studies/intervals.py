"""How often a 95 % interval of the mean holds it, for few robots: ``python studies/intervals.py`` writes a page.

The final average rewards of the report are taken for the whole population, whose mean is known. Robots are drawn from
them, and each way to make an interval is tried on every draw.
"""

import warnings
from collections.abc import Callable, Mapping
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
from in_markdown import in_markdown
from scipy import stats

from rlrobot_course.play.report import read_averages
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.files import write_whole

AVERAGES = Path("docs/reproduction/averages.csv")
PAGE = Path("docs/studies/intervals.md")
METHODS = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")
SIZES = (5, 10, 30)
DRAWS = 500
RESAMPLES = 999
SKEWNESS = (0, 1, 2, 5)  # the borders of the groups in which the page counts
TOO_OFTEN_OUTSIDE = 0.9  # "95 %" that hold the mean less often than this mislead

Ends = tuple[np.ndarray, np.ndarray]
Interval = Callable[[np.ndarray, np.random.Generator], Ends]


def student(draws: np.ndarray, rng: np.random.Generator) -> Ends:
    """Student's t, as `mean_band` makes it. draws: array (draws, n); returns two arrays (draws,)."""
    return mean_band(draws.T)


def mean_and_error(draws: np.ndarray) -> Ends:
    """Mean and standard error of each row of an array (draws, n), two arrays (draws,)."""
    mean = draws.mean(axis=1)
    error = draws.std(axis=1, ddof=1) / np.sqrt(draws.shape[1])
    error[np.ptp(draws, axis=1) == 0] = 0.0
    return mean, error


def bootstrap_t(draws: np.ndarray, rng: np.random.Generator) -> Ends:
    """The same with the quantiles of t among resamples. Source: Efron & Tibshirani (1993), section 12.5."""
    means, errors = mean_and_error(draws)
    low = np.empty(len(draws))
    high = np.empty(len(draws))
    for i, x in enumerate(draws):
        again, their_errors = mean_and_error(rng.choice(x, (RESAMPLES, len(x))))
        with np.errstate(all="ignore"):
            t = (again - means[i]) / their_errors
        # 0 / 0: a resample of equal numbers, all at the mean
        t[np.isnan(t)] = 0.0
        below, above = np.quantile(t, [0.025, 0.975], method="inverted_cdf")
        if errors[i] == 0:
            below, above = 0.0, 0.0
        low[i] = means[i] - above * errors[i]
        high[i] = means[i] - below * errors[i]
    return low, high


def bca(draws: np.ndarray, rng: np.random.Generator) -> Ends:
    """The bias-corrected and accelerated bootstrap of SciPy; of equal numbers that number itself."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ends = stats.bootstrap(
            (draws,),
            np.mean,
            axis=1,
            n_resamples=RESAMPLES,
            batch=100,
            method="BCa",
            rng=rng,
        ).confidence_interval
    mean = draws.mean(axis=1)
    is_known = np.isfinite(ends.low) & np.isfinite(ends.high)
    return np.where(is_known, ends.low, mean), np.where(is_known, ends.high, mean)


INTERVALS: Mapping[str, Interval] = {
    "Student's t": student,
    "bootstrap-t": bootstrap_t,
    "BCa bootstrap": bca,
}


PAGE = """\
# How often does ± hold the mean?

A mean ± a half in this project is Student's t interval of 95 %. It is exact if the averages lie on a bell curve. Those
of robots often do not: most arms of a method reach the object, and a few never do. How often does such an interval hold
the true mean?

We took the final average rewards of the [report](../reproduction/README.md) for whole populations, {count} of them, on
robots and on sample models. From each we drew {few}, {some} and {many} robots, {draws} times, and made three kinds of
interval from every draw: Student's t; the bootstrap-t, which takes the quantiles of t from {resamples} resamples; and
the BCa bootstrap. A share of {draws} draws errs by two to four points. `python studies/intervals.py` writes this page
in some six minutes.

{summary}

**None of the three keeps its promise everywhere.** With few robots the BCa bootstrap is far too narrow. The bootstrap-t
comes nearest. But with {many} robots it, too, holds the mean in less than 90 % of the draws from {below} of the {count}
populations (t: {below_t}), and with few it is much wider. So the project keeps Student's t, and this page says when to
distrust it: where averages are much skewed.

{by_skewness}

{worst}

What this does not show: a population of 30 recorded averages is coarser than the true one, and rare robots that the
report did not meet are missing in it. The true shares may be lower. Nor do these intervals, of robots in a model of one
recording, say anything about another recording.
"""


class Coverage(NamedTuple):
    """Of one population with n robots: how often each interval holds the mean, and how wide it is beside Student's."""

    population: str
    skewness: float
    n: int
    held: Mapping[str, float]
    width: Mapping[str, float]


def populations() -> dict[str, np.ndarray]:
    """Final average rewards of the paper's methods on robots and models, by their set-up and method."""
    found = {}
    for (experiment, length), groups in read_averages(AVERAGES).items():
        kind, _, task = experiment.partition("_")
        if kind in ("robot", "model"):
            for method in METHODS:
                found[f"{task}, {kind}, {length}, {method}"] = groups[method]
    return found


def coverage(name: str, population: np.ndarray, n: int) -> Coverage:
    """Try every interval on draws of n robots."""
    rng = np.random.default_rng(n)
    draws = rng.choice(population, (DRAWS, n))
    mean = population.mean()
    held, width = {}, {}
    for way, interval in INTERVALS.items():
        low, high = interval(draws, rng)
        # rounding must not put the mean of equal numbers outside
        slack = 1e-9 * max(1.0, abs(mean))
        held[way] = float(np.mean((low <= mean + slack) & (high >= mean - slack)))
        width[way] = float(np.median(high - low))
    student_width = width["Student's t"] or 1.0
    relative = {way: its / student_width for way, its in width.items()}
    skewness = 0.0
    if np.ptp(population) > 0:
        skewness = float(stats.skew(population))
    return Coverage(name, skewness, n, held, relative)


def summary(found: list[Coverage]) -> Table:
    """For each interval and number of robots: coverage over the populations."""
    rows: list[list[object]] = []
    for way in INTERVALS:
        for n in SIZES:
            its = [one for one in found if one.n == n]
            held = np.array([one.held[way] for one in its])
            too_few = int(np.sum(held < TOO_OFTEN_OUTSIDE))
            width = float(np.median([one.width[way] for one in its]))
            rows.append(
                [
                    way,
                    n,
                    f"{np.median(held):.0%}",
                    f"{held.min():.0%}",
                    f"{too_few} of {len(its)}",
                    f"{width:.2f}" if width < 100 else "unbounded",
                ]
            )
    columns = [
        "interval",
        "robots",
        "median",
        "lowest",
        "below 90 %",
        "width, t = 1",
    ]
    return Table("How often a 95 % interval holds the mean", columns, rows)


def worst(found: list[Coverage], most: int = 10) -> Table:
    """The populations in which Student's t does worst with the most robots."""
    by_population: dict[str, dict[int, Coverage]] = {}
    for one in found:
        by_population.setdefault(one.population, {})[one.n] = one

    def held_by_t(its: dict[int, Coverage]) -> float:
        return its[SIZES[-1]].held["Student's t"]

    rows: list[list[object]] = []
    for its in sorted(by_population.values(), key=held_by_t)[:most]:
        shown = [
            " / ".join(f"{its[n].held[way]:.0%}" for n in SIZES) for way in INTERVALS
        ]
        first = its[SIZES[0]]
        rows.append([first.population, first.skewness, *shown])
    columns = ["population", "skewness", *INTERVALS]
    robots = " / ".join(str(n) for n in SIZES)
    return Table(f"Where t does worst, with {robots} robots", columns, rows)


def by_skewness(found: list[Coverage]) -> Table:
    """What Student's t does in populations that are skewed little, more and much."""
    rows: list[list[object]] = []
    for low, high in pairwise(SKEWNESS):
        its = [one for one in found if low <= abs(one.skewness) < high]
        cells = []
        for n in SIZES:
            held = [one.held["Student's t"] for one in its if one.n == n]
            cells.append(f"{min(held):.0%} to {max(held):.0%}")
        rows.append([f"{low:g} to {high:g}", len(its) // len(SIZES), *cells])
    robots = [f"{n} robots" for n in SIZES]
    columns = ["skewness, without sign", "populations", *robots]
    return Table("How often Student's t holds the mean", columns, rows)


def page(found: list[Coverage]) -> str:
    """The whole page."""
    many = SIZES[-1]
    below = {
        way: sum(one.held[way] < TOO_OFTEN_OUTSIDE for one in found if one.n == many)
        for way in INTERVALS
    }
    return PAGE.format(
        count=len(found) // len(SIZES),
        draws=DRAWS,
        resamples=RESAMPLES,
        few=SIZES[0],
        some=SIZES[1],
        many=many,
        summary=in_markdown(summary(found)),
        below=below["bootstrap-t"],
        below_t=below["Student's t"],
        by_skewness=in_markdown(by_skewness(found)),
        worst=in_markdown(worst(found)),
    )


def main() -> None:
    """Measure, and write the page."""
    found = []
    for name, population in populations().items():
        for n in SIZES:
            found.append(coverage(name, population, n))
        print(name, flush=True)
    write_whole(PAGE, page(found))


if __name__ == "__main__":
    main()
