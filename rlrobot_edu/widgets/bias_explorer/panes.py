"""The bias of one state as HTML: the formulas of the paper's example with the numbers filled in, and bars."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

from rlrobot_edu.show.palette import BLUE, GREY
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.bias_explorer.marks import HERE, Mark, here
from rlrobot_edu.widgets.bias_explorer.states import state_text

STYLE = """<style>
.rl-bias { line-height: 1.6; font-variant-numeric: tabular-nums; }
.rl-bias table { border-collapse: collapse; width: auto; margin: 0 }
.rl-bias td, .rl-bias th { padding: 1px 10px 1px 0; text-align: left; vertical-align: top;
  background: none; border: 0; font-weight: normal }
.rl-bias td.number { text-align: right }
.rl-bias .name, .rl-bias th { white-space: nowrap }
.rl-bias th { border-bottom: 1px solid #7f7f7f }
.rl-bias h4 { margin: 8px 0 2px; font-size: 1.05em }
.rl-bias .bar { display: inline-block; height: 11px; margin-right: 6px }
.rl-bias .total td { border-top: 1px solid #7f7f7f }
.rl-choice { width: 205px; line-height: 1.45 }
</style>"""

SR_BAR = f"background: repeating-linear-gradient(135deg, {GREY} 0 3px, #c8c8c8 3px 6px)"
QBIASSR_BAR = f"background: {BLUE}"
BAR_PIXELS = 80  # length of the bar of a probability of 1


def two_decimals(x: float) -> str:
    """`x` with a true minus sign, which never stands before zero."""
    text = f"{x:.2f}"
    return "0.00" if float(text) == 0 else text.replace("-", "−")


def vector(x: np.ndarray) -> str:
    """One number an action: ``(1.00, −0.50, 0.00)``."""
    return f"({', '.join(two_decimals(value) for value in x)})"


def chip(mark: Mark, text: str = "") -> str:
    """A mark on its colour."""
    style = f"background:{mark.colour};color:{mark.ink};border-radius:3px;padding:0 5px;margin-right:3px"
    return f'<span style="{style}">{f"{escape(text)} {mark.sign}".strip()}</span>'


def legend_html(marks: dict[str, Mark], s: int) -> str:
    """What the colours and marks mean while state `s` is shown."""
    lines = ", ".join(f"{chip(mark)}{escape(name)}" for name, mark in marks.items())
    return (
        f'{STYLE}<div class="rl-bias">{chip(HERE, here(s))} is the state itself, a member of every set.<br>'
        f"The others share all inputs with it but one: {lines}.</div>"
    )


def formulas_html(
    task: Task, q: np.ndarray, numbers: BiasNumbers, marks: dict[str, Mark], actions: Sequence[str]
) -> str:
    """The means, their average and what is chosen from, as in the paper's example, numbers for the symbols."""
    rows = []
    for (name, states), mean in zip(numbers.sets.items(), numbers.means, strict=True):
        symbols = " + ".join(_bold_if(k == numbers.s, f"<i>Q</i>{escape(state_text(task, k))}") for k in states)
        values = " + ".join(_bold_if(k == numbers.s, _whole(q[k])) for k in states)
        n = len(states)
        bias_i = f"bias<sub>{escape(name)}</sub>(<i>s</i>)"
        rows.append(_equation(f"{chip(marks[name])} {bias_i}", f"1⁄{n} · [{symbols}]", f"1⁄{n} · [{values}]", mean))
    n = len(numbers.sets)
    symbols = " + ".join(f"{chip(marks[name])}bias<sub>{escape(name)}</sub>" for name in numbers.sets)
    values = " + ".join(_whole(mean) for mean in numbers.means)
    rows.append(
        _equation("<b>bias(<i>s</i>)</b>", f"1⁄{n} · [{symbols}]", f"1⁄{n} · [{values}]", numbers.bias, "total")
    )
    values = f"{_whole(numbers.q)} + {_whole(numbers.bias)}"
    rows.append(_equation("<i>Q</i>(<i>s</i>)<sub>biased</sub>", "<i>Q</i>(<i>s</i>) + bias(<i>s</i>)", values,
                          numbers.biased, "total"))  # fmt: skip
    return (
        f'{STYLE}<div class="rl-bias"><h4>The formulas, with the numbers of state {numbers.s}</h4>'
        f"In each ( ) one number an action: {escape(', '.join(actions))}. "
        f"Bold: the state itself, a member of every set.<table>{''.join(rows)}</table></div>"
    )


def choice_html(numbers: BiasNumbers, actions: Sequence[str], q_scale: float, temperature: float) -> str:
    """Softmax with and without the bias as pairs of bars, narrow enough to stand beside the states."""
    rows = "".join(
        f'<tr><td class="name" rowspan="2">{escape(name)}</td><td class="name">{_bar(numbers.sr[a], SR_BAR)}</td></tr>'
        f'<tr><td class="name">{_bar(numbers.qbiassr[a], QBIASSR_BAR)}</td></tr>'
        for a, name in enumerate(actions)
    )
    q_s, key = "<i>Q</i>(<i>s</i>)", '<span class="bar" style="width:20px;{}"></span>'
    return (
        f'{STYLE}<div class="rl-bias rl-choice"><b>What it does to the choice in state {numbers.s}</b>'
        f"<table>{rows}</table>{key.format(SR_BAR)}SR: softmax of {q_s} = {_whole(numbers.q)}<br>"
        f"{key.format(QBIASSR_BAR)}QBIASSR: softmax of {q_s} + bias(<i>s</i>) = {_whole(numbers.biased)}<br>"
        f"Both first multiply by 100⁄<i>Q</i><sub>max</sub> = {q_scale:g}; <i>T</i> = {temperature:g}.</div>"
    )


def _equation(left: str, symbols: str, values: str, result: np.ndarray, row: str = "") -> str:
    right = f"= {symbols}<br>= {values} = <b>{_whole(result)}</b>"
    return f'<tr class="{row}"><td class="name">{left}</td><td>{right}</td></tr>'


def _whole(x: np.ndarray) -> str:
    """A vector that is not broken at the end of a line."""
    return f'<span style="white-space:nowrap">{vector(x)}</span>'


def _bold_if(condition: bool, text: str) -> str:
    return f"<b>{text}</b>" if condition else text


def _bar(probability: float, style: str) -> str:
    width = round(BAR_PIXELS * float(probability))
    return f'<span class="bar" style="width:{width}px;{style}"></span>{100 * probability:.1f} %'
