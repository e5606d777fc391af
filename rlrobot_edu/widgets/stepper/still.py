"""The stepper as a picture: what a saved notebook shows where no widget works. It is legible at 700 pixels."""

from __future__ import annotations

import textwrap

from matplotlib.axes import Axes

from rlrobot_edu.show.palette import BLUE
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.widgets.stepper.equations import as_text, explain_update
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import given, number
from rlrobot_edu.widgets.stepper.still_tables import draw_q, draw_traces, n_rows
from rlrobot_edu.widgets.stepper.symbols import in_symbols
from rlrobot_edu.widgets.stepper.tables import Window
from rlrobot_edu.widgets.stepper.tape import Frame, Tape

WIDTH, WORLD, ROW = (
    7.8,
    3.3,
    0.2,
)  # inches: of the picture, of the world in it, of a row of a table
LINE = 92  # signs


def still(tape: Tape, names: Names) -> Picture:
    """The view, choice, the equations, Q and traces at the position of `tape`."""
    frame, window = tape.frame, Window.of(tape)
    equations = (
        [as_text(line) for line in explain_update(tape.agent, frame)] if frame else []
    )
    title = ["Before the first step"]
    if frame is not None:
        rose = (
            "rises"
            if frame.q_sa_new > frame.q_sa
            else "falls"
            if frame.q_sa_new < frame.q_sa
            else "stays"
        )
        title = [
            f"Step {tape.t}: Q({frame.step.s}, {frame.step.a}) {rose} to {number(frame.q_sa_new)}"
        ]
        title += [
            textwrap.fill(line, LINE, subsequent_indent="    ") for line in equations
        ]
    table, tables = (
        n_rows(window) * ROW + 0.75,
        1 + tape.agent.method.algorithm.has_traces,
    )
    choice = 0.25 * len(window.actions) + 1.2
    above = max(WORLD, choice)
    lines = sum(1 + line.count("\n") for line in title)
    figure = Picture(figsize=(WIDTH, 0.2 * lines + above + tables * table))
    figure.alt = " ".join([sentence(tape, names), *(f"{line}." for line in equations)])
    figure.suptitle(plain("\n".join(title)), fontsize=10.5)
    parts = figure.subfigures(1 + tables, 1, height_ratios=[above] + [table] * tables)
    left, right = parts[0].subplots(1, 2)
    tape.view.draw(left, tape)
    left.set_title(tape.view.heading, fontsize=9.5)
    left.set(xlabel="", ylabel="")
    left.tick_params(labelsize=8.5)
    _draw_choice(right, tape, frame, window, names)
    draw_q(parts[1].subplots(), tape, window, names)
    if tape.agent.method.algorithm.has_traces:
        draw_traces(parts[2].subplots(), tape, window, names)
    return figure


def sentence(tape: Tape, names: Names) -> str:
    """The step in one sentence, with a′ if the update of this algorithm learns from it."""
    frame = tape.frame
    if frame is None:
        return "Before the first step."
    step = frame.step
    text = (
        f"Step {step.t + 1} (episode {frame.episode}, its step {frame.number}): in state s = {step.s} the agent took "
        f"action a = {_named(step.a, names)} and got r = {given(step.r)}; now it is in s′ = {step.s_next}"
    )
    if step.terminated:
        return f"{text}, where the episode ends."
    if step.truncated:
        return f"{text}; the time of this episode is up."
    takes_next = "{Q(s′, a′)}" in "".join(
        in_symbols(tape.agent.method.algorithm.name).equation(tape.agent.parameters)
    )
    if takes_next:
        text += f", where it will take a′ = {_named(step.a_next, names)}"
    return f"{text}."


def _named(a: int, names: Names) -> str:
    short = names.action(a)
    return str(a) if short == str(a) else f"{a} ({short})"


def _draw_choice(
    ax: Axes, tape: Tape, frame: Frame | None, window: Window, names: Names
) -> None:
    """A bar for each action, with its bias where there is one; the title says at which temperature it was chosen."""
    if frame is None:
        ax.set_axis_off()
        return
    step = frame.step
    p = step.probabilities[window.actions]
    ax.barh(range(len(p)), p, color=BLUE)
    labels = [
        plain(f"{'▶ ' if a == step.a else ''}{names.row(a)}") for a in window.actions
    ]
    ax.set_yticks(range(len(p)), labels, fontsize=8.5)
    values = [f"{x:.3f}" for x in p]
    if step.bias is not None:
        values = [
            f"{text}  (bias {number(float(step.bias[a]))})"
            for text, a in zip(values, window.actions, strict=True)
        ]
    for row, (x, text) in enumerate(zip(p, values, strict=True)):
        inside = x > 0.5
        place, side, ink = (
            (x - 0.02, "right", "white") if inside else (x + 0.02, "left", "black")
        )
        ax.text(place, row, text, ha=side, va="center", fontsize=8.5, color=ink)
    ax.invert_yaxis()
    ax.set_xlim(0, 1.02)
    ax.tick_params(labelsize=8.5)
    outputs = (
        f"\n({names.outputs})" if "," in names.outputs else ""
    )  # one speaks for itself
    ax.set_xlabel(plain(f"probability of each action{outputs}"), fontsize=8.5)
    heat = (
        f", at T = {given(step.temperature)},"
        if tape.agent.method.selection.is_softmax
        else ""
    )
    said = f"In state {step.s}{heat} it chose {names.action(step.a)} (▶); r = {given(step.r)}"
    ax.set_title(plain(textwrap.fill(said, 44)), fontsize=9.5)
