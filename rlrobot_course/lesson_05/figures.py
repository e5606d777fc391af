"""The figures of lesson 05: which states have a say in one state, and what they say."""

from collections.abc import Mapping, Sequence
from itertools import zip_longest

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    Picture,
)
from rlrobot_edu import load_task
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.task.variables import Bin
from rlrobot_edu.widgets.bias_explorer.marks import marks_of
from rlrobot_edu.widgets.bias_explorer.words import (
    amount,
    name_text,
    state_words,
    value_text,
    value_words,
)
from rlrobot_edu.widgets.kernels import bias_of


def plot_five_lines(q: np.ndarray, s: int, a: int) -> Picture:
    """The robot in state `s` of worked_example, and beside it the bias as the paper writes it, line by line.

    q: array (n_states, n_actions); a: the action whose numbers stand below each line
    """
    task = load_task("worked_example")
    action = task.actions.label(a)
    bias = float(bias_of(q, task.states.shape, s)[a])
    figure = Picture(figsize=(5.2, 4.2))
    figure.headline(
        advice(action, bias),
        f"the paper's five lines; in grey: the numbers of this robot for {action}",
    )
    room, lines = figure.subplots(1, 2, width_ratios=(1, 2.9))
    _draw_pose(room, task.states.decode(s), BLUE)
    room.set_title("thick bar: a wall or\nthe box is ahead", fontsize=10)
    room.set_axis_off()
    signs = [(mark.sign, mark.colour) for mark in marks_of(task).values()]
    signs.append(("", BLACK))  # the mean has none
    told = []
    for y, ((sign, colour), (symbols, numbers)) in enumerate(
        zip(signs, five_lines(q, s, a), strict=True)
    ):
        lines.text(0, y, sign, color=colour)
        lines.text(0.06, y, symbols)
        lines.text(0.06, y + 0.4, numbers, color=LIGHT["faint"])
        told.append(f"{symbols} {numbers}")
    lines.set(xlim=(0, 1), ylim=(4.6, -0.3))
    lines.set_axis_off()
    figure.alt = (
        f"The robot in state {s} ({state_words(task, s)}), and its bias for {action} in five lines. "
        f"{'; '.join(told)}."
    )
    return figure


def five_lines(q: np.ndarray, s: int, a: int) -> list[tuple[str, str]]:
    """The bias of state `s` of worked_example: the line of each input, and of their mean; in symbols and in numbers."""
    task = load_task("worked_example")
    names, means, lines = [], [], []
    for name, states in task.states.siblings(s).items():
        names.append(f"bias_{name_text(name).lower()}(s)")
        means.append(float(q[states, a].mean()))
        symbols = [f"Q({as_in_the_paper(task.states.decode(int(k)))})" for k in states]
        lines.append((f"{names[-1]} = {_mean(symbols)}", _mean_of(q[states, a])))
    lines.append((f"bias(s) = {_mean(names)}", _mean_of(np.array(means))))
    return lines


def as_in_the_paper(bins: Mapping[str, Bin]) -> str:
    """A state of worked_example as the paper writes it: ``1,1,90,T``."""
    texts = [value_text(value) for value in bins.values()]
    texts[-1] = "T" if bins["d"].reading else "F"
    return ",".join(texts)


def _mean(terms: Sequence[str]) -> str:
    return f"({' + '.join(terms)}) / {len(terms)}"


def _mean_of(values: np.ndarray) -> str:
    terms = [amount(value) for value in values]
    return f"= {_mean(terms)} = {amount(values.mean())}".replace("+ −", "− ")


def advice(action: str, bias: float) -> str:
    """What the similar states say of an action, as a sentence."""
    number = amount(bias)
    does = "recommend" if bias > 0 else "warn of"
    if number == "0.00":
        does = "say nothing of"
    return f"The similar states {does} {action}: bias {number}"


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
