"""The panes of the stepper in HTML: environment, choice, update, code, Q and traces, each with a heading in words."""

from __future__ import annotations

import html
from collections.abc import Collection

from rlrobot_edu.course.stepper.code_view import code_html
from rlrobot_edu.course.stepper.colours import css, largest, tint, trace_tint
from rlrobot_edu.course.stepper.equations import Term, Update, explain_update
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number
from rlrobot_edu.course.stepper.symbols import in_symbols
from rlrobot_edu.course.stepper.tables import Window, q_html, scale_html, traces_html
from rlrobot_edu.course.stepper.tape import EnvironmentView, Frame, Tape
from rlrobot_edu.learning.agent import Agent

REWARDS = 10  # the latest ones
HIDDEN = ("a_next",)


def what_to_hide(hide: Collection[str]) -> tuple[str, ...]:
    """The names in `hide`, which may be one alone. Raises ValueError if there is no such thing to hide."""
    names = (hide,) if isinstance(hide, str) else tuple(hide)
    if unknown := set(names).difference(HIDDEN):
        raise ValueError(f"a Stepper can hide {', '.join(HIDDEN)}, got hide={sorted(map(str, unknown))!s:.200}")
    return names


def happened(frame: Frame | None, names: Names, follows: str = "") -> str:
    """The step in one sentence. `follows`: how to tell a′; by default it is left out."""
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
    return f"{text}, where it will take a′ = {follows}." if follows else f"{text}."


def told(tape: Tape, names: Names, hide: Collection[str] = ()) -> str:
    """The step in one sentence, with a′ if the update of this algorithm learns from it and nobody hides it."""
    frame, tells = tape.frame, _takes_a_next(tape) and "a_next" not in hide
    return happened(frame, names, _named(frame.step.a_next, names) if frame and tells else "")


def view_html(tape: Tape, names: Names, view: EnvironmentView, hide: Collection[str] = ()) -> str:
    """Everything that there is to see at the position of `tape`; `hide`: what stays covered until it is clicked."""
    agent, frame, window = tape.agent, tape.frame, Window.of(tape)
    said = f"<span>{html.escape(told(tape, names, hide))}</span>"
    if (covered := "a_next" in hide) and frame and _takes_a_next(tape):
        answer = html.escape(_named(frame.step.a_next, names))
        said += f" <details><summary>Show a′</summary> = {answer}</details>"
    columns = f"Columns: actions ({html.escape(names.outputs)}). " if names.outputs else "Columns: actions. "
    begins = frame is not None and frame.number == 1
    ends = frame is not None and (frame.step.terminated or frame.step.truncated)
    badge = '<span class="badge">episode begins</span>' * begins + '<span class="badge">episode ends</span>' * ends
    most = largest(tape.q, agent.parameters.r_max)
    points_at = () if covered else _follows(tape)
    world = _pane("world", view.heading, view.html(tape) + _rewards(tape, most))
    choice = _pane("choice", _choice_heading(agent, frame), _choice(agent, frame, window, names))
    update = _pane("update", "The update, with the numbers of this step", _update(agent, frame, most))
    q = _pane("q", f"Q: {window.says}", q_html(tape, window, names, points_at),
              f"{columns}{scale_html(most)} · never tried. Framed: changed by this step, ▲ up, ▼ down, old → new; "
              "double frame: (s, a).")  # fmt: skip
    traces = (
        _pane("traces", "Traces e, as this update used them", traces_html(tape, window, names),
              "How much each pair shares in what is learned in this step.")
        if agent.made_of.algorithm.has_traces
        else f"<p class=note>{html.escape(agent.algorithm)} keeps no traces: only Q(s, a) changes.</p>"
    )  # fmt: skip
    # three beats: world, equation, table; a wide world is low, and leaves room below itself
    left, right = ((world, update, choice), (q, traces)) if view.wide else ((world, choice), (update, q, traces))
    return (
        f'<div class="said">{said} {badge}</div><div class="panes{" wide" if view.wide else ""}">'
        f'<div class="left">{"".join(left)}</div><div class="right">{"".join(right)}</div></div>'
    )


