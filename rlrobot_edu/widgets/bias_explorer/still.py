"""The bias explorer as a picture: the values of the states in the sets, the mean of each set, the bias, the choice."""

from __future__ import annotations

import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb

from rlrobot_edu.show.palette import BLACK, BLUE, GREY, WHITE
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import Mark
from rlrobot_edu.widgets.bias_explorer.words import (
    amount,
    finding,
    name_text,
    percents,
    state_words,
    vector,
)

PALE = (
    0.72  # how much white is in the floor of a box, so that letters can be read on it
)
LETTERS = 62  # of a line of the title
TITLE_LINE = 1.25  # its height, in rows of a column
OTHER = 2.5  # rows of an action of which only bias and choice are shown
# Where each column begins, and its heading
HEADS = (
    (0, "Q of state s and\nits similar states"),
    (21, "mean\nof each set"),
    (32.5, "bias: mean\nof means"),
    (42.5, "probability\n0 to 100 %"),
)


def draw_bias(
    task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], stage: int
) -> Picture:
    """The columns of one state up to number `stage`: values of the states in its sets, means, bias and choice.

    They are those of the action whose probability the bias changes most. The fourth compares all actions: the others
    stand below it, a row each.
    q: array (n_states, n_actions); marks: of each input, by name; stage: 1 to 4
    """
    names = [plain(name) for name in task.actions.labels]
    shown = numbers.most_changed
    others = []
    title = []
    if stage == 4:
        others = [a for a in range(len(names)) if a != shown]
        title = textwrap.wrap(finding(names, q, numbers), LETTERS)
    n_rows = 1 + sum(len(states) - 1 for states in numbers.sets.values())
    heads = TITLE_LINE * len(title) + 0.2
    top = heads + 3.4
    below = top + max(n_rows, len(marks))
    lines = below + OTHER * len(others) + 4
    figure = Picture(figsize=(5.2, min(0.225 * lines, 60)), layout="none")
    ax = figure.add_axes((0.01, 0, 0.98, 1), frame_on=False)
    ax.set(xlim=(-0.2, 52), ylim=(lines, 0), xticks=[], yticks=[])
    figure.finding = " ".join(title)
    if title:
        ax.text(0, 0.3, "\n".join(title), va="top", size=12, weight="bold")
    for x, head in HEADS[:stage]:
        ax.text(x, heads, head, va="top", weight="bold")
    letters = {"size": 11, "weight": "bold", "va": "center"}
    ax.text(0, top - 0.6, names[shown], color=BLUE, **letters)
    _draw_action(ax, top, q[:, shown], shown, numbers, marks, stage)
    for i, a in enumerate(others):
        y = below + OTHER * (i + 0.6)
        ax.text(0, y, names[a], **letters)
        ax.text(40.2, y, amount(numbers.bias[a]), ha="right", va="center")
        _draw_probabilities(ax, y, a, numbers)
    ax.text(0, lines - 1.3, _legend(marks, numbers.s))
    if stage == 4:
        ax.legend(
            ax.containers[-2:],
            ["without the bias: of Q(s)", "with it: of Q(s) + bias(s)"],
            ncols=2,
            loc="lower left",
            frameon=False,
            borderpad=0,
            handlelength=1.5,
            columnspacing=1,
        )
    figure.alt = ". ".join(_sentences(task, numbers)[:stage])
    return figure


def _legend(marks: dict[str, Mark], s: int) -> str:
    """What the marks of the inputs mean."""
    named = [f"{mark.sign} {plain(name_text(name))}" for name, mark in marks.items()]
    return (
        f"{'  '.join(named)}:\nthe input in which a state differs from s = {s}.\n"
        "State s is in every set, so it has every mark."
    )


