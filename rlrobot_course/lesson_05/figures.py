"""The figure of lesson 05: which states have a say in one state."""

from itertools import zip_longest

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    GREY,
    Picture,
)
from rlrobot_edu import load_task
from rlrobot_edu.task.variables import Bin
from rlrobot_edu.widgets.bias_explorer.marks import marks_of
from rlrobot_edu.widgets.bias_explorer.words import (
    name_text,
    state_words,
    value_words,
)


def plot_similar_states(s: int) -> Picture:
    """The sets of state `s` of worked_example, one a row: the states that share all inputs with it but one.

    `s` itself is in each row. The arrow is the robot: it stands in the cell (X, Y) and points where the robot looks, θ.
    A thick bar before its tip: something is ahead (d = 1); a dotted one: the way is free. Raises ValueError if there
    is no such state.
    """
    task = load_task("worked_example")
    sets = task.states.siblings(s)
    similar = {int(k) for states in sets.values() for k in states} - {s}
    figure = Picture(figsize=(5.2, 6.5))
    figure.headline(
        f"Change one input alone, and you get {len(similar)} similar states",
        f"row: a set, in bold: state {s} ({state_words(task, s)}), which is in each",
    )
    maps = figure.subplots(len(sets), 3)
    for row, (name, states), mark in zip(
        maps, sets.items(), marks_of(task).values(), strict=True
    ):
        for ax, k in zip_longest(row, map(int, states)):
            ax.set_axis_off()
            if k is not None:
                _draw_pose(ax, task.states.decode(k), mark.colour)
                value = (
                    f"{name_text(name)} = {value_words(task.states.decode(k)[name])}"
                )
                ax.set_title(
                    f"{mark.sign} {value}: state {k}",
                    fontsize=10,
                    weight="bold" if k == s else "normal",
                )
    words = "; ".join(
        f"{name_text(name)}: {', '.join(map(str, states))}"
        for name, states in sets.items()
    )
    figure.alt = f"Small maps of the four cells with the robot, a row for each set of state {s}. {words}."
    return figure


def _draw_pose(ax: Axes, bins: dict[str, Bin], colour: str) -> None:
    """Four cells, the robot as an arrow in one of them, and before it a bar: thick if the way is blocked."""
    x, y, theta, blocked = (bins[name].reading for name in ("X", "Y", "theta", "d"))
    for column in (0, 1):
        for row in (0, 1):
            here = (column, row) == (x, y)
            ax.add_patch(Rectangle((column - 0.5, row - 0.5), 1, 1, facecolor=colour if here else "white",
                                   edgecolor=GREY, linewidth=0.8))  # fmt: skip
    along = np.array([np.cos(np.radians(theta)), np.sin(np.radians(theta))])
    across, middle = np.array([-along[1], along[0]]), np.array([x, y])
    ax.annotate("", middle + 0.32 * along, middle - 0.32 * along,
                arrowprops={"arrowstyle": "-|>", "color": "white", "linewidth": 2})  # fmt: skip
    bar = np.array([middle + 0.42 * along + side * 0.35 * across for side in (-1, 1)])
    ax.plot(
        *bar.T,
        color=BLACK,
        linewidth=4 if blocked else 1.2,
        linestyle="-" if blocked else ":",
    )
    ax.set(xlim=(-0.6, 1.6), ylim=(-0.6, 1.6), aspect="equal")
