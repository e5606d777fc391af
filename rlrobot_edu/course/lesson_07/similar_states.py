"""The states that have a say in one state, as poses of the worked example's robot in its four cells."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.course.bias_explorer.bias_marks import HERE, Mark, marks_of, state_text
from rlrobot_edu.show.palette import BLACK, GREY
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import load_task


def plot_similar_states(s: int) -> Picture:
    """State `s` of worked_example and, beside it, each state that shares all inputs with it but one.

    An arrow stands in the cell (X, Y) and points where the robot looks, theta. A thick bar before its tip: something
    is ahead (d = 1); a dotted one: the way is free. Raises ValueError if there is no such state.
    """
    task = load_task("worked_example")
    marks = marks_of(task)
    others = [(int(k), name) for name, states in task.states.siblings(s).items() for k in states if k != s]
    figure = Picture(figsize=(9.5, 2.35), layout="constrained")
    maps = figure.subplots(1, 1 + len(others))
    _draw_pose(maps[0], task.states.decode(s), HERE)
    maps[0].set_title(f"state {s}\n{state_text(task, s)}", fontsize=10, weight="bold")
    for ax, (k, name) in zip(maps[1:], others, strict=True):
        _draw_pose(ax, task.states.decode(k), marks[name])
        ax.set_title(f"{marks[name].sign} other {name}: {k}\n{state_text(task, k)}", fontsize=10)
    figure.suptitle(f"{len(others)} states share all inputs but one with state {s}", fontsize=11)
    words = "; ".join(f"other {name}: state {k} {state_text(task, k)}" for k, name in others)
    figure.alt = f"Small maps of the four cells with the robot. State {s} {state_text(task, s)}; {words}."
    return figure


def _draw_pose(ax: Axes, bins: dict, mark: Mark) -> None:
    """Four cells, the robot as an arrow in one of them, and before it a bar: thick if the way is blocked."""
    x, y, theta, blocked = (bins[name].reading for name in ("X", "Y", "theta", "d"))
    for column in (0, 1):
        for row in (0, 1):
            here = (column, row) == (x, y)
            ax.add_patch(Rectangle((column - 0.5, row - 0.5), 1, 1, facecolor=mark.colour if here else "white",
                                   edgecolor=GREY, linewidth=0.8))  # fmt: skip
    along = np.array([np.cos(np.radians(theta)), np.sin(np.radians(theta))])
    across, middle = np.array([-along[1], along[0]]), np.array([x, y])
    ax.annotate("", middle + 0.32 * along, middle - 0.32 * along,
                arrowprops={"arrowstyle": "-|>", "color": BLACK, "linewidth": 2})  # fmt: skip
    bar = np.array([middle + 0.42 * along + side * 0.35 * across for side in (-1, 1)])
    ax.plot(*bar.T, color=BLACK, linewidth=4 if blocked else 1.2, linestyle="-" if blocked else ":")
    ax.set(xlim=(-0.6, 1.6), ylim=(-0.6, 1.6), aspect="equal")
    ax.set_axis_off()
