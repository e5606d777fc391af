"""How a method's result depends on the learning rate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_edu.course.lesson_06.hindsight import LOOK, NAMES
from rlrobot_edu.show.curves import mean_interval
from rlrobot_edu.show.picture import Picture


def plot_over_alpha(alphas: Sequence[float], found: Mapping[str, np.ndarray], title: str) -> Picture:
    """Average reward over the learning rate, one curve for each kind of trace, with 95 % intervals.

    alphas: list (k,); found: arrays (k, repetitions) by the name of the trace, as in `true_online.TRACES`
    """
    figure = Picture(figsize=(6.5, 4.2), layout="constrained")
    ax = figure.subplots()
    ends = []
    aside = 0.008 * np.ptp(alphas)  # so that the intervals of one α do not hide each other
    for i, (trace, rewards) in enumerate(found.items()):
        mean, half = mean_interval(np.asarray(rewards).T)
        ax.errorbar(np.asarray(alphas) + (i - 1) * aside, mean, half, **LOOK[trace], capsize=3, label=NAMES[trace])
        ends.append(f"{NAMES[trace]} {mean[0]:.1f} to {mean[-1]:.1f}")
    repetitions = np.shape(next(iter(found.values())))[1]
    ax.set(xlabel="learning rate α", ylabel="average reward per step", title=title)
    low, high = ax.get_ylim()
    ax.set_ylim(min(0, low), 1.1 * high)
    ax.grid(alpha=0.3)
    legend = f"means of {repetitions} repetitions, and their 95 % intervals"
    figure.legend(title=legend, loc="outside lower center", ncols=2)
    figure.alt = f"Average reward for α from {alphas[0]:g} to {alphas[-1]:g}: {'; '.join(ends)}."
    return figure
