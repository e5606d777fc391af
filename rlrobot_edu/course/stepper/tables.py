"""Q and the traces as tables of coloured numbers, in HTML; and which states and actions fit into them."""

from __future__ import annotations

import html
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import matplotlib
import numpy as np

from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import number, short
from rlrobot_edu.course.stepper.tape import Frame, Tape
from rlrobot_edu.learning.loop import Step

MOST_STATES, MOST_ACTIONS = 48, 9  # with more of them, the most recent BLOCK states and MOST_ACTIONS actions are shown
BLOCK = 12  # rows in one block; the next block stands beside it


class Window(NamedTuple):
    """The part of the tables that is shown: states (None is an empty row), actions, and both in words."""

    states: list[int | None]
    actions: list[int]
    says: str

    @classmethod
    def of(cls, tape: Tape) -> Window:
        """All states and actions if they fit, otherwise those of the latest steps."""
        n_states, n_actions = tape.q.shape
        states: list[int | None] = list(range(n_states))
        actions, says = list(range(n_actions)), []
        recent_states, recent_actions = tape.recent(BLOCK)
        if n_states > MOST_STATES:
            states = recent_states + [None] * (BLOCK - len(recent_states))
            says.append(f"the {BLOCK} states visited last, of {n_states}")
        if n_actions > MOST_ACTIONS:
            others = [a for a in range(n_actions) if a not in recent_actions]
            actions = sorted((recent_actions + others)[:MOST_ACTIONS])
            says.append(f"{MOST_ACTIONS} of {n_actions} actions, the latest among them")
        return cls(states, actions, "; ".join(says) or f"all {n_states} states")

    def blocks(self) -> list[list[int | None]]:
        """The states, cut into columns of equal length that stand side by side."""
        rows = -(-len(self.states) // -(-len(self.states) // BLOCK))
        return [self.states[i : i + rows] for i in range(0, len(self.states), rows)]


@cache
def shades() -> list[tuple[str, str]]:
    """The 256 colours of cividis, each with the lettering, black or white, that stands out better."""
    rgb = matplotlib.colormaps["cividis"](np.arange(256))[:, :3]
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    luminance = linear @ (0.2126, 0.7152, 0.0722)  # WCAG 2.1; black and white are equally good at 0.179
    text = np.where(luminance > 0.179, "#000", "#fff")
    return [(matplotlib.colors.to_hex(colour), str(ink)) for colour, ink in zip(rgb, text, strict=True)]


def q_range(q: np.ndarray) -> tuple[float, float]:
    """What the darkest and the lightest colour stand for; 0 is always between them."""
    return min(float(q.min()), 0.0), max(float(q.max()), 0.0)


def q_html(tape: Tape, window: Window, names: Names) -> str:
    """Q as a heatmap with numbers. What the step changed is framed and carries ▲ or ▼, (s, a) has a double frame."""
    (low, high), colours, frame = q_range(tape.q), shades(), tape.frame
    scale = 255 / (high - low) if high > low else 0.0
    rose = _changes(frame)
    pair = (frame.step.s, frame.step.a) if frame else None
    n_actions = tape.q.shape[1]

    def cell(s: int, a: int) -> str:
        value = float(tape.q[s, a])
        back, ink = colours[int((value - low) * scale)]
        sign, kind = "", ""
        if (s, a) == pair:
            kind = ' class="pair"'
        if (up := rose.get(s * n_actions + a)) is not None:
            sign, kind = f"<u>{'▲' if up else '▼'}</u>", kind or ' class="new"'
            kind += f' title="now {number(value)}"'
        return f'<td{kind} style="background:{back};color:{ink}">{sign}{short(value)}</td>'

    return _blocks(cell, window, names, frame.step if frame else None)


def traces_html(tape: Tape, window: Window, names: Names) -> str:
    """The traces in the same places, the paler the more they have faded."""

    def cell(s: int, a: int) -> str:
        e = float(tape.e[s, a])
        if e == 0.0:
            return "<td>·</td>"
        alpha = min(e, 1.0)
        ink = ";color:#000" if alpha > 0.62 else ""  # above that, black stands out on a dark page as well
        return f'<td style="background:rgba(230,159,0,{alpha:.2f}){ink}">{short(e)}</td>'

    return _blocks(cell, window, names, tape.frame.step if tape.frame else None)


def _changes(frame: Frame | None) -> dict[int, bool]:
    """For each entry of Q that the step changed, by its flat position: whether it rose."""
    if frame is None:
        return {}
    where, old, new = frame.q_change
    return dict(zip(where.tolist(), (new > old).tolist(), strict=True))


def _blocks(cell: Callable[[int, int], str], window: Window, names: Names, step: Step | None) -> str:
    """Tables of `cell(s, a)`, one for each block of states, side by side."""
    head = "".join(
        f'<th title="action {a}: {html.escape(names.action(a))}"{_mark(step and a == step.a)}>'
        f"{html.escape(names.column(a))}</th>"
        for a in window.actions
    )
    empty = "<tr><th>&nbsp;</th>" + "<td></td>" * len(window.actions) + "</tr>"
    tables = []
    for block in window.blocks():
        rows = []
        for s in block:
            if s is None:
                rows.append(empty)
                continue
            role = "s" if step and s == step.s else ""
            role += " s′" if step and s == step.s_next else ""
            label = f'<th title="{html.escape(names.state(s))}"{_mark(role)}><em>{role}</em> {s}</th>'
            rows.append(f"<tr>{label}{''.join(cell(s, a) for a in window.actions)}</tr>")
        tables.append(f"<table><tr><th></th>{head}</tr>{''.join(rows)}</table>")
    return f'<div class="blocks">{"".join(tables)}</div>'


def _mark(on: object) -> str:
    return ' class="on"' if on else ""
