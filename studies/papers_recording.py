"""The format in which the paper's authors recorded: an array of rows (s, a, s', r), states in Fortran's order."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.source import Source


def read_papers_recording(
    path: Path, task: rl.Task, inputs: Sequence[str]
) -> rl.Recording:
    """The recording in an array file, with states and actions renumbered as the task's.

    inputs: names of the task's inputs in the order of the array, where its first one varies fastest. Actions are the
    task's, the first output varying fastest.

    The format does not say where episodes ended. No step terminated; one was truncated wherever the next row does not
    start in the state that it ended in. Raises ValueError for a row that the task does not allow.
    """
    s, a, s_next, r = np.load(path, allow_pickle=False).T
    axes = [list(inputs).index(variable.name) for variable in task.inputs]
    states = task.states.shape
    s, s_next = _to_c_order(s, states, axes), _to_c_order(s_next, states, axes)
    a = _to_c_order(a, task.actions.shape, range(len(task.outputs)))
    truncated = np.append(s_next[:-1] != s[1:], False)
    transitions = Transitions(s, a, r, s_next, np.zeros_like(truncated), truncated)
    return rl.Recording(transitions, Source.of_task(task), task)


def _to_c_order(
    numbers: np.ndarray, shape: tuple[int, ...], axes: Sequence[int]
) -> np.ndarray:
    """Numbers in C order; `axes[i]` is where the task's variable i stands in the array's order."""
    shape_there = [shape[axes.index(i)] for i in range(len(shape))]
    bins = np.unravel_index(numbers.astype(np.intp), shape_there, order="F")
    return np.ravel_multi_index([bins[axis] for axis in axes], shape)
