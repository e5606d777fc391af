"""The stepper as a picture, which a saved notebook shows instead of the widget. It is legible at 700 pixels."""

from __future__ import annotations

import textwrap

from matplotlib.axes import Axes

from rlrobot_edu.show.palette import BLUE
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.widgets.stepper.equations import as_text, explain_update
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import given, number
from rlrobot_edu.widgets.stepper.sentences import sentence, simply
from rlrobot_edu.widgets.stepper.still_tables import (
    draw_q,
    draw_traces,
    n_rows,
    rows_of_step,
)
from rlrobot_edu.widgets.stepper.tables import Window
from rlrobot_edu.widgets.stepper.tape import Frame, Tape

WIDTH = 7.8  # of the picture [inch]
WORLD = 4.1  # height of the world in it [inch]
ROW = 0.22  # height of a row of a table, and of a line of the note [inch]
LINE = 92  # signs of a line of the note
TITLE = 74  # and of the title


def still(tape: Tape, names: Names) -> Picture:
    """The view, the choice, the equations, Q and traces at the position of `tape`."""
    frame = tape.frame
    window = rows_of_step(tape)
    equations = []
    if frame is not None:
        equations = [as_text(line) for line in explain_update(tape.agent, frame)]
    note = "\n".join([f"step {tape.t}", *equations])
    n_tables = 2 if tape.agent.method.algorithm.has_traces else 1
    table = n_rows(window) * ROW + 0.75
    choice = 0.3 * len(window.actions) + 1.2
    above = max(WORLD, choice)
    title = "\n".join(textwrap.wrap(simply(tape, names), TITLE))
    n_lines = 1 + sum(len(line) // LINE + 1 for line in equations)
    n_lines += 1.3 * title.count("\n")
    head = 0.45 + ROW * (n_lines + 1)
    figure = Picture(figsize=(WIDTH, head + above + n_tables * table))
    sentences = [sentence(tape, names)]
    sentences += [f"{line}." for line in equations]
    figure.alt = " ".join(sentences)
    figure.headline(title, note)
    heights = [above] + [table] * n_tables
    grid = figure.add_gridspec(
        1 + n_tables, 2, height_ratios=heights, width_ratios=(3, 2)
    )
    left = figure.add_subplot(grid[0, 0])
    tape.view.draw(left, tape)
    left.set(title=tape.view.heading, xlabel="", ylabel="")
    _draw_choice(figure.add_subplot(grid[0, 1]), tape, frame, window, names)
    draw_q(figure.add_subplot(grid[1, :]), tape, window, names)
    if n_tables == 2:
        draw_traces(figure.add_subplot(grid[2, :]), tape, window, names)
    return figure


def _draw_choice(
    ax: Axes, tape: Tape, frame: Frame | None, window: Window, names: Names
) -> None:
    """A bar for each action, with its bias if there is one; the title gives the temperature of the choice."""
    if frame is None:
        ax.set_axis_off()
        return
    step = frame.step
    p = step.probabilities[window.actions]
    rows = range(len(p))
    ax.barh(rows, p, height=0.6, color=BLUE)
    labels = []
    for a in window.actions:
        arrow = "▶ " if a == step.a else ""
        labels.append(plain(f"{arrow}{names.row(a)}"))
    ax.set_yticks(rows, labels)
    for row, a in enumerate(window.actions):
        text = f"{p[row]:.3f}"
        if step.bias is not None:
            text += f"  (bias {number(float(step.bias[a]))})"
        _write_on_bar(ax, row, p[row], text)
    ax.invert_yaxis()
    ax.set_xlim(0, 1.02)
    label = "probability of each action"
    if "," in names.outputs:  # a single output needs no name
        label += f"\n({names.outputs})"
    ax.set_xlabel(plain(label))
    heat = ""
    if tape.agent.method.selection.is_softmax:
        heat = f", at T = {given(step.temperature)},"
    title = (
        f"In state {step.s}{heat} it chose {names.action(step.a)} (▶); "
        f"r\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}{given(step.r)}"
    )
    ax.set_title(plain(textwrap.fill(title, 36)))


def _write_on_bar(ax: Axes, row: int, length: float, text: str) -> None:
    """A text in white at the end of a long bar, or in black beside a short one."""
    if length > 0.5:
        x, side, ink = length - 0.02, "right", "white"
    else:
        x, side, ink = length + 0.02, "left", "black"
    ax.text(x, row, text, ha=side, va="center", color=ink)
