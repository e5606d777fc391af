"""What a learner's own functions earn on a robot, as curves, compared with the library's."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import Picture, chart, draw_curves, legend_below
from rlrobot_edu.experiments.statistics import mean_band

SKIPPED = 0.03  # of the steps: means of so few rewards jump about, and would decide how high the picture is


def plot_runs(rewards: Mapping[str, Sequence[float]], title: str) -> Picture:
    """The average reward of all steps so far, one curve a run.

    rewards: label of a curve -> the reward of each step
    """
    figure, ax = chart((6.5, 3.8), "step", "average reward per step", title)
    means = {
        label: np.cumsum(run) / np.arange(1, len(run) + 1)
        for label, run in rewards.items()
    }
    draw_curves(ax, means, width=1.8)
    seen = [mean[int(SKIPPED * len(mean)) :] for mean in means.values()]
    low, high = min(part.min() for part in seen), max(part.max() for part in seen)
    ax.set_ylim(low - 0.08 * (high - low) - 0.1, high + 0.08 * (high - low) + 0.1)
    legend_below(figure, len(rewards))
    told = "; ".join(f"{label} ends at {mean[-1]:.2f}" for label, mean in means.items())
    figure.alt = f"Average reward over {max(map(len, means.values()))} steps. {told}."
    return figure


def mean_and_half(values: Sequence[float] | np.ndarray) -> tuple[float, float]:
    """The mean of some values, array (n,), and half of its 95 % interval (Student's t)."""
    low, high = mean_band(np.array(values))
    return float(low + high) / 2, float(high - low) / 2


def error_bars(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Means of n samples, array (points,), and how far their 95 % intervals reach down and up, array (2, points)."""
    low, high = mean_band(samples)
    return (low + high) / 2, np.array([high - low] * 2) / 2
