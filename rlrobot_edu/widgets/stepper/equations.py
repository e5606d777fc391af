"""The update of each algorithm as an equation, with the numbers of one step in place of its symbols."""

from __future__ import annotations

import re
from string import Formatter
from typing import NamedTuple

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.widgets.stepper.numerals import given, number
from rlrobot_edu.widgets.stepper.symbols import VISITED, in_symbols
from rlrobot_edu.widgets.stepper.tape import Frame

GIVEN = (
    "α",
    "γ",
    "(1 − α)",
    "1",
    "r",
)  # numbers that somebody set; all others are computed


class Term(NamedTuple):
    """A piece of an equation: a sign, or a number and its exact value."""

    text: str
    value: float | None = None


def explain_update(agent: Agent, frame: Frame) -> list[list[Term]]:
    """The update that `agent` made in the step of `frame`, as its algorithm says it, line by line."""
    algorithm, parameters, step = (
        in_symbols(agent.method.algorithm.name),
        agent.parameters,
        frame.step,
    )
    equation = algorithm.equation(parameters)
    alpha = parameters.alpha
    numbers = {
        "α": alpha, "(1 − α)": 1 - alpha, "γ": parameters.gamma, "1": 1.0, "r": step.r, "δ": step.delta,
        "Q(s, a)": frame.q_sa, "e(s, a)": frame.e_sa, "Q_old": frame.q_old, "change": frame.q_sa_new - frame.q_sa,
    }  # fmt: skip
    numbers |= {
        symbol: frame.q_next
        for symbol in re.findall(r"{([^}]*s′[^}]*)}", "".join(equation))
    }
    results = {"δ": step.delta, "Q(s, a)": frame.q_sa_new}
    if trace := algorithm.trace(parameters):
        results["e(s, a)"] = VISITED[trace](frame.e_sa, alpha)
    lines = []
    for line in equation:
        left, sign, right = re.split(" ([←=]) ", line, maxsplit=1)
        terms = _terms(right, numbers)
        result = (
            [Term("="), Term(number(results[left]), results[left])]
            if len(terms) > 1
            else []
        )
        left_side = Term(left.replace("(s, a)", f"({step.s}, {step.a})"))
        lines.append([left_side, Term(sign), *terms, *result])
        numbers[left] = results[left]  # what a line has set, the next one takes
    return lines


def as_text(line: list[Term]) -> str:
    """An equation with its numbers, as plain text."""
    return "".join(f" {t.text} " if t.text in "+−←=" else t.text for t in line).strip()


def _terms(side: str, numbers: dict[str, float]) -> list[Term]:
    """The right side of an equation: its signs, and each number in braces for its symbol."""
    terms = []
    for signs, symbol, _, _ in Formatter().parse(side):
        terms += [Term(sign) for sign in signs.replace(" ", "")]
        if symbol:
            terms.append(Term(_text(symbol, numbers[symbol]), numbers[symbol]))
    return terms


def _text(symbol: str, x: float) -> str:
    """A number below its symbol; a computed one in brackets where its sign would follow another one."""
    if symbol in GIVEN:
        return given(x)
    return number(x) if x >= 0 else f"({number(x)})"
