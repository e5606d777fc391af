"""Q and the traces in the still picture."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.picture import plain
from rlrobot_edu.widgets.stepper.colours import scale_limit, tint, trace_tint
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import before_it, short
from rlrobot_edu.widgets.stepper.tables import Window, traces_of
from rlrobot_edu.widgets.stepper.tape import Frame, Tape

COLUMNS = 10  # that fit side by side, with numbers in letters of SIZE points
SIZE, SMALL = 11.2, 9.6
MOST_ROWS = 8  # of the states that a step changed
FEW = 4  # actions whose cells have room for the old value
GAP = 1.3  # cells between two blocks
UNTRIED = "·"

Look = tuple[str, str, float]  # of a cell: text, colour, opacity
Places = dict[tuple[int, int], tuple[float, float]]  # the corner of each pair (s, a)


def n_rows(window: Window) -> int:
    """Rows of a table: states that do not fit below each other stand side by side, as far as there is room."""
    n_states = sum(s is not None for s in window.states)
    fit = int((COLUMNS + GAP) // (len(window.actions) + GAP))
    wanted = math.ceil(n_states / 8)
    blocks = max(1, min(fit, wanted))
    return math.ceil(n_states / blocks)


def rows_of_step(tape: Tape) -> Window:
    """The rows of the tables that the step changed, and those of s and s′; before the first step, the first rows."""
    window = Window.of(tape)
    frame = tape.frame
    n_states, n_actions = tape.q.shape
    if frame is None:
        states = [s for s in window.states if s is not None][:MOST_ROWS]
        return window._replace(states=states, says=f"{len(states)} of {n_states} rows")
    change = frame.q_change
    largest_first = np.argsort(-np.abs(change.new - change.old), kind="stable")
    rows = [frame.step.s, *(change.where[largest_first] // n_actions).tolist()]
    if frame.step.s_next < n_states:
        rows.insert(1, frame.step.s_next)
    each_once = list(dict.fromkeys(rows))
    says = f"the rows of this step, of {n_states}"
    if len(each_once) > MOST_ROWS:
        says = f"the {MOST_ROWS} rows that changed most, of {n_states}"
    return window._replace(states=sorted(each_once[:MOST_ROWS]), says=says)


def draw_q(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    """Q with a dot where nothing was tried; what the step changed is framed and carries ▲ or ▼."""
    most = scale_limit(tape.q, tape.agent.parameters.r_max)

    def look(s: int, a: int) -> Look:
        value = float(tape.q[s, a])
        is_untried = value == 0 and not tape.visits[s, a]
        colour, opacity = tint(value, most)
        return UNTRIED if is_untried else short(value), colour, opacity

    places = _draw(ax, tape, window, names, look)
    ax.set_title(
        f"What it has learned, Q: {window.says}; · never tried; framed: changed"
    )
    if tape.frame is not None:
        _mark_changes(ax, tape.frame, tape.q.shape[1], places)


def _mark_changes(ax: Axes, frame: Frame, n_actions: int, places: Places) -> None:
    """Frame what the step changed, boldly the pair (s, a) itself."""
    change = frame.q_change
    for where, old, new in zip(
        change.where.tolist(), change.old.tolist(), change.new.tolist(), strict=True
    ):
        pair = divmod(where, n_actions)
        if pair not in places:
            continue
        x, y = places[pair]
        border = Rectangle((x, y), 1, 1, fill=False, edgecolor="black", zorder=3)
        if pair == (frame.step.s, frame.step.a):
            border.set(linewidth=2.2, linestyle="-")
        else:
            border.set(linewidth=1.1, linestyle="--")
        ax.add_patch(border)
        arrow = "▲" if new > old else "▼"
        if n_actions <= FEW:
            arrow = f"{arrow}  {before_it(old, new)}"
        ax.text(x + 0.05, y + 0.5, arrow, va="center", fontsize=SMALL - 2)


def draw_traces(ax: Axes, tape: Tape, window: Window, names: Names) -> None:
    """The traces by which the update learned."""
    n_actions = tape.q.shape[1]
    traces = traces_of(tape.frame)

    def look(s: int, a: int) -> Look:
        e = traces.get(s * n_actions + a, 0.0)
        colour, opacity = trace_tint(e)
        return short(e) if e else UNTRIED, colour, opacity

    _draw(ax, tape, window, names, look)
    ax.set_title("Traces e, as this update used them")


def _draw(
    ax: Axes, tape: Tape, window: Window, names: Names, look: Callable[[int, int], Look]
) -> Places:
    """Cells with the text and the colour of `look(s, a)`, block beside block. Returns the corner of each cell."""
    states = [s for s in window.states if s is not None]
    n = len(window.actions)
    rows = n_rows(window)
    size = SIZE if n <= 4 else SMALL
    places = {}
    for i, s in enumerate(states):
        block, row = divmod(i, rows)
        x, y = block * (n + GAP), row
        name = f"{_role_of(s, tape.frame)}{s}"
        ax.text(x - 0.1, y + 0.5, name, ha="right", va="center", fontsize=SIZE)
        for j, a in enumerate(window.actions):
            places[s, a] = x + j, y
            _draw_cell(ax, x + j, y, look(s, a), size)
    n_blocks = math.ceil(len(states) / rows)
    for block in range(n_blocks):
        for j, a in enumerate(window.actions):
            middle = block * (n + GAP) + j + 0.5
            head = plain(names.column(a))
            ax.text(middle, -0.1, head, ha="center", va="bottom", fontsize=SIZE)
    ax.set(xlim=(-GAP, n_blocks * (n + GAP) - GAP + 0.1), ylim=(rows + 0.05, -1))
    ax.set_axis_off()
    return places


def _role_of(s: int, frame: Frame | None) -> str:
    """What a state is in the step shown, to stand before its number."""
    role = ""
    if frame is not None and s == frame.step.s:
        role += "s "
    if frame is not None and s == frame.step.s_next:
        role += "s′ "
    return role


def _draw_cell(ax: Axes, x: float, y: float, look: Look, size: float) -> None:
    """One cell, whose corner is at (x, y)."""
    text, colour, opacity = look
    floor = Rectangle((x, y), 1, 1, facecolor=colour, alpha=opacity, linewidth=0)
    ax.add_patch(floor)
    border = Rectangle((x, y), 1, 1, fill=False, edgecolor=LIGHT["line"], linewidth=0.5)
    ax.add_patch(border)
    place, side = (0.5, "center") if text == UNTRIED else (0.94, "right")
    ax.text(x + place, y + 0.5, text, ha=side, va="center", fontsize=size)
