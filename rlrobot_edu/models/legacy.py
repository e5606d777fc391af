"""Recordings of the paper's own program: NumPy arrays of rows (s, a, s', r), numbered in Fortran order."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rlrobot_edu.models.columns import Columns
from rlrobot_edu.task.task import Task


def read_legacy(path: Path, task: Task, inputs: Sequence[str] | None = None) -> Columns:
    """The columns of the array in `path`, arrays (n,), renumbered to the C order of `task`.

    inputs: names of the task's inputs in the order of the array, where its first one varies fastest;
        None if it is the task's order. Actions are the task's, the first output varying fastest.

    A new episode begins wherever a row does not start in the state that the row before ended in. The format does
    not say which steps were terminal: none are. Raises ValueError that names the file, the row and what was expected.
    """
    names = [variable.name for variable in task.inputs]
    order = names if inputs is None else list(inputs)
    if sorted(order) != sorted(names):
        raise ValueError(f"{path}: inputs must be those of task {task.name} in some order, {names}, got {order}")
    table = _load(path)
    for column, (name, n) in enumerate((("s", task.states.n), ("a", task.actions.n), ("s'", task.states.n))):
        numbers = table[:, column]
        _refuse(path, table, column, ~np.isin(numbers, np.arange(n)), f"{name} to be a whole number from 0 to {n - 1}")
    _refuse(path, table, 3, ~np.isin(table[:, 3], task.rewards), f"r to be one of the rewards {list(task.rewards)}")

    s, a, s_next = table[:, :3].astype(np.int64).T
    axes = [order.index(name) for name in names]
    s, s_next = (_to_c_order(numbers, task.states.shape, axes) for numbers in (s, s_next))
    starts = np.concatenate([[True], s[1:] != s_next[:-1]])
    first_row = np.flatnonzero(starts)
    episode = np.cumsum(starts) - 1
    return {
        "episode": episode,
        "step": np.arange(len(s)) - first_row[episode],
        "s": s,
        "a": _to_c_order(a, task.actions.shape, range(len(task.outputs))),
        "r": table[:, 3],
        "s_next": s_next,
        "terminated": np.zeros(len(s), dtype=bool),
    }


def _to_c_order(numbers: np.ndarray, shape: tuple[int, ...], axes: Sequence[int]) -> np.ndarray:
    """Numbers in C order; `axes[i]` is where the task's variable i stands in the array's order."""
    shape_there = [0] * len(shape)
    for axis, size in zip(axes, shape, strict=True):
        shape_there[axis] = size
    bins = np.unravel_index(numbers, shape_there, order="F")
    return np.ravel_multi_index([bins[axis] for axis in axes], shape)


def _load(path: Path) -> np.ndarray:
    """The array in `path`, shape (n, 4) of float64. Nothing is unpickled."""
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file")
    try:
        with open(path, "rb") as file:
            table = np.load(file, allow_pickle=False)
    except Exception as error:
        raise ValueError(f"{path}: not a whole NumPy array file ({error}); get the file again") from error
    if not isinstance(table, np.ndarray) or table.ndim != 2 or table.shape[1] != 4 or table.dtype.kind not in "fiu":
        found = f"{table.dtype} of shape {table.shape}" if isinstance(table, np.ndarray) else "several arrays"
        raise ValueError(f"{path}: expected one array of numbers with 4 columns (s, a, s', r), found {found}")
    if not len(table):
        raise ValueError(f"{path}: the array has no rows")
    return table.astype(np.float64)


def _refuse(path: Path, table: np.ndarray, column: int, bad: np.ndarray, expected: str) -> None:
    if bad.any():
        row = int(np.argmax(bad))
        value = repr(table[row, column].item()).removesuffix(".0")
        raise ValueError(f"{path}, row {row}: expected {expected}, found {value}; is it a recording of another task?")
