"""Recordings by the name under which they come with the toolkit, from a folder, or in the paper's own format."""

from collections.abc import Sequence
from pathlib import Path

from rlrobot_edu.files import shipped
from rlrobot_edu.models.data_package import PACKAGE_NAME
from rlrobot_edu.models.formats.legacy import read_legacy
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


def available_recordings() -> list[str]:
    """Names of the recordings that come with the toolkit."""
    return sorted(package.parent.name for package in shipped("datasets").glob(f"*/{PACKAGE_NAME}"))


def read_recording(
    path: str | Path, legacy: bool = False, task: str | Path | Task | None = None, inputs: Sequence[str] | None = None
) -> Recording:
    """The recording in a folder, or the one of this name that comes with the toolkit.

    Parameters
    ----------
    path : str or Path
        The folder, its datapackage.json or transitions.csv; with `legacy`, the paper's own array (.npy).
    legacy : bool
        Whether the file is in the format of the paper's own program.
    task : str, Path or Task, optional
        The task that the recording must be of; needed with `legacy`, which does not say.
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
    """
    if not isinstance(path, str | Path):
        raise ValueError(f"a recording is the name of one or the path of its folder, not {path!r:.200}")
    path = Path(path)
    if legacy:
        if task is None:
            raise ValueError(f"{path}: the paper's format does not say which task was recorded; give task=")
        task = load_task(task)
        return Recording(read_legacy(path, task, inputs), Source.of_task(task), task)
    if inputs is not None:
        raise ValueError(f"{path}: inputs= is for legacy=True; this format names its inputs itself")
    if path.is_dir() or path.suffix in (".csv", ".json"):
        return Recording.load(path, task)
    names = available_recordings()
    if str(path) in names:
        return Recording.load(shipped("datasets") / path, task)
    named = " ".join(str(path).split())  # in one line
    hint = "give its folder, or legacy=True and task= for the paper's own array"
    known = ", ".join(names) or "none"
    raise FileNotFoundError(f"{named}: there is no such recording; {hint}, or one of the toolkit's: {known}")
