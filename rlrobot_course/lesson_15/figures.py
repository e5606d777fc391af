"""The figures of lesson 15: how large a difference chance makes, where labels mean nothing and where agents are few."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.ticker import PercentFormatter

from rlrobot_course.plots import BLUE, GREEN, ORANGE, VERMILION, Picture, chart, plain
from rlrobot_edu.experiments.statistics import Anova


def shuffled_f(groups: Mapping[str, np.ndarray], times: int = 2000, seed: int = 0) -> np.ndarray:
    """F of these groups after their numbers were dealt anew at random, array (times,).

    groups: numbers of each method, by its name. Source: Fisher's permutation test.
    """
    rng, sizes = np.random.default_rng(seed), [len(group) for group in groups.values()]
    everything, ends = np.concatenate(list(groups.values())), np.cumsum(sizes)[:-1]
    return np.array([Anova.of(np.split(rng.permutation(everything), ends)).f for _ in range(times)])


def plot_shuffled(groups: Mapping[str, np.ndarray], title: str, *, times: int = 2000, seed: int = 0) -> Picture:
    """Histogram of `shuffled_f`, and the F that was observed as a line."""
    shuffled, observed = shuffled_f(groups, times, seed), Anova.of(list(groups.values())).f
    x = "F, spread between the methods / spread within them"
    figure, ax = chart((6.5, 3.2), x, "share of the shuffles", title, grid=None)
    bins = np.linspace(0, max(shuffled.max(), observed) * 1.05, 60)
    ax.hist(shuffled, bins, weights=np.full(times, 1 / times), color=BLUE, label=f"labels shuffled, {times} times")
    ax.axvline(observed, color=VERMILION, linestyle="--", linewidth=2, label=f"as found: F = {observed:.1f}")
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.legend()
    figure.alt = (
        f"Histogram of F for shuffled labels, from 0 to {shuffled.max():.1f}, and a line at the observed F of "
        f"{observed:.1f}: {np.mean(shuffled >= observed):.1%} of the shuffles lie at or above it."
    )
    return figure


def differences_of_few(a: np.ndarray, b: np.ndarray, n: int, times: int = 2000, seed: int = 0) -> np.ndarray:
    """Difference of the means of n agents drawn from a and n from b, at random with repeats, array (times,)."""
    rng = np.random.default_rng(seed)
    return rng.choice(a, (times, n)).mean(axis=1) - rng.choice(b, (times, n)).mean(axis=1)


def plot_few(a: np.ndarray, b: np.ndarray, sizes: Sequence[int], names: tuple[str, str], title: str) -> Picture:
    """Histograms of `differences_of_few`, one for each number of agents in `sizes`; names: of the two methods."""
    found = {n: differences_of_few(a, b, n) for n in sizes}
    first, second = map(plain, names)
    x = f"{first} − {second}, difference of the means (reward a step)"
    figure, ax = chart((6.5, 3.5), x, "share of 2000 draws", title, grid=None)
    bins = np.linspace(min(map(np.min, found.values())), max(map(np.max, found.values())), 51)
    looks = [(ORANGE, "//"), (BLUE, ""), (GREEN, "\\\\"), (VERMILION, "..")]
    for i, (n, differences) in enumerate(found.items()):
        colour, hatch = looks[i % len(looks)]
        share = np.full(len(differences), 1 / len(differences))
        ax.hist(differences, bins, weights=share, alpha=0.6, color=colour, hatch=hatch, label=f"{n} agents a method")
    ax.axvline(0, color="black", linewidth=1)
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.legend()
    figure.alt = "Histograms of the difference of means. " + "; ".join(
        f"{n} agents a method: from {d.min():.1f} to {d.max():.1f}, below 0 in {np.mean(d < 0):.1%}"
        for n, d in found.items()
    )
    return figure
