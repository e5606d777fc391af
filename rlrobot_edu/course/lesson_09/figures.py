"""The figure of lesson 09: how large a difference does chance make where the labels of the methods mean nothing?"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.ticker import PercentFormatter

from rlrobot_edu.experiments.statistics import Anova
from rlrobot_edu.show.palette import BLUE, VERMILION
from rlrobot_edu.show.picture import Picture, plain


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
    figure = Picture(figsize=(6.5, 3.2))
    ax = figure.subplots()
    bins = np.linspace(0, max(shuffled.max(), observed) * 1.05, 60)
    ax.hist(shuffled, bins, weights=np.full(times, 1 / times), color=BLUE, label=f"labels shuffled, {times} times")
    ax.axvline(observed, color=VERMILION, linestyle="--", linewidth=2, label=f"as found: F = {observed:.1f}")
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.set(
        xlabel="F, spread between the methods / spread within them", ylabel="share of the shuffles", title=plain(title)
    )
    ax.legend()
    figure.alt = (
        f"Histogram of F for shuffled labels, from 0 to {shuffled.max():.1f}, and a line at the observed F of "
        f"{observed:.1f}: {np.mean(shuffled >= observed):.1%} of the shuffles lie at or above it."
    )
    return figure
