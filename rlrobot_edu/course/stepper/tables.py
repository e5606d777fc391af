"""Q and the traces as tables of coloured numbers, in HTML; and which states and actions fit into them."""

from __future__ import annotations

import html
from collections.abc import Callable, Collection
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from rlrobot_edu.course.stepper.colours import css, largest, tint, trace_tint
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number, short
from rlrobot_edu.course.stepper.tape import Frame, Tape
from rlrobot_edu.learning.loop import Step

MOST_STATES, MOST_ACTIONS = 48, 9  # with more of them, the most recent BLOCK states and MOST_ACTIONS actions are shown
FAINTEST_FRAME = 0.35  # opacity of the frame around the smallest changes
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
        if n_states <= MOST_STATES and n_actions <= MOST_ACTIONS:
            return cls(states, actions, f"all {n_states} states")
        recent_states, recent_actions = tape.recent(BLOCK)
        if n_states > MOST_STATES:
            states = recent_states + [None] * (BLOCK - len(recent_states))
            says.append(f"the {BLOCK} states visited last, of {n_states}")
        if n_actions > MOST_ACTIONS:
            # what the update took for the value of s′ is always shown
            step, best = (tape.frame.step, tape.frame.best) if tape.frame else (None, 0)
            follows = [step.a, best if step.a_next is None else step.a_next, best] if step else []
            latest = list(dict.fromkeys([*follows, *recent_actions, *actions]))
            actions = sorted(latest[:MOST_ACTIONS])
            says.append(f"{MOST_ACTIONS} of {n_actions} actions, the latest among them")
        return cls(states, actions, "; ".join(says) or f"all {n_states} states")

    def blocks(self) -> list[list[int | None]]:
        """The states, cut into columns of equal length that stand side by side."""
        rows = -(-len(self.states) // -(-len(self.states) // BLOCK))
        return [self.states[i : i + rows] for i in range(0, len(self.states), rows)]


def q_html(tape: Tape, window: Window, names: Names, points_at: Collection[tuple[int, int]] = ()) -> str:
    """Q as a heatmap with numbers, a dot where nothing was tried. What the step changed is framed: ▲ 38.0 → 48.5.

    The frame is the stronger the more the number changed, beside the largest change of this step.

    points_at: the pairs whose value the update took for what follows; a term of the equation points at them
    """
    most, frame = largest(tape.q, tape.agent.parameters.r_max), tape.frame
    old, most_changed = _changes(frame)
    pair = (frame.step.s, frame.step.a) if frame else None
    n_actions = tape.q.shape[1]

    def cell(s: int, a: int) -> str:
        value, kinds, sign, title, frame_strength = float(tape.q[s, a]), [], "", "", ""
        if (was := old.get(s * n_actions + a)) is not None:
            sign = f"<u>{'▲' if value > was else '▼'}</u><small>{short(was)} → </small>"
            title = f' title="by {number(value - was)}"'
            frame_strength = f";--strength:{max(FAINTEST_FRAME, abs(value - was) / most_changed):.1f}"
            kinds.append("new")
        kinds += ["pair"] * ((s, a) == pair) + ["next"] * ((s, a) in points_at)
        if not value and not tape.visits[s, a]:
            return f'<td class="{" ".join(["dot", *kinds])}">·</td>'
        kind = f' class="{" ".join(kinds)}"' if kinds else ""
        return (
            f'<td{kind}{title} style="background:{css(*tint(value, most))}{frame_strength}">{sign}{short(value)}</td>'
        )

    return _blocks(cell, window, names, frame.step if frame else None)


def scale_html(most: float) -> str:
    """What the colours mean."""
    steps = (-1.0, -0.2, -0.02, 0.0, 0.02, 0.2, 1.0)
    swatches = "".join(f'<b style="background:{css(*tint(x * most, most))}">{given(x * most)}</b>' for x in steps)
    return f'<span class="scale">{swatches}</span>'


def traces_html(tape: Tape, window: Window, names: Names) -> str:
    """The traces by which the update learned, in the same places; a weaker trace has a paler colour."""
    frame, n_actions = tape.frame, tape.q.shape[1]
    traces = traces_of(frame)
    pair = frame.step.s * n_actions + frame.step.a if frame else None

    def cell(s: int, a: int) -> str:
        where = s * n_actions + a
        e = traces.get(where, 0.0)
        if e == 0.0:
            return '<td class="dot">·</td>'
        kind = ' class="pair"' if where == pair else ""
        return f'<td{kind} style="background:{css(*trace_tint(e))}">{short(e)}</td>'

    return _blocks(cell, window, names, frame.step if frame else None)


def traces_of(frame: Frame | None) -> dict[int, float]:
    """The traces of a step by their flat positions."""
    return {} if frame is None else dict(zip(*(values.tolist() for values in frame.traces), strict=True))


def _changes(frame: Frame | None) -> tuple[dict[int, float], float]:
    """What each entry of Q that the step changed was before, by its flat position; and the largest change."""
    if frame is None:
        return {}, 0.0
    where, old, new = frame.q_change
    return dict(zip(where.tolist(), old.tolist(), strict=True)), float(np.abs(new - old).max(initial=0.0))


def _blocks(cell: Callable[[int, int], str], window: Window, names: Names, step: Step | None) -> str:
    """Tables of `cell(s, a)`, one for each block of states, side by side."""
    head = "".join(
        f'<th title="action {a}: {_escaped(names.action(a))}"{_mark(step and a == step.a)}>'
        f"{_escaped(names.column(a))}</th>"
        for a in window.actions
    )
    empty = f'<tr class="empty"><td colspan="{len(window.actions) + 1}">&nbsp;</td></tr>'
    tables = []
    for block in window.blocks():
        rows = []
        for s in block:
            if s is None:
                rows.append(empty)
                continue
            role = "s" if step and s == step.s else ""
            role += " s′" if step and s == step.s_next else ""
            label = f'<th title="{_escaped(names.state(s))}"{_mark(role)}><em>{role}</em> {s}</th>'
            rows.append(f"<tr>{label}{''.join(cell(s, a) for a in window.actions)}</tr>")
        tables.append(f"<table><tr><th>state</th>{head}</tr>{''.join(rows)}</table>")
    return f'<div class="blocks">{"".join(tables)}</div>'


_escaped = lru_cache(4096)(html.escape)


def _mark(on: object) -> str:
    return ' class="on"' if on else ""