def code_pane(agent: Agent) -> str:
    """The source of the update, folded; it stays as it is while the view changes."""
    where, code = code_html(agent)
    summary = f"<summary>Code of the update (▶ changes Q): {html.escape(where)}</summary>"
    return f'<div class="rl-view"><details class="code">{summary}{code}</details></div>'


def _takes_a_next(tape: Tape) -> bool:
    """Whether an action follows the step shown, and the update takes its value."""
    step = tape.frame.step if tape.frame else None
    return step is not None and not step.terminated and not step.truncated and "{Q(s′, a′)}" in _equation(tape)


def _equation(tape: Tape) -> str:
    return "".join(in_symbols(tape.agent).equation(tape.agent.parameters))


def _follows(tape: Tape) -> list[tuple[int, int]]:
    """The pairs whose value the update took for what follows: (s′, a′), the best one, or all of s′."""
    frame = tape.frame
    if frame is None or frame.step.terminated:
        return []
    step, equation = frame.step, _equation(tape)
    if "{Q(s′, a′)}" in equation:
        return [(step.s_next, step.a_next)]
    return [(step.s_next, a) for a in ([frame.best] if "max" in equation else range(tape.q.shape[1]))]


def _rewards(tape: Tape, most: float) -> str:
    """A line of the latest rewards, the present one last; a bar where an episode begins."""
    chips = "".join(
        f'{"<i>|</i>" * (frame.number == 1)}<b style="background:{css(*tint(frame.step.r, most))}">'
        f"{given(frame.step.r)}</b>"
        for frame in tape.latest(REWARDS)
    )
    return f'<p class="rewards" title="The latest rewards; | an episode begins">r: {chips}</p>'


def _named(a: int, names: Names) -> str:
    short = names.action(a)
    return str(a) if short == str(a) else f"{a} ({short})"


def _pane(kind: str, heading: str, content: str, note: str = "") -> str:
    note = f'<p class="note">{note}</p>' if note else ""
    return f'<section class="{kind}"><h4>{heading}</h4>{content}{note}</section>'


def _choice_heading(agent: Agent, frame: Frame | None) -> str:
    if frame is None:
        return "How the action is chosen"
    is_softmax = agent.made_of.selection.is_softmax
    heat = f", temperature T = {given(frame.step.temperature)}" if is_softmax else ""
    return f"Choice in state {frame.step.s}{heat}"


def _choice(agent: Agent, frame: Frame | None, window: Window, names: Names) -> str:
    """Bars with numbers, the chosen one marked; with a biased selection also the bias of each action."""
    biased = agent.bias is not None
    rows = [f"<tr><th>a</th><th colspan=2>p</th>{'<th>bias</th>' if biased else ''}</tr>"]
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


def _update(agent: Agent, frame: Frame | None, most: float) -> str:
    if frame is None:
        return '<p class="note">Press Step: the agent acts, and learns from what happens.</p>'
    update: Update = explain_update(agent, frame)
    lines = []
    for line, text in zip(update.lines, update.text(), strict=True):
        pieces = [_term(term, most) for term in line]
        terms = f"{''.join(pieces[:-2])}<nobr>{''.join(pieces[-2:])}</nobr>"
        lines.append(f'<div class="line" role="math" aria-label="{html.escape(text)}">{terms}</div>')
    error = f"TD error δ = {number(frame.step.delta)}. " if len(update.lines) == 1 else ""
    return f'{"".join(lines)}<p class="note">{error}{html.escape(update.note)}</p>'


def _term(term: Term, most: float) -> str:
    """A symbol above its number in the colour of its cell, the exact value for the mouse; it knows where it points."""
    kind = "sign" if term.text in "+−←=" else f"to-{term.points_at}" if term.points_at else ""
    about = f' class="{kind}"' * bool(kind) + (f' title="{term.value!r}"' if term.value is not None else "")
    if term.points_at and term.value is not None:
        about += f' style="background:{css(*_tint(term.points_at, term.value, most))}"'
    return f"<span{about}><i>{_symbol(term.symbol)}</i><b>{html.escape(term.text)}</b></span>"


def _tint(points_at: str, value: float, most: float) -> tuple[str, float]:
    return trace_tint(value) if points_at == "trace" else tint(value, most)


def _symbol(symbol: str) -> str:
    return html.escape(symbol).replace("Q_old", "Q<sub>old</sub>")