def _sentences(task: Task, numbers: BiasNumbers) -> list[str]:
    """A sentence for each column, for readers who cannot see it."""
    actions = task.actions.labels
    shown = numbers.most_changed
    sets = []
    for name, states in numbers.sets.items():
        sets.append(f"{name_text(name)}: {', '.join(str(s) for s in states)}")
    probabilities = []
    for name, sr, biased in zip(actions, numbers.sr, numbers.qbiassr, strict=True):
        without, with_bias = percents(sr, biased, 1)
        probabilities.append(f"{name} {without} without and {with_bias} with the bias")
    here = f"State {numbers.s} of {task.name} ({state_words(task, numbers.s)})"
    return [
        f"{here} and its sets, by input: {'; '.join(sets)}",
        f"Means of the sets for {actions[shown]}: {vector(numbers.means[:, shown])}",
        f"Bias for {', '.join(actions)}: {vector(numbers.bias)}",
        f"Probabilities: {'; '.join(probabilities)}",
    ]


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
    s = numbers.s
    rows: dict[int, Mark | None] = {s: None}
    for name, states in numbers.sets.items():
        rows |= {int(k): marks[name] for k in states if k != s}
    height = {k: top + i + 0.5 for i, k in enumerate(rows)}
    middle = top + len(rows) / 2
    for k, mark in rows.items():
        sign = mark.sign if mark else ""
        text = f"{k:>2} {sign:<8}{amount(q[k]):>7}"
        _box(ax, 0, 15.5, height[k], mark, text)
    for i, mark in enumerate(marks.values()):  # the state itself is in every set
        _box(ax, 3 + 1.4 * i, 1.4, height[s], mark, mark.sign)
    for i, (name, mark) in enumerate(marks.items()):
        y = top + (i + 0.5) * len(rows) / len(marks)
        if stage > 1:
            begins = [height[k] for k in numbers.sets[name]]
            ax.plot((15.5, 21), [begins, [y] * len(begins)], color=mark.colour)
            text = f"{mark.sign} {amount(numbers.means[i, a]):>7}"
            _box(ax, 21, 8.5, y, mark, text)
        if stage > 2:
            ax.plot((29.5, 33.5), (y, middle), color=mark.colour)
    if stage > 2:
        _box(ax, 33.5, 7, middle, None, amount(numbers.bias[a]))
    if stage > 3:
        text = f"Q(s) + bias = {amount(q[s] + numbers.bias[a])}"
        white = {"color": WHITE, "pad": 0.5}
        right = {"ha": "right", "va": "center"}
        ax.text(40.5, middle + 1, text, size=9, bbox=white, **right)
        _draw_probabilities(ax, middle, a, numbers)


def _draw_probabilities(ax: Axes, middle: float, a: int, numbers: BiasNumbers) -> None:
    """The probability of action `a` without the bias, and below it with the bias."""
    above, below = middle - 0.55, middle + 0.55
    border = {"color": WHITE, "edgecolor": BLACK, "linewidth": 0.6}
    ax.barh((above, below), 4.5, 0.9, left=42.5, **border)
    hatched = {"color": WHITE, "edgecolor": GREY, "hatch": "//////"}
    sr, biased = numbers.sr[a], numbers.qbiassr[a]
    without, with_bias = percents(sr, biased, 0)
    for y, p, text, look in (
        (above, sr, without, hatched),
        (below, biased, with_bias, {"color": BLUE}),
    ):
        ax.barh(y, 4.5 * p, 0.9, left=42.5, **look)
        ax.text(52, y, text, ha="right", va="center")


def _box(
    ax: Axes, x: float, width: float, y: float, mark: Mark | None, text: str
) -> None:
    """A text of fixed pitch in a box that begins at `x`, in the colour of a mark; without one it is white."""
    edge = BLACK
    floor = WHITE
    if mark:
        edge = mark.colour
        floor = to_hex(
            PALE * np.array(to_rgb(WHITE)) + (1 - PALE) * np.array(to_rgb(edge))
        )
    look = {"color": floor, "edgecolor": edge, "linewidth": 1.2}
    ax.barh(y, width, 0.86, left=x, zorder=2, **look)
    letters = {"family": "monospace", "size": 9.5, "color": BLACK}
    ax.text(x + width - 0.3, y, text, ha="right", va="center", **letters)
