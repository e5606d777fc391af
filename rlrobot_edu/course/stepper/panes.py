"""The panes of the stepper in HTML: environment, choice, update, code, Q and traces, each with a heading in words."""

from __future__ import annotations

import html

from rlrobot_edu.course.stepper.code_view import code_html
from rlrobot_edu.course.stepper.equations import Term, Update, explain_update
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number
from rlrobot_edu.course.stepper.tables import Window, q_html, q_range, traces_html
from rlrobot_edu.course.stepper.tape import EnvironmentView, Frame, Tape
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.methods import SELECTIONS


def happened(frame: Frame | None, names: Names) -> str:
    """The step in one sentence."""
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
    return f"{text}, where it will take a′ = {_named(step.a_next, names)}."


def view_html(tape: Tape, names: Names, view: EnvironmentView) -> str:
    """Everything that there is to see at the position of `tape`."""
    agent, frame, window = tape.agent, tape.frame, Window.of(tape)
    low, high = q_range(tape.q)
    columns = f"Columns: actions ({html.escape(names.outputs)}). " if names.outputs else "Columns: actions. "
    where, code = code_html(agent)
    begins = frame is not None and frame.number == 1
    ends = frame is not None and (frame.step.terminated or frame.step.truncated)
    badge = '<span class="badge">episode begins</span>' * begins + '<span class="badge">episode ends</span>' * ends
    return "".join([
        f'<p class="said">{html.escape(happened(frame, names))} {badge}</p><div class="top"><div class="left">',
        _pane("world", view.heading, view.html(tape.looks())),
        _pane("choice", _choice_heading(agent, frame), _choice(agent, frame, window, names)),
        '</div><div class="right">',
        _pane("update", "The update, with the numbers of this step", _update(agent, frame)),
        _pane("code", f"Code (▶ changes Q): {html.escape(where)}", code),
        '</div></div><div class="tables">',
        _pane("q", f"Q: {window.says}", q_html(tape, window, names),
              f"{columns}From {number(low)} (dark) to {number(high)} (light). Framed: changed by this step, "
              "▲ up, ▼ down; double frame: (s, a)."),
        _pane("traces", "Traces e, after they faded", traces_html(tape, window, names),
              "How much each pair will share in what is learned next.") if agent.keeps_traces else "",
        "</div>",
        "" if agent.keeps_traces else
        f"<p class=note>{html.escape(agent.algorithm)} keeps no traces: only Q(s, a) changes.</p>",
    ])  # fmt: skip


def _named(a: int, names: Names) -> str:
    short = names.action(a)
    return str(a) if short == str(a) else f"{a} ({short})"


def _pane(kind: str, heading: str, content: str, note: str = "") -> str:
    note = f'<p class="note">{note}</p>' if note else ""
    return f'<section class="{kind}"><h4>{heading}</h4>{content}{note}</section>'


def _choice_heading(agent: Agent, frame: Frame | None) -> str:
    if frame is None:
        return "How the action is chosen"
    is_softmax = SELECTIONS[agent.selection].is_softmax
    heat = f", temperature {given(frame.step.temperature)}" if is_softmax else ""
    return f"Choice in s = {frame.step.s}{heat}"


def _choice(agent: Agent, frame: Frame | None, window: Window, names: Names) -> str:
    """Bars with numbers, the chosen one marked; with QBIASSR also the bias of each action."""
    biased = agent.bias is not None
    rows = [f"<tr><th>a</th><th></th><th>p</th>{'<th>bias</th>' if biased else ''}</tr>"]
    for a in window.actions:
        p = float(frame.step.probabilities[a]) if frame else 0.0
        share = f"{p:.3f}" if frame else ""
        chosen = frame is not None and a == frame.step.a
        bias = f"<td>{number(float(frame.step.bias[a])) if frame else ''}</td>" if biased else ""
        rows.append(
            f"<tr{' class=on' if chosen else ''}><th>{'▶ ' if chosen else ''}{html.escape(names.row(a))}</th>"
            f'<td class="bar"><b style="width:{100 * p:.1f}%"></b></td><td>{share}</td>{bias}</tr>'
        )
    note = ""
    if frame is not None and len(window.actions) < len(frame.step.probabilities):
        rest = max(0.0, 1 - sum(float(frame.step.probabilities[a]) for a in window.actions))
        note = f'<p class="note">all other actions together: {rest:.3f}</p>'
    return f"<table>{''.join(rows)}</table>{note}"


def _update(agent: Agent, frame: Frame | None) -> str:
    if frame is None:
        return '<p class="note">Press Step: the agent acts, and learns from what happens.</p>'
    update: Update = explain_update(agent, frame)
    tables = []
    for line in update.lines:
        above = "".join(f"<td>{_symbol(term.symbol)}</td>" for term in line)
        below = "".join(f"<td{_about(term)}>{html.escape(term.text)}</td>" for term in line)
        tables.append(f"<table><tr>{above}</tr><tr>{below}</tr></table>")
    error = f"TD error δ = {number(frame.step.delta)}. " if len(update.lines) == 1 else ""
    return f'{"".join(tables)}<p class="note">{error}{html.escape(update.note)}</p>'


def _about(term: Term) -> str:
    """Room around a sign, the exact value for the mouse."""
    if term.value is not None:
        return f' title="{term.value!r}"'
    return ' class="sign"' if term.text in "+−←=" else ""


def _symbol(symbol: str) -> str:
    return html.escape(symbol).replace("Q_old", "Q<sub>old</sub>")
