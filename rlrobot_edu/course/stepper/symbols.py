"""The stepper's text for each algorithm: its update as an equation, and the traces it leaves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.parameters import Parameters

# The numbers of one step by their symbols: r, γ, α, (1 − α), δ, Q(s, a), e(s, a) and Q_old, as the update found them.
Numbers = Mapping[str, float]


class Symbols(NamedTuple):
    """An algorithm in symbols.

    next_value: function (Q(s'), a', probabilities in s') -> what the target takes for the value of s'
    equation: function (parameters) -> the update line by line; in braces stand the symbols of its numbers, of which the
        one with s′ is what `next_value` returns
    new_trace: of an algorithm with traces, function (parameters, numbers) -> e(s, a) once the pair was visited
    share: of an algorithm with traces, function (numbers) -> what any other pair learns for each unit of its trace
    """

    next_value: Callable[[np.ndarray, int, np.ndarray], float]
    equation: Callable[[Parameters], tuple[str, ...]]
    new_trace: Callable[[Parameters, Numbers], float] | None = None
    share: Callable[[Numbers], float] | None = None


def _taken(q_next: np.ndarray, a_next: int, p: np.ndarray) -> float:
    return float(q_next[a_next])


ALGORITHMS = {
    "Q": Symbols(
        next_value=lambda q_next, a_next, p: q_next.max(),
        equation=lambda parameters: ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{max Q(s′, ·)} − {Q(s, a)})",),
    ),
    "SARSA": Symbols(
        next_value=_taken,
        equation=lambda parameters: ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Q(s′, a′)} − {Q(s, a)})",),
    ),
    "ESARSA": Symbols(
        next_value=lambda q_next, a_next, p: q_next @ p,
        equation=lambda parameters: ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Σ π(a′|s′) Q(s′, a′)} − {Q(s, a)})",),
    ),
    "SL": Symbols(
        next_value=_taken,
        equation=lambda parameters: (
            "δ = {r} + {γ}·{Q(s′, a′)} − {Q(s, a)}",
            "e(s, a) ← {e(s, a)} + {1}" if parameters.accumulating else "e(s, a) ← {1}",
            "Q(s, a) ← {Q(s, a)} + {α}·{δ}·{e(s, a)}",
        ),
        new_trace=lambda parameters, n: n["e(s, a)"] + 1.0 if parameters.accumulating else 1.0,
        share=lambda n: n["α"] * n["δ"],
    ),
    "TOSL": Symbols(
        next_value=_taken,
        equation=lambda parameters: (
            "δ = {r} + {γ}·{Q(s′, a′)} − {Q(s, a)}",
            "e(s, a) ← {(1 − α)}·{e(s, a)} + {1}",
            "Q(s, a) ← {Q(s, a)} + {α}·({δ} + {Q(s, a)} − {Q_old})·{e(s, a)} − {α}·({Q(s, a)} − {Q_old})",
        ),
        new_trace=lambda parameters, n: n["(1 − α)"] * n["e(s, a)"] + 1.0,
        share=lambda n: n["α"] * (n["δ"] + n["Q(s, a)"] - n["Q_old"]),
    ),
}
# An algorithm of the learner's own: what came of it, since nobody has said how.
OWN = Symbols(next_value=_taken, equation=lambda parameters: ("δ = {δ}", "Q(s, a) ← {Q(s, a)} + {change}"))


def in_symbols(agent: Agent) -> Symbols:
    """The equation and the traces of the algorithm of `agent`."""
    return ALGORITHMS.get(agent.algorithm, OWN)
