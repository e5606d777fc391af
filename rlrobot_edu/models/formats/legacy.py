"""Recordings of the paper's own program: NumPy arrays of rows (s, a, s', r), numbered in Fortran order."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.columns import check_rows
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task

Numbers = NDArray[np.float64]


def read_legacy(path: Path, task: Task, inputs: Sequence[str] | None = None) -> Transitions:
    """The transitions of the array in `path`, renumbered to the C order of `task`.

    inputs: names of the task's inputs in the order of the array, where its first one varies fastest;
        None if it is the task's order. Actions are the task's, the first output varying fastest.

    The format does not say where episodes ended. No step terminated; one was truncated wherever the next row does not
    start in the state that it ended in. Raises ValueError that names the file, the row and what was expected.
    """
    names = [variable.name for variable in task.inputs]
    order = names if inputs is None else [inputs] if isinstance(inputs, str) else list(inputs)
    if sorted(order) != sorted(names):
        expected = f"those of task {task.name} in some order, {names}"
        raise ValueError(f"{path}: inputs must be {expected}, got {order}")
    columns = dict(zip(("s", "a", "s_next", "r"), _load(path).T, strict=True))
    remedy = "is it a recording of another task?"
    check_rows(columns, Source.of_task(task), lambda row: f"{path}, row {row}", remedy)
    axes = [order.index(name) for name in names]
    s, s_next = (_to_c_order(columns[name], task.states.shape, axes) for name in ("s", "s_next"))
    a = _to_c_order(columns["a"], task.actions.shape, range(len(task.outputs)))
    truncated = np.append(s_next[:-1] != s[1:], False)
    return Transitions(s, a, columns["r"], s_next, terminated=np.zeros_like(truncated), truncated=truncated)


def _to_c_order(numbers: Numbers, shape: tuple[int, ...], axes: Sequence[int]) -> NDArray[np.intp]:
    """Numbers in C order; `axes[i]` is where the task's variable i stands in the array's order."""
    shape_there = [shape[axes.index(i)] for i in range(len(shape))]
    bins = np.unravel_index(numbers.astype(np.intp), shape_there, order="F")
    return np.ravel_multi_index([bins[axis] for axis in axes], shape)


def _load(path: Path) -> Numbers:
    """The array in `path`, shape (n, 4). Nothing is unpickled."""
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file")
    try:
        with open(path, "rb") as file:
            table = np.load(file, allow_pickle=False)
    except Exception as error:
        raise ValueError(f"{path}: not a whole NumPy array file ({error}); get the file again") from error
    is_array = isinstance(table, np.ndarray)
    if not is_array or table.dtype.kind not in "fiu" or table.shape[1:] != (4,):
        kind = f"{table.dtype} of shape {table.shape}" if is_array else "several arrays"
        raise ValueError(f"{path}: expected one array of numbers with 4 columns (s, a, s', r), found {kind}")
    if not len(table):
        raise ValueError(f"{path}: the array has no rows")
    return np.asarray(table, dtype=np.float64)
