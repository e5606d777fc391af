"""The figures of lesson 03: one entry of the Q table moves towards its target, and develops under several settings."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    ORANGE,
    Picture,
    chart,
    draw_arrow,
    draw_curves,
)
from rlrobot_edu import Agent, Task, make_env
from rlrobot_edu import steps as walk
from rlrobot_edu.show.ends import End, name_ends

LAST = 1000  # steps, whose mean is written


def plot_towards(
    target: float, alpha: float, steps: int = 8, labelled: int = 5
) -> Picture:
    """A value that begins at 0 and moves `steps` times the share `alpha` of the way to a target above 0.

    labelled: so many of the first gaps carry their numbers
    """
    figure, ax = chart(
        (6.5, 3.9),
        "how often the step was taken",
        "",
        f"Each step closes {100 * alpha:.0f} % of the gap to the target",
        grid="y",
        note="blue: Q(s, a); orange: the step, α · δ; dotted: the gap δ",
    )
    values = target * (1 - (1 - alpha) ** np.arange(steps + 1))
    ax.axhline(target, color=BLACK, linewidth=1, linestyle=":")
    ax.text(-0.3, target, f"target: {target:g}", va="bottom")
    for i, (before, after) in enumerate(pairwise(values)):
        ax.plot(
            [i + 0.5] * 2, [before, target], color=BLACK, linewidth=1, linestyle=":"
        )
        draw_arrow(ax, (i + 0.5, before), (i + 0.5, after), ORANGE, 3)
        if i < labelled:
            ax.text(
                i + 0.57,
                (after + target) / 2,
                f"δ = {target - before:.3g}",
                va="center",
            )
    ax.step(np.arange(steps + 1), values, where="mid", color=BLUE, linewidth=2)
    for i, value in enumerate(values[1 : labelled + 1], 1):
        ax.text(i, value - 0.15, f"{value:.2f}", va="top", ha="center", color=BLUE)
    ax.set(ylim=(-0.4, 1.1 * target), xlim=(-0.3, steps + 0.5))
    told = ", ".join(f"{value:.2f}" for value in values[1 : labelled + 1])
    figure.alt = (
        f"A value rises in steps towards a target of {target:g}: {told}, "
        "and each step is smaller than the last."
    )
    return figure


def plot_run_back(values: np.ndarray) -> Picture:
    """Bars of what the cells of a corridor are worth; the reward lies behind the last. values: array (cells,)"""
    known = int(np.count_nonzero(values))
    figure, ax = chart(
        (6.5, 3.4),
        "cell",
        "",
        f"{known} of {len(values)} cells know of the reward",
        grid="y",
        note=f"Q of going on in each cell, after {known} drives",
    )
    ax.bar(np.arange(len(values)), values, color=BLUE)
    for s, value in enumerate(values):
        if value:
            ax.text(s, value, f"{value:.1f}", ha="center", va="bottom")
    ax.set(xticks=range(len(values)), ylim=(0, 10.5))
    figure.alt = (
        f"Bars of {len(values)} cells; only the last {known} have a value: "
        f"{', '.join(f'{value:.1f}' for value in values[-known:])}."
    )
    return figure


def plot_one_value(
    task: Task,
    s: int,
    a: int,
    settings: Mapping[str, Mapping[str, Any]],
    *,
    steps: int = 6000,
    true: float | None = None,
) -> Picture:
    """Q(s, a) after each step of Q-learning, one curve a setting, and its mean in the last 1000 steps.

    task: what is learned; s, a: the entry; settings: label of a curve -> parameters of an `Agent`; true: the value that
    the entry should come to, drawn as a line
    The actions are drawn at random with one seed, so every curve learns from the same steps.
    """
    curves = {}
    for label, setting in settings.items():
        agent = Agent(task, "Q+RANDOM", seed=0, **setting)
        walked = walk(agent, make_env(task, seed=0), steps)
        curves[label] = np.array([agent.q[s, a] for _ in walked])
    lasts = {label: values[-LAST:] for label, values in curves.items()}
    note = f"Q({s}, {a}), a discounted reward, learned from the same steps; number: mean of the last {LAST}"
    figure, ax = chart(
        (6.5, 4.2), "step", "", who_rests(lasts, true), grid="y", note=note
    )
    draw_curves(ax, curves, width=1.8)
    ends, told = [], []
    for (label, last), line in zip(lasts.items(), ax.lines, strict=True):
        name = f"{label}\n{last.mean():.1f}"
        ends.append(End(float(last.mean()), name, str(line.get_color())))
        told.append(
            f"{label}: {last.min():.0f} to {last.max():.0f}, mean {last.mean():.1f}"
        )
    figure.alt = f"Curves of Q({s}, {a}) over {steps} steps. {'; '.join(told)}."
    if true is not None:
        ax.axhline(true, color=BLACK, linewidth=1, linestyle=":")
        ends.append(End(true, f"true value\n{true:.1f}", BLACK))
        figure.alt += f" A line at {true:.1f}, the true value."
    name_ends(ax, ends)
    return figure


def who_rests(lasts: Mapping[str, np.ndarray], true: float | None) -> str:
    """Which curve leaps most at its end and which least, and how far that one is from the true value, as a sentence.

    lasts: label of a curve -> its last values
    """
    leaps = {label: np.ptp(last) for label, last in lasts.items()}
    wildest = max(leaps, key=leaps.__getitem__)
    calmest = min(leaps, key=leaps.__getitem__)
    low, high = lasts[wildest].min(), lasts[wildest].max()
    text = f"With {wildest} Q leaps between {low:.0f} and {high:.0f}; with {calmest} it is smooth"
    if true is None:
        return text
    gap = lasts[calmest].mean() - true
    side = "below" if gap < 0 else "above"
    return f"{text}, {abs(gap):.0f} {side} the true value"
