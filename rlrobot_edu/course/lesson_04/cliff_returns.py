"""What walking at the cliff pays while one learns: over the episodes, and over the probability of exploring."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.learning.history import History
from rlrobot_edu.show.curves import mean_interval
from rlrobot_edu.show.palette import CURVES
from rlrobot_edu.show.picture import Picture

BEST = -13  # sum of the rewards of the shortest way


def first_returns(histories: Sequence[History], episodes: int) -> np.ndarray:
    """Sums of the rewards of each repetition's first episodes, array (repetitions, episodes).

    Raises ValueError if a repetition has fewer episodes.
    """
    fewest = min(len(history.returns) for history in histories)
    if fewest < episodes:
        raise ValueError(f"a repetition has {fewest} finished episodes, {episodes} are needed; learn for more steps")
    return np.array([history.returns[:episodes] for history in histories])


def plot_returns(
    groups: Mapping[str, Sequence[History]], title: str, *, episodes: int = 500, window: int = 10
) -> Picture:
    """Sum of the rewards of an episode while learning, mean of the repetitions with its 95 % interval.

    groups: names and the histories of repetitions of one method; title: what is found
    episodes: how many are drawn; window: so many episodes in a row make one point, which smooths the curve
    """
    figure, ax = _figure("episode", title)
    for (name, histories), (colour, dashes) in zip(groups.items(), CURVES, strict=False):
        blocks = first_returns(histories, episodes).reshape(len(histories), -1, window).mean(axis=2)
        mean, half = mean_interval(blocks)
        middle = window * (np.arange(len(mean)) + 0.5)
        ax.fill_between(middle, mean - half, mean + half, color=colour, alpha=0.2, linewidth=0)
        label = f"{name} ({len(histories)} repetitions)"
        ax.plot(middle, mean, color=colour, linestyle=dashes, linewidth=1.8, label=label)
        figure.alt += f" {name} ends at {mean[-1]:.0f}."
    ax.set_ylim(-110, 0)  # the first episodes lie far below and would flatten all that follows
    figure.legend(title="means, and their 95 % intervals", loc="outside lower center", ncols=2)
    return figure


def plot_over_epsilon(
    groups: Mapping[str, Mapping[float, Sequence[History]]], title: str, *, episodes: int = 100
) -> Picture:
    """Sum of the rewards of an episode after learning, over ε: mean of the repetitions with its 95 % interval.

    groups: names of methods, and for each ε above 0 the histories of its repetitions; title: what is found
    episodes: so many of the last episodes count
    """
    figure, ax = _figure("ε, probability of exploring (logarithmic)", title)
    for i, (name, runs) in enumerate(groups.items()):
        last = [np.array([[h.returns[-episodes:].mean()] for h in histories]) for histories in runs.values()]
        mean, half = np.array([mean_interval(returns) for returns in last])[:, :, 0].T
        colour, dashes = CURVES[i]
        label = f"{name} ({len(last[0])} repetitions each)"
        ax.errorbar(list(runs), mean, half, color=colour, linestyle=dashes, marker="os"[i % 2], capsize=3, label=label)
        told = ", ".join(f"{m:.0f} at ε = {epsilon:g}" for m, epsilon in zip(mean, runs, strict=True))
        figure.alt += f" {name}: {told}."
    ax.set_xscale("log")
    ax.set_xticks(list(runs), [f"{epsilon:g}" for epsilon in runs])
    ax.set_xticks([], minor=True)
    figure.legend(title="means, and their 95 % intervals", loc="outside lower center", ncols=2)
    return figure


def _figure(xlabel: str, title: str) -> tuple[Picture, Axes]:
    figure = Picture(figsize=(6.5, 4.2), layout="constrained")
    ax = figure.subplots()
    ax.axhline(BEST, color="black", linewidth=1, linestyle=":", label=f"the shortest way: −{-BEST}")
    ax.set(xlabel=xlabel, ylabel="sum of the rewards of an episode", title=title)
    ax.grid(alpha=0.3)
    figure.alt = f"Sum of the rewards of an episode at the cliff; the best possible is {BEST}."
    return figure, ax
