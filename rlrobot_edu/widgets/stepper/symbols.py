"""The stepper's text for each algorithm: its update as an equation, and the traces it leaves."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from rlrobot_edu.learning.parameters import Parameters


def _taken(q_next: np.ndarray, a_next: int, p: np.ndarray) -> float:
    return float(q_next[a_next])


def _best(q_next: np.ndarray, a_next: int, p: np.ndarray) -> float:
    return float(q_next.max())


def _mean(q_next: np.ndarray, a_next: int, p: np.ndarray) -> float:
    return float(q_next @ p)


# What an update takes for the value of s′: of Q(s′), the action a′ that was chosen, and the probabilities in s′.
NEXT: dict[str, Callable[[np.ndarray, int, np.ndarray], float]] = {
    "taken": _taken,
    "best": _best,
    "mean": _mean,
}


def _accumulated(e: float, alpha: float) -> float:
    return e + 1.0


def _replaced(e: float, alpha: float) -> float:
    return 1.0


def _dutch(e: float, alpha: float) -> float:
    return (1 - alpha) * e + 1.0


# The trace of a pair after a visit: of its trace e before, and α.
VISITED: dict[str, Callable[[float, float], float]] = {
    "accumulating": _accumulated,
    "replacing": _replaced,
    "dutch": _dutch,
}


class Symbols(NamedTuple):
    """An algorithm in symbols.

    next: which of `NEXT` is the value of s′
    equation: the update line by line; in braces stand the symbols of its numbers, of which the one with s′ is the value
        of s′
    trace: which of `VISITED` its traces are, empty for an algorithm without traces
    """

    next: str
    equation: tuple[str, ...]
    trace: str = ""


_DELTA = "δ = {r} + {γ}·{Q(s′, a′)} − {Q(s, a)}"
_BY_TRACE = "Q(s, a) ← {Q(s, a)} + {α}·{δ}·{e(s, a)}"
_REPLACING = Symbols(
    "taken",
    (_DELTA, "e(s, a) ← {1}", _BY_TRACE),
    "replacing",
)
_ACCUMULATING = Symbols(
    "taken",
    (_DELTA, "e(s, a) ← {e(s, a)} + {1}", _BY_TRACE),
    "accumulating",
)
# The toolkit's algorithms that a page offers to go on by. Each update must translate to JavaScript.
SYMBOLS = {
    "Q": Symbols(
        "best",
        ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{max Q(s′, ·)} − {Q(s, a)})",),
    ),
    "SARSA": Symbols(
        "taken",
        ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Q(s′, a′)} − {Q(s, a)})",),
    ),
    "ESARSA": Symbols(
        "mean",
        ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Σ π(a′|s′) Q(s′, a′)} − {Q(s, a)})",),
    ),
    "SL": _REPLACING,
    "TOSL": Symbols(
        "taken",
        (
            _DELTA,
            "e(s, a) ← {(1 − α)}·{e(s, a)} + {1}",
            "Q(s, a) ← {Q(s, a)} + {α}·({δ} + {Q(s, a)} − {Q_old})·{e(s, a)} − {α}·({Q(s, a)} − {Q_old})",
        ),
        "dutch",
    ),
}
# Any other algorithm, such as one of the learner's own: only its result is known.
OWN = Symbols("taken", ("δ = {δ}", "Q(s, a) ← {Q(s, a)} + {change}"))


def in_symbols(algorithm: str, parameters: Parameters) -> Symbols:
    """The equation and the traces of the algorithm of this name, with these parameters."""
    if algorithm == "SL" and parameters.accumulating:
        return _ACCUMULATING
    return SYMBOLS.get(algorithm, OWN)
