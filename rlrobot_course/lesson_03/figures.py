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

LAST = 1000  # steps, whose mean is told


def plot_towards(
    target: float, alpha: float, steps: int = 8, labelled: int = 5
) -> Picture:
    """A value that begins at 0 and moves `steps` times the share `alpha` of the way to a target above 0.

    labelled: so many of the first gaps carry their numbers
    """
    figure, ax = chart(
        (6.5, 3.6),
        "how often the step was taken",
        "Q(s, a)",
        "Each step closes a part of the gap",
    )
    values = target * (1 - (1 - alpha) ** np.arange(steps + 1))
    ax.axhline(target, color=BLACK, linewidth=1, linestyle=":")
    ax.text(0, target, f"the target: {target:g}", va="bottom")
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


def plot_one_value(
    task: Task,
    s: int,
    a: int,
    settings: Mapping[str, Mapping[str, Any]],
    title: str,
    *,
    steps: int = 6000,
    true: float | None = None,
) -> Picture:
    """Q(s, a) after each step of Q-learning, one curve a setting, and its mean and range in the last 1000 steps.

    task: what is learned; s, a: the entry; settings: label of a curve -> parameters of an `Agent`; true: the value that
    the entry should come to, drawn as a line
    The actions are drawn at random with one seed, so every curve learns from the same steps.
    """
    figure, ax = chart((6.5, 4.4), "step", f"Q({s}, {a})  (discounted reward)", title)
    curves = {}
    for label, setting in settings.items():
        agent = Agent(task, "Q+RANDOM", seed=0, **setting)
        values = np.array(
            [agent.q[s, a] for _ in walk(agent, make_env(task, seed=0), steps)]
        )
        last = values[-LAST:]
        curves[
            f"{label}: {last.min():.0f} to {last.max():.0f}, mean {last.mean():.1f}"
        ] = values
    draw_curves(ax, curves)
    figure.alt = f"Curves of Q({s}, {a}) over {steps} steps. {'; '.join(curves)}."
    if true is not None:
        ax.axhline(
            true,
            color=BLACK,
            linewidth=1,
            linestyle=":",
            label=f"the true value, {true:.1f}",
        )
        figure.alt += f" A line at {true:.1f}, the true value."
    figure.legend(
        loc="outside lower center", title=f"range and mean of the last {LAST} steps"
    )
    return figure
