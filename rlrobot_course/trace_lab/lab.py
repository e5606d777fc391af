"""The trace lab: a grid, paths over it, and the handle that lets the reader draw one."""

from collections.abc import Sequence
from typing import Any

from rlrobot_course.handles.handle import Handle
from rlrobot_course.trace_lab.kernels import (
    online_lambda_return,
    sarsa_lambda,
    true_online,
)
from rlrobot_course.trace_lab.still import plot_lab

ROWS, COLUMNS = 3, 4
CELLS = "ABCDEFGHIJKL"  # row by row
PAYS = {"A": 10.0, "E": -2.0}  # a step that leads into the cell
LONGEST = 30  # steps of a path
PATHS = {
    "straight to A": "LKJFBA",
    "a loop": "LKJFGKJFBA",
    "there and back": "CBCBCBA",
    "eight good steps, a bump": "AAAAAAAAAE",
    "A, B, A, B": "ABAB",
}
KINDS = ("replacing", "accumulating", "true online")


def trace_lab(
    path: str,
    *,
    kinds: Sequence[str] = KINDS,
    paths: Sequence[str] = tuple(PATHS),
    kind: str,
    alpha: float,
    against_ideal: bool = False,
    has_switches: bool = False,
) -> Handle:
    """The lab, which opens at the end of a path.

    path: a name in `PATHS`; paths: those that it offers
    kinds: of `KINDS`, those that it offers; kind: the one with which it opens; alpha: the learning rate at the opening
    against_ideal: whether it shows the online λ-return algorithm, too
    has_switches: whether the two terms with Q_old can be left out; for true online alone
    """
    feed: dict[str, Any] = {
        "rows": ROWS,
        "columns": COLUMNS,
        "cells": CELLS,
        "pays": [PAYS.get(cell, 0.0) for cell in CELLS],
        "longest": LONGEST,
        "paths": {name: numbered(PATHS[name]) for name in paths},
        "path": numbered(PATHS[path]),
        "kinds": list(kinds),
        "kind": list(kinds).index(kind),
        "alpha": alpha,
        "decay": 0.9,
        "againstIdeal": against_ideal,
        "hasSwitches": has_switches,
    }
    kernels = {
        "sarsa_lambda": sarsa_lambda,
        "true_online": true_online,
        "online_lambda_return": online_lambda_return,
    }
    return Handle(
        "The trace lab",
        __package__,
        ["grid.js", "lab.js"],
        feed,
        plot_lab(feed),
        kernels,
    )


def numbered(path: str) -> list[int]:
    """The cells of a path, by their numbers."""
    return [CELLS.index(cell) for cell in path]
