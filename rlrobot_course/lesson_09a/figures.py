"""The figure of lesson 09a: how long robots are caught."""

from collections.abc import Sequence

import numpy as np
from matplotlib.ticker import LogLocator

from rlrobot_course.plots import BLUE, VERMILION, Picture, chart, name_rows
from rlrobot_edu.learning.history import History


def longest_dry_spell(rewards: np.ndarray) -> int:
    """Largest number of steps in a row without a positive reward; rewards: array (n,)."""
    paid = np.flatnonzero(np.concatenate([[1.0], rewards, [1.0]]) > 0)  # a paid step before and after, to count between
    return int(np.diff(paid).max() - 1)


def plot_dry_spells(groups: dict[str, Sequence[History]], title: str) -> Picture:
    """One dot a robot: its longest time without a positive reward. groups: histories by the name of their setting."""
    size = (7, 1.3 + 0.55 * len(groups))
    figure, ax = chart(size, "longest time without a positive reward (steps)", "", title, grid="x")
    spells = {name: sorted(longest_dry_spell(h.rewards) for h in group) for name, group in groups.items()}
    for row, lengths in enumerate(spells.values()):
        ax.plot(lengths, row + np.linspace(-0.2, 0.2, len(lengths)), "o", color=BLUE, alpha=0.7)
        ax.plot(lengths[(len(lengths) - 1) // 2], row, "|", color=VERMILION, markersize=22, markeredgewidth=2)
    name_rows(ax, list(spells))
    ax.set_xscale("log")
    ax.xaxis.set_major_locator(LogLocator(subs=(1, 3)))
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter("")
    ax.plot([], [], "|", color=VERMILION, markersize=12, markeredgewidth=2, label="the middle robot")
    figure.legend(loc="outside lower center")  # no dot behind it
    figure.alt = "Dots, one a robot: longest time without a positive reward. " + "; ".join(
        f"{name}: {len(lengths)} robots, the middle one {lengths[(len(lengths) - 1) // 2]}, longest {lengths[-1]}"
        for name, lengths in spells.items()
    )
    return figure
