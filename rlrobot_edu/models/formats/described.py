"""Rows that travel in a file of another format, with the data package of `Recording.save` beside them."""

import importlib
from pathlib import Path
from typing import Any

from rlrobot_edu.files import LARGEST, sha256
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.columns import REMEDY, to_csv
from rlrobot_edu.models.data_package import read_package, task_of
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task

KEY = "rlrobot_edu"  # under which a file keeps our data package


def needed(module: str) -> Any:
    """A module of the extra "exchange". Raises ImportError that says what to install."""
    try:
        return importlib.import_module(module)
    except ImportError:
        raise ImportError(
            f"{module.partition('.')[0]} is not installed: run pip install 'rlrobot-edu[exchange]'; "
            "everything else works without it"
        ) from None


def check_size(n_bytes: int) -> None:
    """Raises ValueError for rows of which a file claims to hold too many."""
    if n_bytes > LARGEST:
        raise ValueError(f"it claims to hold more than {LARGEST >> 20} MB of rows")


def from_package(path: Path, transitions: Transitions, package: str, task: Task | None) -> Recording:
    """The recording of which the file `path` holds rows and package. Raises ValueError if they do not fit together."""
    source, _, digits = read_package(package, str(path))
    recording = from_rows(path, transitions, source, task_of(source, task, path))
    if sha256(to_csv(recording.transitions).encode()) != digits:
        raise ValueError(f"{path}: its rows are not the ones that its data package describes; {REMEDY}")
    return recording


def from_rows(path: Path, transitions: Transitions, source: Source, task: Task | None) -> Recording:
    """The recording of these rows. Raises ValueError that names `path` and the first bad row."""
    try:
        return Recording(transitions, source, task)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
