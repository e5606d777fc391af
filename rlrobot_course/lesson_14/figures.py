"""The figure of lesson 14: how sure an estimate is."""

from collections.abc import Sequence

import numpy as np

from rlrobot_course.plots import BLUE, GREY, VERMILION, Picture, chart


def plot_estimates(happened: np.ndarray, sizes: Sequence[int], estimates: int, seed: int = 0) -> Picture:
    """How far estimates of a probability scatter, for several numbers of samples.

    happened: array (n,) of bool, whether it happened in each of many samples; sizes: how many are drawn of them for one
    estimate; estimates: how many estimates of each size
    """
    rng, p = np.random.default_rng(seed), happened.mean()
    title = "The same probability, estimated again and again"
    figure, ax = chart((7.6, 3.9), "number of samples", "estimated probability", title)
    n = np.geomspace(min(sizes) * 0.8, max(sizes) * 1.25, 100)
    width = 2 * np.sqrt(p * (1 - p) / n)
    ax.fill_between(n, (p - width).clip(0), (p + width).clip(max=1), color=BLUE, alpha=0.15, linewidth=0)
    ax.plot([], [], color=BLUE, alpha=0.3, linewidth=8, label="within two standard errors")
    ax.axhline(p, color=GREY, linestyle=":", label=f"in all {len(happened):,} samples: {p:.2f}")
    shares = []
    for size in sizes:
        found = happened[rng.integers(len(happened), size=(estimates, size))].mean(axis=1)
        beside = size * np.exp(rng.uniform(-0.09, 0.09, estimates))
        ax.plot(beside, found, "o", color=VERMILION, alpha=0.5, markersize=4)
        shares.append(f"{size}: {found.min():.2f} to {found.max():.2f}")
    ax.plot([], [], "o", color=VERMILION, markersize=4, label="one estimate")
    ax.set_xscale("log")
    ax.set_xticks(sizes, [f"{size:,}" for size in sizes])
    ax.minorticks_off()
    ax.set_ylim(-0.03, 1.03)
    figure.legend(loc="outside lower center", ncols=3)
    figure.alt = f"{estimates} estimates each of a probability of {p:.2f}, by number of samples: {'; '.join(shares)}."
    return figure
