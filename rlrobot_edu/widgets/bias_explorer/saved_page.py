"""The bias explorer as one HTML page, which needs no kernel: a view for each state and each table."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from pathlib import Path

import numpy as np

from rlrobot_edu.show.pages.page import save_page
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers, bias_numbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark, here
from rlrobot_edu.widgets.bias_explorer.panes import chip, choice_html, formulas_html, legend_html, two_decimals, vector
from rlrobot_edu.widgets.bias_explorer.states import (
    block_text,
    blocks_of,
    inputs_text,
    place_of,
    state_text,
    state_words,
    value_text,
)

STYLE = """<style>
.rl-top { display: flex; flex-wrap: wrap; gap: 0 24px; align-items: flex-start; margin-bottom: 8px }
.rl-states { display: grid; gap: 4px; width: min-content; max-width: 100% }
.rl-states div { border: 1px solid #7f7f7f; padding: 0 4px 4px }
.rl-states button { font-size: 12px; width: 44px; min-height: 24px; padding: 0; border: 1px solid #7f7f7f;
  border-radius: 2px; background: none; color: inherit; cursor: pointer }
.rl-states button[aria-pressed=true] { font-weight: bold }
.rl-states button:focus-visible { outline: 3px solid; outline-offset: 1px }
.rl-states + .rl-bias { max-width: 420px; margin-top: 6px }
.rl-top table { border-spacing: 2px; font-size: 12px; font-variant-numeric: tabular-nums }
.rl-top th { font-weight: normal; text-align: right; white-space: nowrap }
.rl-members td { text-align: right; padding-left: 10px }
.rl-members th:first-child { text-align: left }
.rl-top .rl-members th + th { white-space: normal }
.rl-top .rl-choice { width: min-content; min-width: 205px }
.rl-bias { overflow-wrap: anywhere }
.rl-top [role=region] { max-width: 100%; overflow-x: auto }
@media (max-width: 700px) { .rl-bias span { white-space: normal !important } }
</style>"""


def save_states(
    path: str | Path,
    task: Task,
    tables: Mapping[str, np.ndarray],
    scales: Mapping[str, float],
    marks: dict[str, Mark],
    actions: Sequence[str],
    state: int,
    temperature: float,
) -> None:
    """Write a page that shows `state` first; the arguments are those of the explorer."""
    views = []
    for name, q in tables.items():
        for s in range(task.states.n):
            numbers = bias_numbers(task, q, s, scales[name], temperature)
            top = (
                f"<div>{states_html(task, numbers, marks)}{legend_html(marks, s)}</div>"
                f"{choice_html(numbers, actions, scales[name], temperature)}"
                '<div role="region" aria-label="Q of the states that have a say">'
                f"{members_html(task, q, numbers, marks, actions)}</div>"
            )
            said = f"State {s} ({state_words(task, s)}): bias {vector(numbers.bias)} for {', '.join(actions)}."
            views.append(
                f'<p class="said"><span>{escape(said)}</span></p><div class="rl-top">{top}</div>'
                f"{formulas_html(task, q, numbers, marks, actions)}"
            )
    below = "<p>The values of Q are those that were saved; to edit them, open the explorer in a notebook.</p>"
    save_page(path, f"Who has a say in the choice: the bias in {task.name}", views, unit="state", at=state,
              tables=list(tables), style=STYLE, below=below)  # fmt: skip


def states_html(task: Task, numbers: BiasNumbers, marks: dict[str, Mark]) -> str:
    """All states as buttons in their blocks; those that have a say carry the colour and the mark of their input."""
    names = dict(numbers.members)

    def button(s: int) -> str:
        words = f'value="{s}" title="state {s}: {escape(state_words(task, s))}"'
        if s not in names:
            return f"<button {words}>{s}</button>"
        mark, label = (HERE, here(s)) if s == numbers.s else (marks[names[s]], f"{s} {marks[names[s]].sign}")
        pressed = ' aria-pressed="true"' * (s == numbers.s)
        return f'<button {words}{pressed} style="background:{mark.colour};color:{mark.ink}">{label}</button>'

    blocks = blocks_of(task)
    highest = max(row for _, row in blocks)
    return '<div class="rl-states" role="group" aria-label="The states: click one">{}</div>'.format(
        "".join(
            f'<div style="grid-area:{highest - row + 1}/{column + 1}"><b>{escape(block_text(task, states[0]))}</b>'
            f"<table>{''.join(_rows(task, states, button))}</table></div>"
            for (column, row), states in blocks.items()
        )
    )


def _rows(task: Task, states: Sequence[int], button: Callable[[int], str]) -> Iterator[str]:
    """A column for each value of the last input but one, a row for each of the last."""
    *_, last = inputs = task.inputs
    if len(inputs) > 1:
        tops = [value_text(inputs[-2].decode(i)) for i in range(inputs[-2].n_bins)]
        tops[0] = f"{inputs[-2].name} {tops[0]}"
        yield f"<tr><td></td>{''.join(f'<th>{escape(top)}</th>' for top in tops)}</tr>"
    for row in range(last.n_bins):
        cells = "".join(f"<td>{button(s)}</td>" for s in states if place_of(task, s).row == row)
        yield f"<tr><th>{escape(last.name)} {escape(value_text(last.decode(row)))}</th>{cells}</tr>"


def members_html(
    task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]
) -> str:
    """A row for each state that has a say: what it has learned of each action."""
    head = "".join(f"<th>{escape(name)}</th>" for name in (f"state {inputs_text(task)}", *actions))
    rows = (
        f"<tr><th>{chip(HERE if name is None else marks[name], str(s))}{escape(state_text(task, s))}</th>"
        f"{''.join(f'<td>{two_decimals(value)}</td>' for value in q[s])}</tr>"
        for s, name in numbers.members
    )
    return f'<b>Q of the states that have a say</b><table class="rl-members"><tr>{head}</tr>{"".join(rows)}</table>'
