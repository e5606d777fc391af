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
)
from rlrobot_course.play.challenge import Score
from rlrobot_edu.show.palette import LIGHT


def distance(a: np.ndarray, b: np.ndarray) -> float:
    """How far apart the means of two groups are; arrays (n,)."""
    return abs(float(a.mean() - b.mean()))


def shuffled_distances(a: np.ndarray, b: np.ndarray, times: int = 2000) -> np.ndarray:
    """`distance` after the numbers of both groups were dealt anew at random, array (times,).

    Source: Fisher's permutation test.
    """
    rng = np.random.default_rng(1)
    everything = np.concatenate([a, b])
    found = []
    for _ in range(times):
        dealt = rng.permutation(everything)
        found.append(distance(dealt[: len(a)], dealt[len(a) :]))
    return np.array(found)


def shuffled_finding(shuffled: np.ndarray, observed: float) -> str:
    """In how many of the shuffles chance alone makes as large a difference."""
    share = np.mean(shuffled >= observed)
    if share == 0:
        return f"None of {len(shuffled)} shuffles makes so large a difference"
    return f"Chance alone makes so large a difference in {share:.1%} of the shuffles"


def plot_shuffled(groups: Mapping[str, np.ndarray], *, times: int = 2000) -> Picture:
    """Histogram of `shuffled_distances` of two groups, and the distance that was observed as a line."""
    a, b = groups.values()
    shuffled, observed = shuffled_distances(a, b, times), distance(a, b)
    names = " and ".join(groups)
    note = f"{names}: how far apart the means are after a shuffle (reward a step); {times} shuffles"
    finding = shuffled_finding(shuffled, observed)
    figure, ax = chart((7.2, 3.1), "", "", finding, None, note)
    width = observed / max(1, round(20 * observed / shuffled.max()))
    bins = np.arange(0, max(shuffled.max(), observed) + width, width)
    for part, colour in ((shuffled < observed, GREY), (shuffled >= observed, BLUE)):
        weights = np.full(part.sum(), 1 / times)
        ax.hist(shuffled[part], bins, weights=weights, color=colour)
    ax.axvline(observed, color=BLACK, linewidth=2)
    top = ax.get_ylim()[1]
    ax.text(observed, top, f"  ours: {observed:.2f}", weight="bold", va="top")
    share = np.mean(shuffled >= observed)
    told = f"  {share:.1%} of the shuffles: as far apart, or further"
    ax.text(observed, 0.86 * top, told, color=BLUE, va="top")
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.set_xlim(0, bins[-1])
    figure.alt = (
        f"Histogram of the distance of two means for shuffled labels, from 0 to {shuffled.max():.2f}, and a line at "
        f"the observed {observed:.2f}: {share:.1%} of the shuffles lie at or above it."
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


def step_p(before: Score, after: Score, n: int) -> float:
    """p of Welch's test from the means and half intervals (Student's t, 95 %) of n robots each."""
    t = stats.t.ppf(0.975, n - 1) / n**0.5  # half interval over SD
    numbers = (before.mean, before.half / t, n, after.mean, after.half / t, n)
    return float(stats.ttest_ind_from_stats(*numbers, equal_var=False).pvalue)
