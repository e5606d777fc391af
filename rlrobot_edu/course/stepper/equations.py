"""The update of each algorithm as an equation, with the symbols above and the numbers of one step below."""

from __future__ import annotations

from typing import NamedTuple

from rlrobot_edu.course.stepper.numerals import given, number
from rlrobot_edu.course.stepper.tape import Frame
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.methods import SARSA, SL, Q


class Term(NamedTuple):
    """A piece of an equation: its symbol, what stands below it, and the exact value where that is rounded."""

    symbol: str
    text: str
    value: float | None = None


class Update(NamedTuple):
    """The equations of one step, line by line, and what else there is to say about it."""

    lines: list[list[Term]]
    note: str

    def text(self) -> list[str]:
        """Each line with its numbers, as plain text."""
        return ["".join(f" {t.text} " if t.text in "+−←=" else t.text for t in line).strip() for line in self.lines]


def explain_update(agent: Agent, frame: Frame) -> Update:
    """The update that `agent` made in the step of `frame` (paper equations 2 to 7; van Seijen & Sutton 2014)."""
    parameters = agent.memory.parameters
    alpha, gamma, lam = (float(parameters[name]) for name in ("alpha", "gamma", "lam"))
    step, algorithm = frame.step, parameters.algorithm
    following = "max Q(s′, ·)" if algorithm == Q else "Q(s′, a′)"
    td_error = [
        Term("r", given(step.r), step.r), *_signs("+"), Term("γ", given(gamma), gamma), *_signs("·"),
        _value(following, frame.q_next), *_signs("−"), _value("Q(s, a)", frame.q_sa),
    ]  # fmt: skip
    q_sa, e_name = _value("Q(s, a)", frame.q_sa), f"e({step.s}, {step.a})"
    learn = [
        Term("Q(s, a)", f"Q({step.s}, {step.a})"),
        *_signs("←"),
        q_sa,
        *_signs("+"),
        Term("α", given(alpha), alpha),
    ]
    if algorithm in (Q, SARSA):
        return Update([[*learn, *_signs("·("), *td_error, *_signs(")"), *_is(frame.q_sa_new)]], _note(frame, ""))

    delta = _value("δ", step.delta)
    lines = [[Term("δ", "δ"), *_signs("="), *td_error, *_is(step.delta)]]
    if algorithm == SL:
        e, trace = 1.0, [Term("1", "1", 1.0)]
        if parameters.accumulating:
            e = frame.e_sa + 1.0
            trace = [_value("e(s, a)", frame.e_sa), *_signs("+"), Term("1", "1", 1.0), *_is(e)]
        share = alpha * step.delta
        rest = [*_signs("·"), delta, *_signs("·"), _value("e(s, a)", e)]
    else:
        e = (1.0 - alpha) * frame.e_sa + 1.0
        trace = [Term("(1 − α)", given(1 - alpha), 1 - alpha), *_signs("·"), _value("e(s, a)", frame.e_sa),
                 *_signs("+"), Term("1", "1", 1.0), *_is(e)]  # fmt: skip
        q_old = _value("Q_old", frame.q_old)
        share = alpha * (step.delta + frame.q_sa - frame.q_old)
        rest = [*_signs("·("), delta, *_signs("+"), q_sa, *_signs("−"), q_old, *_signs(")·"), _value("e(s, a)", e),
                *_signs("−"), Term("α", given(alpha), alpha), *_signs("·("), q_sa, *_signs("−"), q_old,
                *_signs(")")]  # fmt: skip
    lines.append([Term("e(s, a)", e_name), *_signs("←"), *trace])
    lines.append([*learn, *rest, *_is(frame.q_sa_new)])
    usual = f"Every other pair with a trace changes by {number(share)}·e. Then all traces fade to {gamma * lam:.3g}·e."
    return Update(lines, _note(frame, usual))


def _value(symbol: str, x: float) -> Term:
    """A computed number; in brackets where its sign would follow another one."""
    return Term(symbol, number(x) if x >= 0 else f"({number(x)})", x)


def _signs(signs: str) -> list[Term]:
    return [Term(sign, sign) for sign in signs]


def _is(x: float) -> list[Term]:
    """The result, which stands below only: above, the symbols end."""
    return [Term("", "="), Term("", number(x), x)]


def _note(frame: Frame, usual: str) -> str:
    if frame.step.terminated:
        return f"Terminal: nothing follows s′, so its value counts as 0. {usual}"
    if frame.step.truncated:
        return f"Time is up, but the world would go on: the value of s′ counts. {usual}"
    return usual
