"""The figures of lesson 15: what chance alone does, and the paper's differences compared with the report's."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.ticker import PercentFormatter
from scipy import stats

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    RED,
    Picture,
    chart,
    name_rows,
)
from rlrobot_course.play.challenge import Score
from rlrobot_edu.experiments.statistics import Anova, Tukey
from rlrobot_edu.show.palette import LIGHT


def shuffled_f(groups: Mapping[str, np.ndarray], times: int = 2000) -> np.ndarray:
    """F of these groups after their numbers were dealt anew at random, array (times,).

    groups: numbers of each method, by its name. Source: Fisher's permutation test.
    """
    rng, sizes = np.random.default_rng(0), [len(group) for group in groups.values()]
    everything, ends = np.concatenate(list(groups.values())), np.cumsum(sizes)[:-1]
    return np.array(
        [Anova.of(np.split(rng.permutation(everything), ends)).f for _ in range(times)]
    )


def shuffled_finding(shuffled: np.ndarray, observed: float) -> str:
    """In how many of the shuffles chance alone makes as large a difference."""
    share = np.mean(shuffled >= observed)
    if share == 0:
        return f"None of {len(shuffled)} shuffles makes so large a difference"
    return f"Chance alone makes so large a difference in {share:.1%} of the shuffles"


def plot_shuffled(groups: Mapping[str, np.ndarray], *, times: int = 2000) -> Picture:
    """Histogram of `shuffled_f`, and the F that was observed as a line."""
    shuffled = shuffled_f(groups, times)
    observed = Anova.of(list(groups.values())).f
    names = " and ".join(groups)
    note = f"{names}: F, spread between / within, of {times} shuffled labels; last bar: all larger ones"
    finding = shuffled_finding(shuffled, observed)
    figure, ax = chart((7.2, 3.1), "", "", finding, None, note)
    last = max(float(np.quantile(shuffled, 0.99)), 1.5 * observed)
    bins = np.arange(0, 41) * observed / round(40 * observed / last)
    for part, colour in ((shuffled < observed, GREY), (shuffled >= observed, BLUE)):
        weights = np.full(part.sum(), 1 / times)
        ax.hist(shuffled[part].clip(max=bins[-1]), bins, weights=weights, color=colour)
    ax.axvline(observed, color=BLACK, linewidth=2)
    top = ax.get_ylim()[1]
    ax.text(observed, top, f"  ours: F = {observed:.1f}", weight="bold", va="top")
    share = np.mean(shuffled >= observed)
    told = f"  {share:.1%} of the shuffles: as large, or larger"
    ax.text(observed, 0.86 * top, told, color=BLUE, va="top")
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.set_xlim(0, bins[-1])
    figure.alt = (
        f"Histogram of F for shuffled labels, from 0 to {shuffled.max():.1f}, and a line at the observed F of "
        f"{observed:.1f}: {np.mean(shuffled >= observed):.1%} of the shuffles lie at or above it."
    )
    return figure


def draws_of_few(
    a: np.ndarray, b: np.ndarray, n: int, times: int = 2000
) -> tuple[np.ndarray, np.ndarray]:
    """n agents drawn from a and n from b, at random with repeats, two arrays (times, n)."""
    rng = np.random.default_rng(0)
    return rng.choice(a, (times, n)), rng.choice(b, (times, n))


def few_finding(found: Mapping[int, np.ndarray], names: tuple[str, str]) -> str:
    """How often the worse method is ahead, by the number of agents. found: differences of means by that number"""
    means = [differences.mean() for differences in found.values()]
    worse = names[1] if np.mean(means) > 0 else names[0]
    behind = [
        f"{np.mean(differences * np.sign(means[0]) < 0):.0%} of the draws of {n}"
        for n, differences in found.items()
    ]
    return f"{worse} is ahead in {', in '.join(behind)}"


def plot_few(
    a: np.ndarray, b: np.ndarray, sizes: Sequence[int], names: tuple[str, str]
) -> Picture:
    """Histograms of differences of means, by the numbers of agents in `sizes` that are drawn; names: of the methods."""
    draws = {n: draws_of_few(a, b, n) for n in sizes}
    found = {n: x.mean(axis=1) - y.mean(axis=1) for n, (x, y) in draws.items()}
    first, second = names
    note = (
        f"{first} less {second}: difference of the means in 2000 draws, reward a step"
    )
    figure, ax = chart((7.2, 3.7), "", "", few_finding(found, names), None, note)
    bins = np.linspace(
        min(map(np.min, found.values())), max(map(np.max, found.values())), 51
    )
    colours = [GREY, BLUE, GREEN, RED]
    for i, (n, differences) in enumerate(found.items()):
        colour = colours[i % len(colours)]
        share, _ = np.histogram(differences, bins)
        share = share / len(differences)
        ax.stairs(share, bins, fill=True, color=colour, alpha=0.35)
        ax.stairs(share, bins, color=colour, linewidth=1.8)
        # named at the right shoulder, where it has fallen to half its height
        k = np.flatnonzero(share >= share.max() / 2)[-1]
        ax.text(bins[k + 2], share[k], f"{n} agents each", color=colour, weight="bold")
    ax.axvline(0, color=BLACK, linewidth=1)
    top = ax.get_ylim()[1]
    for x, name, side in ((-0.1, second, "right"), (0.1, first, "left")):
        ax.text(x, top, f"{name} ahead", ha=side, va="bottom", color=LIGHT["faint"])
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    figure.alt = "Histograms of the difference of means. " + "; ".join(
        f"{n} agents a method: from {d.min():.1f} to {d.max():.1f}, below 0 in {np.mean(d < 0):.1%}"
        for n, d in found.items()
    )
    return figure


def two_intervals(
    groups: Mapping[str, np.ndarray], first: str, second: str
) -> dict[str, tuple[float, float]]:
    """The simultaneous 95 % interval of first less second by each of the two tests, low and high."""
    labels = list(groups)
    i, j = labels.index(first), labels.index(second)
    found = {}
    for test, alike in (("Tukey", True), ("Games and Howell", False)):
        outcome = stats.tukey_hsd(*groups.values(), equal_var=alike)
        ends = outcome.confidence_interval(0.95)
        found[test] = float(ends.low[i, j]), float(ends.high[i, j])
    return found


def plot_two_tests(groups: Mapping[str, np.ndarray]) -> Picture:
    """Each robot as a dot, and the difference of each pair with its interval by both tests. groups: arrays (n,)"""
    picture = Picture(figsize=(8.4, 3.7))
    left, right = picture.subplots(1, 2)
    rng = np.random.default_rng(0)
    for row, x in enumerate(groups.values()):
        beside = row + rng.uniform(-0.25, 0.25, len(x))
        left.plot(x, beside, ".", color=GREY, markersize=4)
        left.plot([x.mean()] * 2, [row - 0.35, row + 0.35], color=BLUE, linewidth=2)
    name_rows(left, list(groups))
    left.set_title("final average reward", weight="bold")
    left.spines["bottom"].set_visible(False)
    looks = {"Tukey": (RED, "s", -0.14), "Games and Howell": (BLUE, "o", 0.14)}
    names, apart, told = [], [], []
    for row, pair in enumerate(Tukey.of(groups).pairs):
        names.append(f"{pair.first} less\n{pair.second}")
        if pair.tests_disagree:
            apart.append(f"{pair.first} and {pair.second}")
        ends = two_intervals(groups, pair.first, pair.second)
        for test, (low, high) in ends.items():
            colour, marker, shift = looks[test]
            right.errorbar(
                pair.difference,
                row + shift,
                xerr=(high - low) / 2,
                fmt=marker,
                color=colour,
            )
            if row == len(groups) - 1:
                right.text(high, row + shift, f" {test}", color=colour, va="center")
        tukey, games_howell = (
            f"{low:.2f} to {high:.2f}" for low, high in ends.values()
        )
        told.append(
            f"{pair.first} less {pair.second}: {tukey} by Tukey, {games_howell} by Games and Howell"
        )
    name_rows(right, names)
    right.set_ylim(len(names) - 0.5, -0.5)
    right.axvline(0, color=BLACK, linewidth=1)
    right.set_title("difference, 95 % interval", weight="bold")
    right.margins(x=0.2)
    right.grid(axis="x")
    title = "Both tests say the same of every pair"
    if apart:
        title = f"The two tests disagree on {' and on '.join(apart)}"
    n = len(next(iter(groups.values())))
    note = f"reward a step; left, a dot: one of {n} robots, line: their mean; right, two tests of each pair"
    picture.headline(title, note)
    spreads = [f"{method} {x.std(ddof=1):.2f}" for method, x in groups.items()]
    picture.alt = (
        f"Left, the final average rewards of each method's robots; SDs: {', '.join(spreads)}. "
        f"Right, 95 % intervals of the differences. {'; '.join(told)}."
    )
    return picture


def step_p(before: Score, after: Score, n: int) -> float:
    """p of Welch's test from the means and half intervals (Student's t, 95 %) of n robots each."""
    t = stats.t.ppf(0.975, n - 1) / n**0.5  # half interval over SD
    numbers = (before.mean, before.half / t, n, after.mean, after.half / t, n)
    return float(stats.ttest_ind_from_stats(*numbers, equal_var=False).pvalue)
