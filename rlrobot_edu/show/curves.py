"""Learning curves: the average reward over the steps, of one process or of many repetitions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from scipy.special import stdtrit

from rlrobot_edu.show.palette import CURVES
from rlrobot_edu.show.picture import Picture

if TYPE_CHECKING:
    from rlrobot_edu.learning.history import History


def mean_interval(curves: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean of n repetitions and half the width of its 95 % interval (Student's t).

    curves: array (n, steps), n at least 2. Returns two arrays (steps,).
    """
    n = len(curves)
    return curves.mean(axis=0), stdtrit(n - 1, 0.975) * curves.std(axis=0, ddof=1) / np.sqrt(n)


def plot_learning(
    history: History | Sequence[History],
    *more: History | Sequence[History],
    labels: Sequence[str] | None = None,
    ax: Axes | None = None,
    title: str | None = None,
) -> Picture | Axes:
    """Learning curves, average reward over steps. Returns the figure, or `ax` where one was given.

    history, more: a History gives one curve; a list of them is averaged, with its 95 % interval as a band
    labels: one name a curve; by default the methods' names
    ax: axes to draw on; None makes a figure of its own
    Raises ValueError for an empty list, for repetitions of different lengths, or for too few or too many labels.
    """
    groups = [[h] if hasattr(h, "average_reward") else list(h) for h in (history, *more)]
    if not all(groups):
        raise ValueError("plot_learning needs at least one History a curve; one of the lists is empty")
    if labels is not None and len(labels) != len(groups):
        raise ValueError(f"plot_learning got {len(labels)} labels for {len(groups)} curves")
    names = labels if labels is not None else [group[0].method for group in groups]
    figure = None
    if ax is None:
        figure = Picture(figsize=(6.5, 4.2), layout="constrained")
        ax = figure.subplots()
        ends = (
            f"{name} ends at {np.mean([h.average_reward[-1] for h in g]):.2f}"
            for g, name in zip(groups, names, strict=True)
        )
        figure.alt = (
            f"Learning curves, average reward over {len(groups[0][0].average_reward)} steps. {'; '.join(ends)}."
        )
    for i, (group, name) in enumerate(zip(groups, names, strict=True)):
        _draw_curve(ax, group, name, *CURVES[i % len(CURVES)])
    seconds = getattr(groups[0][0], "step_time", None)
    ax.set(xlabel="step" if seconds is None else f"step ({seconds:g} s each)", ylabel="average reward per step")
    ax.set_title(title or "How the average reward develops")
    ax.grid(alpha=0.3)
    ax.margins(x=0)
    note = "means, and bands of their 95 % intervals" if max(map(len, groups)) > 1 else None
    if figure is None:
        ax.legend(title=note)
    else:  # below the axes, where it hides no curve
        figure.legend(title=note, loc="outside lower center", ncols=2 if max(map(len, names)) <= 20 else 1)
    return figure or ax


def _draw_curve(ax: Axes, group: list[History], name: str, colour: str, dashes: str | tuple) -> None:
    """One curve with, for repetitions, its band."""
    if len({len(history.average_reward) for history in group}) > 1:
        raise ValueError(f"the repetitions of {name} have different numbers of steps; average curves of one length")
    curves = np.array([history.average_reward for history in group])
    steps = np.arange(1, curves.shape[1] + 1)
    mean = curves.mean(axis=0)
    if len(group) > 1:
        mean, half = mean_interval(curves)
        ax.fill_between(steps, mean - half, mean + half, color=colour, alpha=0.2, linewidth=0)
        name += f" ({len(group)} repetitions)"
    ax.plot(steps, mean, color=colour, linestyle=dashes, linewidth=1.8, label=name)
