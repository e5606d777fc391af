"""The still twin of the bias explorer: what the states that have a say know, the mean of each set, and the choice."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.show.palette import BLUE, GREY
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark
from rlrobot_edu.widgets.bias_explorer.words import (
    name_text,
    state_words,
    two_decimals,
    vector,
)


def draw_bias(
    task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], stage: int
) -> Picture:
    """The columns of one state up to number `stage`: values of the states that have a say, means, bias and choice.

    Up to the third they are those of the action that the bias favours; the fourth compares all actions.
    q: array (n_states, n_actions); marks: of each input, by name; stage: 1 to 4
    """
    actions = task.actions.labels
    best = int(numbers.bias.argmax())
    chosen = range(len(actions)) if stage == 4 else [best]
    block = 2.6 + sum(
        len(states) - 1 for states in numbers.sets.values()
    )  # rows of an action, and its name
    lines = 5.9 + block * len(chosen)
    figure = Picture(figsize=(5.2, min(0.225 * lines, 60)), layout="none")
    ax = figure.add_axes(
        (0.01, 0, 0.98, 1),
        xlim=(-0.2, 52),
        ylim=(lines, 0),
        xticks=[],
        yticks=[],
        frame_on=False,
    )
    for x, head in (
        (0, "Q of state s and\nits similar states"), (21, "mean\nof each set"), (32.5, "bias: mean\nof means"),
        (42.5, "probability\n0 to 100 %"),
    )[:stage]:  # fmt: skip
        ax.text(x, 0.2, head, va="top", weight="bold")
    for i, a in enumerate(chosen):
        ax.text(
            0,
            3 + i * block,
            plain(actions[a]),
            va="center",
            size=11,
            weight="bold",
            color=BLUE,
        )
        _draw_action(ax, 3.6 + i * block, q[:, a], a, numbers, marks, stage)
    ax.text(0, lines - 1.3, "  ".join(f"{mark.sign} {plain(name_text(name))}" for name, mark in marks.items())
            + f":\nthe input in which a state differs from s = {numbers.s}.\n"
            "State s is in every set, so it has every mark.")  # fmt: skip
    if stage == 4:
        ax.legend(ax.containers[-2:], ["without the bias: of Q(s)", "with it: of Q(s) + bias(s)"], ncols=2,
                  loc="lower left", frameon=False, borderpad=0, handlelength=1.5, columnspacing=1)  # fmt: skip
    told = [
        f"State {numbers.s} of {task.name} ({state_words(task, numbers.s)}) and its sets, by input: " + "; ".join(
            f"{name_text(name)}: {', '.join(map(str, states))}" for name, states in numbers.sets.items()),
        f"Means of the sets for {actions[best]}: {vector(numbers.means[:, best])}",
        f"Bias for {', '.join(actions)}: {vector(numbers.bias)}",
        "Probabilities: " + "; ".join(
            f"{name} {100 * sr:.1f} % without and {100 * biased:.1f} % with the bias"
            for name, sr, biased in zip(actions, numbers.sr, numbers.qbiassr, strict=True)),
    ]  # fmt: skip
    figure.alt = ". ".join(told[:stage])
    return figure


def _draw_action(
    ax: Axes,
    top: float,
    q: np.ndarray,
    a: int,
    numbers: BiasNumbers,
    marks: dict[str, Mark],
    stage: int,
) -> None:
    """The columns of action `a` and the lines that lead from one to the next. q: array (n_states,), of the action."""
    s, sets = numbers.s, numbers.sets
    rows = {s: HERE} | {
        int(k): marks[name] for name, states in sets.items() for k in states if k != s
    }
    height = {k: top + i + 0.5 for i, k in enumerate(rows)}
    middle = top + len(rows) / 2
    for k, mark in rows.items():
        _box(
            ax,
            0,
            15.5,
            height[k],
            mark.colour,
            f"{k:>2} {mark.sign:<8}{two_decimals(q[k]):>7}",
        )
    for i, mark in enumerate(marks.values()):  # the state itself is in every set
        _box(ax, 3 + 1.4 * i, 1.4, height[s], mark.colour, mark.sign)
    for i, (name, mark) in enumerate(marks.items()):
        y = top + (i + 0.5) * len(rows) / len(marks)
        if stage > 1:
            ax.plot(
                (15.5, 21),
                [[height[k] for k in sets[name]], [y] * len(sets[name])],
                color=mark.colour,
            )
            _box(
                ax,
                21,
                8.5,
                y,
                mark.colour,
                f"{mark.sign} {two_decimals(numbers.means[i, a]):>7}",
            )
        if stage > 2:
            ax.plot((29.5, 33.5), (y, middle), color=mark.colour)
    if stage > 2:
        _box(ax, 33.5, 7, middle, "white", two_decimals(numbers.bias[a]))
    if stage > 3:
        ax.text(40.5, middle + 1, f"+ Q(s) = {two_decimals(q[s] + numbers.bias[a])}", ha="right", va="center", size=9,
                bbox={"color": "white", "pad": 0.5})  # fmt: skip
        ax.barh(
            (middle - 0.55, middle + 0.55),
            4.5,
            0.9,
            left=42.5,
            color="white",
            edgecolor="black",
            linewidth=0.6,
        )
        for y, p, look in ((middle - 0.55, numbers.sr[a], {"color": "white", "edgecolor": GREY, "hatch": "//////"}),
                           (middle + 0.55, numbers.qbiassr[a], {"color": BLUE})):  # fmt: skip
            ax.barh(y, 4.5 * p, 0.9, left=42.5, **look)
            ax.text(52, y, f"{100 * p:.0f} %", ha="right", va="center")


def _box(ax: Axes, x: float, width: float, y: float, colour: str, text: str) -> None:
    """A text of fixed pitch in a box that begins at `x`."""
    ax.barh(
        y, width, 0.86, left=x, color=colour, edgecolor="black", linewidth=0.6, zorder=2
    )
    ax.text(
        x + width - 0.3, y, text, ha="right", va="center", family="monospace", size=9.5
    )
