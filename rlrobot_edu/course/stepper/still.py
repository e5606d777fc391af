"""The stepper as a picture: what a saved notebook shows where no widget lives."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Rectangle

from rlrobot_edu.course.stepper.equations import explain_update
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number, short
from rlrobot_edu.course.stepper.panes import happened
from rlrobot_edu.course.stepper.tables import Window, q_range, shades
from rlrobot_edu.course.stepper.tape import EnvironmentView, Tape
from rlrobot_edu.show.palette import BLUE, ORANGE, VERMILION
from rlrobot_edu.show.picture import Picture, plain

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def still(tape: Tape, names: Names, view: EnvironmentView) -> Picture:
    """The view, choice, Q, traces and the equations at the position of `tape`."""
    frame, window = tape.frame, Window.of(tape)
    equations = explain_update(tape.agent, frame).text() if frame else []
    said = happened(frame, names)
    figure = Picture(figsize=(11, 7.2))
    figure.alt = " ".join([said, *(f"{line}." for line in equations)])
    title = "Before the first step"
    if frame is not None:
        rose = "rises" if frame.q_sa_new > frame.q_sa else "falls" if frame.q_sa_new < frame.q_sa else "stays"
        title = f"Step {tape.t}: Q({frame.step.s}, {frame.step.a}) {rose} to {number(frame.q_sa_new)}"
    figure.suptitle(plain("\n".join([title, *equations])), fontsize=12)
    traces = tape.agent.keeps_traces
    top, bottom = figure.subfigures(2, 1, height_ratios=(1, 1))
    left, right = top.subplots(1, 2)
    view.draw(left, tape.looks())
    left.set_title(view.heading, fontsize=10)
    _draw_choice(right, tape, window, names)
    axes = bottom.subplots(1, 1 + traces, squeeze=False)[0]
    _draw_q(axes[0], tape, window, names)
    if traces:
        values = _values(tape.e, window)
        _draw_table(axes[1], tape, values, window, names, lambda e: (ORANGE, min(e, 1.0), "black"))
        axes[1].set_title("Traces e, after they faded\n", fontsize=10)
    return figure


def _values(table: np.ndarray, window: Window) -> np.ndarray:
    """The shown part of a table, without empty rows; array (states, actions)."""
    return table[np.ix_([s for s in window.states if s is not None], window.actions)]


def _draw_q(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    (low, high), colours = q_range(tape.q), shades()
    scale = 255 / (high - low) if high > low else 0.0
    values = _values(tape.q, window)

    def paint(value: float) -> tuple[str, float, str]:
        back, ink = colours[int((value - low) * scale)]
        return back, 1.0, ink

    places = _draw_table(ax, tape, values, window, names, paint)
    ax.set_title(f"Q: {window.says}\nframed: changed by this step, bold: (s, a)".replace("; ", "\n"), fontsize=10)
    if tape.frame is None:
        return
    n_actions, step = tape.q.shape[1], tape.frame.step
    for where in tape.frame.q_change.where.tolist():
        if (place := places.get(divmod(where, n_actions))) is not None:
            bold = divmod(where, n_actions) == (step.s, step.a)
            ax.add_patch(Rectangle(place, 1, 1, fill=False, edgecolor=VERMILION, linewidth=3 if bold else 1.5,
                                   linestyle="-" if bold else "--"))  # fmt: skip


def _draw_table(
    ax: Axes,
    tape: Tape,
    values: np.ndarray,
    window: Window,
    names: Names,
    paint: Callable[[float], tuple[str, float, str]],
) -> dict[tuple[int, int], tuple[float, float]]:
    """Cells with numbers, block beside block. Returns the corner of each pair (s, a).

    paint: function (value) -> colour of the cell, its opacity, colour of the number
    """
    states, n = [s for s in window.states if s is not None], len(window.actions)
    rows = max(len(block) for block in window.blocks())
    places, step = {}, tape.frame.step if tape.frame else None
    size = 7.5 if len(window.blocks()) * n <= 10 else 5.5
    for i, s in enumerate(states):
        x, y = i // rows * (n + 1.2), i % rows
        role = "s " * (step is not None and s == step.s) + "s′ " * (step is not None and s == step.s_next)
        ax.text(x - 0.1, y + 0.5, f"{role}{s}", ha="right", va="center", fontsize=size)
        for j, a in enumerate(window.actions):
            value = float(values[i, j])
            colour, alpha, ink = paint(value)
            places[s, a] = x + j, y
            ax.add_patch(Rectangle((x + j, y), 1, 1, facecolor=colour, alpha=alpha, edgecolor="white", linewidth=0.4))
            ax.text(x + j + 0.5, y + 0.5, short(value), color=ink, ha="center", va="center",
                    fontsize=size)  # fmt: skip
    for x in range(-(-len(states) // rows)):
        for j, a in enumerate(window.actions):
            ax.text(x * (n + 1.2) + j + 0.5, -0.1, plain(names.column(a)), ha="center", va="bottom", fontsize=size)
    ax.set(xlim=(-1, len(window.blocks()) * (n + 1.2) - 1.1), ylim=(rows, -1))
    ax.set_axis_off()
    return places


def _draw_choice(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    if tape.frame is None:
        ax.set_axis_off()
        return
    step = tape.frame.step
    p = step.probabilities[window.actions]
    bars = ax.barh(range(len(p)), p, color=BLUE)
    labels = [plain(f"{'▶ ' if a == step.a else ''}{names.row(a)}") for a in window.actions]
    ax.set_yticks(range(len(p)), labels)
    ax.bar_label(bars, labels=[f"{x:.3f}" for x in p], padding=2, fontsize=8)
    ax.invert_yaxis()
    outputs = f" ({names.outputs})" if names.outputs else ""
    ax.set_xlim(0, 1.12)
    ax.set_xlabel(plain(f"probability of each action{outputs}"), fontsize=9)
    said = f"In s = {step.s} the agent chose {names.action(step.a)} (▶), r = {given(step.r)}"
    ax.set_title(plain(said), fontsize=10)
