"""The still twin of the bias explorer: what the states that have a say know, the mean of each set, and the choice."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.show.palette import BLUE, GREY
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark
from rlrobot_edu.widgets.bias_explorer.words import state_text, state_words, two_decimals, vector

LONG = 16  # signs; of longer names there is no room for one beside another


def draw_bias(task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark]) -> Picture:
    """The states that have a say in one state, and their values; the mean of each set; and the choice.

    q: array (n_states, n_actions); marks: of each input, by name
    """
    actions = [task.actions.label(a) for a in range(task.actions.n)]
    lines = 2 + sum(len(states) - 1 for states in numbers.sets.values())  # of the table
    figure = Picture(figsize=(9.5, 4 + 0.28 * lines))
    panes = figure.subplot_mosaic([["members", "members"], ["means", "choice"]], height_ratios=[0.28 * lines, 3.4])
    _draw_members(panes["members"], task, q, numbers, marks, actions)
    draw_means(panes["means"], numbers, marks, actions)
    _draw_choice(panes["choice"], numbers, actions)
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


def _draw_members(
    ax: Axes, task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]
) -> None:
    """A row for each state that has a say, in the colour of the input in which it differs: what it has learned."""
    others = [(int(k), name) for name, states in numbers.sets.items() for k in states if k != numbers.s]
    own = HERE._replace(sign="".join(mark.sign for mark in marks.values()))  # a member of every set
    rows = [(numbers.s, own), *((k, marks[name]) for k, name in others)]
    heads = actions if max(map(len, actions)) <= LONG else [f"action {a}" for a in range(len(actions))]
    ax.table(
        [[two_decimals(value) for value in q[k]] for k, _ in rows], cellLoc="center", bbox=(0, 0, 1, 1),
        rowLabels=[f"{k} {mark.sign}  {state_text(task, k)}" for k, mark in rows],
        rowColours=[mark.colour for _, mark in rows], colLabels=[plain(name) for name in heads],
    )  # fmt: skip
    ax.set_title(f"Q of state {numbers.s} and of those that share all inputs with it but one", fontsize=11)
    ax.set_axis_off()


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
