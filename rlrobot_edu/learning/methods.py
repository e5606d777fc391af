"""The names of the methods, in the paper's notation: ``ALGORITHM+SELECTION``, for example ``TOSL+QBIASSR``."""

from __future__ import annotations

import difflib

ALGORITHMS = ("Q", "SARSA", "SL", "TOSL")
SELECTIONS = ("SR", "QBIASSR", "EG", "EGLE", "GREEDY", "RANDOM")
ALIASES = {"SARSA(lambda)": "SL", "SARSA(λ)": "SL"}

# The numbers by which the kernels tell them apart.
Q, SARSA, SL, TOSL = range(len(ALGORITHMS))
SR, QBIASSR, EG, EGLE, GREEDY, RANDOM = range(len(SELECTIONS))


def parse_method(method: str) -> tuple[int, int]:
    """Numbers of the algorithm and the selection. Raises ValueError that lists the known names and the nearest."""
    algorithm, _, selection = str(method).partition("+")
    algorithm = ALIASES.get(algorithm, algorithm)
    if algorithm in ALGORITHMS and selection in SELECTIONS:
        return ALGORITHMS.index(algorithm), SELECTIONS.index(selection)
    known = [f"{a}+{s}" for a in ALGORITHMS for s in SELECTIONS]
    nearest = difflib.get_close_matches(f"{algorithm}+{selection}".upper(), known, n=1, cutoff=0.0)[0]
    raise ValueError(
        f"unknown method {method!r}; did you mean {nearest!r}? A method is ALGORITHM+SELECTION with an algorithm of "
        f"{', '.join(ALGORITHMS)} (SL is SARSA(lambda)) and a selection of {', '.join(SELECTIONS)}"
    )
