"""Reading the two files of a recording, transitions.csv and datapackage.json, and refusing what is not whole."""

from __future__ import annotations

import warnings
from pathlib import Path

from rlrobot_edu.files import sha256, shipped
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.columns import REMEDY, from_csv
from rlrobot_edu.models.data_package import CSV_NAME, PACKAGE_NAME, Card, read_card
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task, available_tasks, load_task


def read_folder(path: Path, task: Task | None) -> tuple[Transitions, Source, Task | None]:
    """Transitions, source and task (None if not at hand) of the recording `path`, which must be of `task` if given.

    Raises ValueError in one sentence for a file that is not whole and right, FileNotFoundError if there is none.
    """
    folder = _folder(path)
    package = folder / PACKAGE_NAME
    card = read_card(_text(package), str(package))
    return _read_rows(folder / CSV_NAME, card), card.source, _task_of(card.source, task, package)


def _read_rows(path: Path, card: Card) -> Transitions:
    """The checked rows. A bad row says more than a wrong checksum, so it is looked for first."""
    text = _text(path)
    transitions = from_csv(text, card.source, str(path))
    rows, digits = len(transitions.s), sha256(text.encode())
    if rows != card.rows:
        raise ValueError(f"{path}: it has {rows} rows, {PACKAGE_NAME} says {card.rows}; {REMEDY}")
    if digits != card.sha256:
        raise ValueError(
            f"{path}: its sha256 is {digits}, {PACKAGE_NAME} says {card.sha256}, so one of the two files was changed; "
            f"{REMEDY}"
        )
    return transitions


def _task_of(source: Source, task: Task | None, package: Path) -> Task | None:
    """The recorded task: the given one, which must agree, or the toolkit's of this name if it agrees."""
    if task is None and source.task_name not in available_tasks():
        return None
    known = load_task(source.task_name) if task is None else task
    difference = source.difference(known)
    if not difference:
        return known
    if task is not None:
        raise ValueError(f"{package}: not a recording of task {known.name}: {difference}; record this task anew")
    warnings.warn(f"{package}: task {known.name} has changed since: {difference}; recording.task is None", stacklevel=3)
    return None


def available_recordings() -> list[str]:
    """Names of the recordings that come with the toolkit."""
    return sorted(package.parent.name for package in shipped("datasets").glob(f"*/{PACKAGE_NAME}"))


def _folder(path: Path) -> Path:
    """The folder that holds the recording `path`."""
    if path.name in (CSV_NAME, PACKAGE_NAME):
        return path.parent
    if path.is_dir():
        return path
    if str(path) in available_recordings():
        return shipped("datasets") / path
    hint = "for the paper's own array give legacy=True and task=" if path.suffix == ".npy" else "give its folder"
    known = ", ".join(available_recordings()) or "none"
    raise FileNotFoundError(f"{path}: there is no such recording; {hint}, or one of the toolkit's: {known}")


def _text(path: Path) -> str:
    """Text of a file. Bytes that are no text become characters that no column can hold, so that their row is named."""
    if not path.is_file():
        raise FileNotFoundError(f"{path}: this file is missing; a recording is {CSV_NAME} and {PACKAGE_NAME} together")
    return path.read_bytes().decode("utf-8", errors="replace")
