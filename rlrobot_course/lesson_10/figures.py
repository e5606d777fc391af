"""The figure of lesson 10: what the learner's own robots earn, with two methods."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.plots import BLUE, VERMILION, Picture, chart, plain


def plot_earnings(groups: Mapping[str, Sequence[Sequence[float]]], title: str) -> Picture:
    """Average reward up to each step, one thin line a robot and a thick one for the mean of each of two methods.

    groups: of each method, by its name, the rewards of its robots, lists of equal length
    """
    figure, ax = chart((7, 3.6), "step", "average reward up to here", title)
    told = []
    for (name, rewards), colour, line in zip(groups.items(), (BLUE, VERMILION), ("-", "--"), strict=False):
        steps = np.arange(1, len(rewards[0]) + 1)
        curves = np.cumsum(rewards, axis=1) / steps
        ax.plot(steps, curves.T, line, color=colour, alpha=0.3, linewidth=1)
        ax.plot(steps, curves.mean(axis=0), line, color=colour, linewidth=2.5, label=plain(name))
        told.append(f"{name}: {len(curves)} robots, in the end {curves[:, -1].mean():.2f}")
    settled = [y for line in ax.lines for y in line.get_ydata()[len(steps) // 8 :]]  # the first steps swing far
    margin = 0.05 * (max(settled) - min(settled))
    ax.set(xlim=(0, len(steps)), ylim=(min(settled) - margin, max(settled) + margin))
    ax.legend(loc="lower right")
    figure.alt = f"Average reward over {len(steps)} steps. " + "; ".join(told) + "."
    return figure
