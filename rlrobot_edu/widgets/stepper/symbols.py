"""The stepper's text for each algorithm: its update as an equation, and the traces it leaves."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from rlrobot_edu.learning.parameters import Parameters

# What an update takes for the value of s′: of Q(s′), the action a′ that was chosen, and the probabilities in s′.
NEXT: dict[str, Callable[[np.ndarray, int, np.ndarray], float]] = {
    "taken": lambda q_next, a_next, p: q_next[a_next],
    "best": lambda q_next, a_next, p: q_next.max(),
    "mean": lambda q_next, a_next, p: q_next @ p,
}
# The trace of a pair once it was visited: of its trace e before, and α.
VISITED: dict[str, Callable[[float, float], float]] = {
    "accumulating": lambda e, alpha: e + 1.0,
    "replacing": lambda e, alpha: 1.0,
    "dutch": lambda e, alpha: (1 - alpha) * e + 1.0,
}


class Symbols(NamedTuple):
    """An algorithm in symbols.

    next: which of `NEXT` is the value of s′
    equation: function (parameters) -> the update line by line; in braces stand the symbols of its numbers, of which the
        one with s′ is the value of s′
    trace: function (parameters) -> which of `VISITED` its traces are, empty for an algorithm without traces
    """

    next: str
    equation: Callable[[Parameters], tuple[str, ...]]
    trace: Callable[[Parameters], str] = lambda parameters: ""


# The toolkit's algorithms that a page offers to go on by. Each update must translate to JavaScript.
SYMBOLS = {
    "Q": Symbols(
        "best",
        lambda p: ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{max Q(s′, ·)} − {Q(s, a)})",),
    ),
    "SARSA": Symbols(
        "taken",
        lambda p: ("Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Q(s′, a′)} − {Q(s, a)})",),
    ),
    "ESARSA": Symbols(
        "mean",
        lambda p: (
            "Q(s, a) ← {Q(s, a)} + {α}·({r} + {γ}·{Σ π(a′|s′) Q(s′, a′)} − {Q(s, a)})",
        ),
    ),
    "SL": Symbols(
        "taken",
        equation=lambda p: (
            "δ = {r} + {γ}·{Q(s′, a′)} − {Q(s, a)}",
            "e(s, a) ← {e(s, a)} + {1}" if p.accumulating else "e(s, a) ← {1}",
            "Q(s, a) ← {Q(s, a)} + {α}·{δ}·{e(s, a)}",
        ),
        trace=lambda p: "accumulating" if p.accumulating else "replacing",
    ),
    "TOSL": Symbols(
        "taken",
        equation=lambda p: (
            "δ = {r} + {γ}·{Q(s′, a′)} − {Q(s, a)}",
            "e(s, a) ← {(1 − α)}·{e(s, a)} + {1}",
            "Q(s, a) ← {Q(s, a)} + {α}·({δ} + {Q(s, a)} − {Q_old})·{e(s, a)} − {α}·({Q(s, a)} − {Q_old})",
        ),
        trace=lambda p: "dutch",
    ),
}
# Any other algorithm, such as one of the learner's own: what came of it, since nobody has said how.
OWN = Symbols("taken", lambda p: ("δ = {δ}", "Q(s, a) ← {Q(s, a)} + {change}"))


def in_symbols(algorithm: str) -> Symbols:
    """The equation and the traces of the algorithm of this name."""
    return SYMBOLS.get(algorithm, OWN)
