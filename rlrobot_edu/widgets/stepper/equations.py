"""The update of each algorithm as an equation, with the numbers of one step in place of its symbols."""

from __future__ import annotations

import re
from string import Formatter
from typing import NamedTuple

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.widgets.stepper.numerals import given, number
from rlrobot_edu.widgets.stepper.symbols import VISITED, in_symbols
from rlrobot_edu.widgets.stepper.tape import Frame

GIVEN = ("α", "γ", "(1 − α)", "1", "r")  # numbers that are set, not computed
VALUE_OF_NEXT = re.compile(r"{([^}]*s′[^}]*)}")  # a symbol with s′, in its braces


class Term(NamedTuple):
    """A piece of an equation: a sign, or a number and its exact value."""

    text: str
    value: float | None = None


def explain_update(agent: Agent, frame: Frame) -> list[list[Term]]:
    """The update that `agent` made in the step of `frame`, line by line."""
    parameters = agent.parameters
    alpha = parameters.alpha
    algorithm = in_symbols(agent.method.algorithm.name, parameters)
    step = frame.step
    numbers = {
        "α": alpha,
        "(1 − α)": 1 - alpha,
        "γ": parameters.gamma,
        "1": 1.0,
        "r": step.r,
        "δ": step.delta,
        "Q(s, a)": frame.q_sa,
        "e(s, a)": frame.e_sa,
        "Q_old": frame.q_old,
        "change": frame.q_sa_new - frame.q_sa,
    }
    for symbol in VALUE_OF_NEXT.findall("".join(algorithm.equation)):
        numbers[symbol] = frame.q_next
    results = {"δ": step.delta, "Q(s, a)": frame.q_sa_new}
    if algorithm.trace:
        results["e(s, a)"] = VISITED[algorithm.trace](frame.e_sa, alpha)
    lines = []
    for line in algorithm.equation:
        left, sign, right = re.split(" ([←=]) ", line, maxsplit=1)
        pair = f"({step.s}, {step.a})"
        terms = _terms(right, numbers)
        result = results[left]
        if len(terms) > 1:
            terms += [Term("="), Term(number(result), result)]
        lines.append([Term(left.replace("(s, a)", pair)), Term(sign), *terms])
        numbers[left] = result  # later lines use the result of this one
    return lines


def as_text(line: list[Term]) -> str:
    """An equation with its numbers, as plain text."""
    texts = []
    for term in line:
        is_sign = term.text in "+−←="
        texts.append(f" {term.text} " if is_sign else term.text)
    return "".join(texts).strip()


def _terms(side: str, numbers: dict[str, float]) -> list[Term]:
    """The right side of an equation: its signs, and the number of each symbol in braces."""
    terms = []
    for signs, symbol, _, _ in Formatter().parse(side):
        terms += [Term(sign) for sign in signs.replace(" ", "")]
        if symbol:
            terms.append(Term(_text(symbol, numbers[symbol]), numbers[symbol]))
    return terms


def _text(symbol: str, x: float) -> str:
    """A number in place of its symbol; a computed one below 0 has brackets, because it may follow another sign."""
    if symbol in GIVEN:
        return given(x)
    return number(x) if x >= 0 else f"({number(x)})"
