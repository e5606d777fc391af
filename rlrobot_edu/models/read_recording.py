"""Recordings: those of the toolkit by their names, others from a folder, a CSV file or in the paper's own format."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import did_you_mean
from rlrobot_edu.files import shipped
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.data_package import CSV_NAME, PACKAGE_NAME
from rlrobot_edu.models.own_rows import transitions_of
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.models.tables import read_table
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task

Numbers = NDArray[np.float64]


def available_recordings() -> list[str]:
    """Names of the recordings that come with the toolkit."""
    return sorted(
        package.parent.name for package in shipped("datasets").glob(f"*/{PACKAGE_NAME}")
    )


@suggests_keywords
def read_recording(
    path: str | Path,
    legacy: bool = False,
    task: str | Path | Task | None = None,
    inputs: Sequence[str] | None = None,
) -> Recording:
    """The recording in a folder or a CSV file, or the one of this name that comes with the toolkit.

    Parameters
    ----------
    path : str or Path
        The folder, its datapackage.json or transitions.csv; any other CSV file, of rows of your own, see
        `Recording.from_rows`; with `legacy`, the paper's own array (.npy).
    legacy : bool
        Whether the file is in the format of the paper's own program.
    task : str, Path or Task, optional
        The task that the recording must be of; needed for rows of your own and with `legacy`, which do not say.
    inputs : sequence of str, optional
        With `legacy`, names of the inputs in the array's order where it is not the task's.

    Returns
    -------
    Recording
        Every row, checked.

    Raises
    ------
    ValueError
        In one sentence, for a file that is not whole and right or that is of another task.
    FileNotFoundError
        If there is no such recording, or one of its two files is missing.

    Notes
    -----
    A CSV file of your own is read as spreadsheets write it: in line 1 the names of the columns, which are separated
    by commas, semicolons or tabs; with semicolons or tabs, numbers may have a decimal comma. A column without a name
    is not read.
    """
    if not isinstance(path, str | Path):
        raise ValueError(
            f"a recording is the name of one or the path of its folder, not {path!r:.200}"
        )
    path = Path(path)
    if legacy:
        if task is None:
            raise ValueError(
                f"{path}: the paper's format does not say which task was recorded; give task="
            )
        task = load_task(task)
        return Recording(_read_legacy(path, task, inputs), Source.of_task(task), task)
    if inputs is not None:
        raise ValueError(
            f"{path}: inputs= is for legacy=True; this format names its inputs itself"
        )
    has_package = path.name == CSV_NAME and path.with_name(PACKAGE_NAME).is_file()
    if path.suffix.lower() == ".csv" and not path.is_dir() and not has_package:
        return _read_own(path, task)
    if path.is_dir() or path.suffix in (".csv", ".json"):
        return Recording.load(path, task)
    names = available_recordings()
    if str(path) in names:
        return Recording.load(shipped("datasets") / path, task)
    named = " ".join(str(path).split())  # in one line
    nearest = did_you_mean(named, names)
    hint = "Give its folder, for rows of your own a CSV file and task=, for the paper's own array legacy=True and task="
    raise FileNotFoundError(
        f"{named}: there is no such recording{nearest} {hint}, or one of the toolkit's: {', '.join(names) or 'none'}"
    )


def _read_own(path: Path, task: str | Path | Task | None) -> Recording:
    """The recording that a lone CSV file makes."""
    table = read_table(path)
    if task is None:
        fault = "a CSV file alone does not say of which task its rows are"
        raise ValueError(f"{path}: {fault}; give task=")
    task = load_task(task)
    return Recording(transitions_of(table, task), Source.of_task(task), task)


def _read_legacy(path: Path, task: Task, inputs: Sequence[str] | None) -> Transitions:
    """The transitions of the array of rows (s, a, s', r) in `path`, renumbered from Fortran's order to C's.

    inputs: names of the task's inputs in the order of the array, where its first one varies fastest;
        None if it is the task's order. Actions are the task's, the first output varying fastest.

    The format does not say where episodes ended. No step terminated; one was truncated wherever the next row
    does not start in the state that it ended in. Raises ValueError that names the file, the row and what was
    expected.
    """
    names = [variable.name for variable in task.inputs]
    order = names if inputs is None else list(inputs)
    if sorted(order) != sorted(names):
        raise ValueError(
            f"{path}: inputs must be the task's in some order, {names!s:.200}, got {order!s:.200}"
        )
    columns = dict(zip(("s", "a", "s_next", "r"), _load(path).T, strict=True))
    remedy = "is it a recording of another task?"
    Source.of_task(task).check_rows(columns, lambda row: f"{path}, row {row}", remedy)
    axes = [order.index(name) for name in names]
    s, s_next = (
        _to_c_order(columns[name], task.states.shape, axes) for name in ("s", "s_next")
    )
    a = _to_c_order(columns["a"], task.actions.shape, range(len(task.outputs)))
    truncated = np.append(s_next[:-1] != s[1:], False)
    return Transitions(
        s,
        a,
        columns["r"],
        s_next,
        terminated=np.zeros_like(truncated),
        truncated=truncated,
    )


def _to_c_order(
    numbers: Numbers, shape: tuple[int, ...], axes: Sequence[int]
) -> NDArray[np.intp]:
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
        raise ValueError(
            f"{path}: not a whole NumPy array file ({error}); get the file again"
        ) from error
    is_array = isinstance(table, np.ndarray)
    if not is_array or table.dtype.kind not in "fiu" or table.shape[1:] != (4,):
        kind = f"{table.dtype} of shape {table.shape}" if is_array else "several arrays"
        raise ValueError(
            f"{path}: expected one array of numbers with 4 columns (s, a, s', r), found {kind}"
        )
    if not len(table):
        raise ValueError(f"{path}: the array has no rows")
    return np.asarray(table, dtype=np.float64)
