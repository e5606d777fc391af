"""The figure of lesson 03a: how one entry of the Q table develops, under several settings but over the same steps."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from rlrobot_course.plots import BLACK, Picture, chart, draw_curves
from rlrobot_edu import Agent, Task, make_env
from rlrobot_edu import steps as walk


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
    """Q(s, a) after each step of Q-learning, one curve a setting.

    task: what is learned; s, a: the entry; settings: label of a curve -> parameters of an `Agent`; true: the value that
    the entry should come to, drawn as a line
    The actions are drawn at random with one seed, so every curve learns from the same steps.
    """
    figure, ax = chart((6.5, 3.8), "step", f"Q({s}, {a})  (discounted reward)", title)
    curves, ends = {}, []
    for label, setting in settings.items():
        agent = Agent(task, "Q+RANDOM", seed=0, **setting)
        curves[label] = values = np.array([agent.q[s, a] for _ in walk(agent, make_env(task, seed=0), steps)])
        ends.append(f"{label}: {values[-1]:.1f} at the end, {values[steps // 2 :].std():.1f} up and down")
    draw_curves(ax, curves)
    if true is not None:
        ax.axhline(true, color=BLACK, linewidth=1, linestyle=":", label=f"{true:g} (lesson 02)")
        ends.append(f"a line at {true:g}, the value of lesson 02")
    figure.legend(loc="outside lower center", ncols=len(ax.lines))
    figure.alt = f"Curves of Q({s}, {a}) over {steps} steps. {'; '.join(ends)}."
    return figure
