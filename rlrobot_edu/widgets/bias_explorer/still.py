"""The still twin of the bias explorer: the same state, sets, means and probabilities as one picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.gridspec import SubplotSpec
from matplotlib.patches import Rectangle

from rlrobot_edu.show.palette import BLUE, GREY
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark, signs
from rlrobot_edu.widgets.bias_explorer.panes import two_decimals, vector
from rlrobot_edu.widgets.bias_explorer.states import (
    block_text,
    blocks_of,
    inputs_text,
    place_of,
    state_text,
    state_words,
    value_text,
)

GAP = 1.0  # between two blocks, in cells
LONG = 16  # signs; of longer names there is no room for one beside another
MOST_ROWS = 10  # of states that have a say; a picture has no room for more


def draw_bias(
    task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]
) -> Picture:
    """The layout of the states with the sets of one of them; what these know; the mean of each set; and the choice.

    q: array (n_states, n_actions); marks: of each input, by name; actions: their names
    """
    figure = Picture(figsize=(9.5, 6.6))
    layout, members, means, choice = (figure.add_subplot(cell) for cell in _cells(figure))
    _draw_states(layout, task, numbers, marks)
    _draw_members(members, task, q, numbers, marks, actions)
    draw_means(means, numbers, marks, actions)
    _draw_choice(choice, numbers, actions)
    chances = "; ".join(
        f"{name} {100 * sr:.1f} % without and {100 * biased:.1f} % with the bias"
        for name, sr, biased in zip(actions, numbers.sr, numbers.qbiassr, strict=True)
    )
    sets = "; ".join(f"{name}: {', '.join(map(str, states))}" for name, states in numbers.sets.items())
    figure.alt = (
        f"State {numbers.s} of {task.name} ({state_words(task, numbers.s)}) and the states that share all inputs with "
        f"it but one, by input: {sets}. Bias {vector(numbers.bias)}. Probabilities: {chances}."
    )
    return figure


def _cells(figure: Picture) -> list[SubplotSpec]:
    """Two on the left, and two on the right."""
    left, right = figure.add_gridspec(1, 2, width_ratios=[1.15, 1])
    return [*left.subgridspec(2, 1, height_ratios=[3, 2]), *right.subgridspec(2, 1)]


def _draw_states(ax: Axes, task: Task, numbers: BiasNumbers, marks: dict[str, Mark]) -> None:
    """Every state as a numbered cell, in its block; the members of the sets in their colours, with their signs."""
    mark_of = {s: (HERE if name is None else marks[name], signs(marks, name)) for s, name in numbers.members}
    inner, shape = task.inputs[-2:], task.states.shape
    columns, rows = (shape[-2] if len(shape) > 1 else 1), shape[-1]
    for block, states in blocks_of(task).items():
        left, bottom = block[0] * (columns + GAP), block[1] * (rows + 2 * GAP)
        ax.text(left, bottom + rows + 0.55, block_text(task, states[0]), weight="bold", va="bottom")
        for s in states:
            place = place_of(task, s)
            x, y = left + place.column, bottom + rows - 1 - place.row  # inside a block the first row is on top
            mark, sign = mark_of.get(s, (None, ""))
            face, ink = (mark.colour, mark.ink) if mark else ("#ffffff", "#000000")
            ax.add_patch(Rectangle((x + 0.04, y + 0.06), 0.92, 0.88, facecolor=face, edgecolor=GREY, linewidth=0.8))
            ax.text(x + 0.5, y + 0.5, f"{s}\n{sign}" if sign else str(s), color=ink, ha="center", va="center", size=9)
            if place.row == 0 and len(inner) > 1:
                text = f"{inner[0].name} {value_text(inner[0].decode(place.column))}"
                ax.text(x + 0.5, y + 1.1, text, ha="center", va="bottom", size=8.5)
            if place.column == 0 and block[0] == 0:
                ax.text(x - 0.1, y + 0.5, f"{inner[-1].name} {value_text(inner[-1].decode(place.row))}", ha="right",
                        va="center", size=8.5)  # fmt: skip
    ax.set_title(f"State {numbers.s} and those that share all inputs but one", fontsize=11)
    ax.autoscale_view()
    ax.set_ylim(top=ax.get_ylim()[1] + GAP)  # the title of the topmost block
    ax.set_axis_off()


def _draw_members(
    ax: Axes, task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]
) -> None:
    """A row for each state that has a say: what it has learned of each action."""
    ax.set_title("Q of these states", fontsize=11)
    ax.set(xlim=(0, 1), ylim=(min(len(numbers.members), MOST_ROWS) + 0.6, -0.6))
    ax.set_axis_off()
    x = np.linspace(0.42, 0.95, len(actions))
    heads = actions if max(map(len, actions)) <= LONG else [f"action {a}" for a in range(len(actions))]
    for a, name in enumerate(heads):
        ax.text(x[a], 0, plain(name), ha="center", va="center", size=9)
    if len(text := inputs_text(task)) <= LONG:
        ax.text(0.12, 0, plain(text), va="center", size=9)
    for row, (s, name) in enumerate(numbers.members[:MOST_ROWS], start=1):
        mark = HERE if name is None else marks[name]
        chip = {"facecolor": mark.colour, "edgecolor": "none", "pad": 2}
        ax.text(0.02, row, f"{s} {mark.sign}".strip(), color=mark.ink, va="center", size=9, bbox=chip)
        if len(text := state_text(task, s)) <= LONG:
            ax.text(0.12, row, plain(text), va="center", size=9)
        for a, value in enumerate(q[s]):
            ax.text(x[a], row, two_decimals(value), ha="center", va="center", size=9)
    if len(numbers.members) > MOST_ROWS:
        ax.text(0.02, MOST_ROWS + 0.6, f"and {len(numbers.members) - MOST_ROWS} more", size=9)


def draw_means(ax: Axes, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]) -> None:
    """A group of bars an action: the mean of each set, and their mean, the bias."""
    bars = [*zip(numbers.sets, numbers.means, strict=True)]
    width = 0.8 / (len(bars) + 1)
    x = np.arange(len(actions))
    for i, (name, mean) in enumerate(bars):
        mark = marks[name]
        drawn = ax.bar(x + i * width, mean, width, color=mark.colour, edgecolor="black", linewidth=0.5,
                       label=f"{mark.sign} mean over {name}")  # fmt: skip
        ax.bar_label(drawn, [mark.sign] * len(actions), size=8.5, padding=1)
    drawn = ax.bar(x + len(bars) * width, numbers.bias, width, color="white", edgecolor="black", hatch="////",
                   label="bias: their mean")  # fmt: skip
    ax.bar_label(drawn, [two_decimals(b) for b in numbers.bias], size=8.5, padding=2)
    _name_actions(ax, x + len(bars) * width / 2, actions)
    ax.axhline(0, color="black", linewidth=0.8)
    ax.margins(y=0.2)
    columns = 2 if max(map(len, numbers.sets)) <= 6 else 1
    (low, high), lines = ax.get_ylim(), len(bars) // columns + 1
    ax.set(ylim=(low, high + 0.12 * lines * (high - low)))  # room for the legend
    ax.set(ylabel="action value", title="What they think of each action")
    ax.legend(fontsize=8.5, ncols=columns, loc="upper left")


def _draw_choice(ax: Axes, numbers: BiasNumbers, actions: Sequence[str]) -> None:
    """The probability of each action, without and with the bias."""
    x = np.arange(len(actions))
    for shift, p, style in (
        (-0.2, numbers.sr, {"color": "white", "edgecolor": GREY, "hatch": "////", "label": "SR: softmax of Q(s)"}),
        (0.2, numbers.qbiassr, {"color": BLUE, "edgecolor": BLUE, "label": "QBIASSR: softmax of Q(s) + bias(s)"}),
    ):
        ax.bar_label(ax.bar(x + shift, 100 * p, 0.38, **style), fmt="%.0f %%", size=8.5, padding=2)
    _name_actions(ax, x, actions)
    ax.set(ylim=(0, 150), yticks=range(0, 101, 25), ylabel="probability (%)", title="What it does to the choice")
    ax.legend(fontsize=8.5, loc="upper left")  # above the bars, which end at 100


def _name_actions(ax: Axes, x: np.ndarray, actions: Sequence[str]) -> None:
    """Ticks at `x`, a line for each output; long names are turned, so that they do not run into each other."""
    names = [plain(name.replace(", ", "\n")) for name in actions]
    turned = {"rotation": 40, "ha": "right", "rotation_mode": "anchor"} if max(map(len, actions)) > LONG else {}
    ax.set_xticks(x, names, fontsize=9, **turned)
