"""Recordings: those of the toolkit by their names, others from a folder."""

from pathlib import Path

from rlrobot_edu.files import shipped
from rlrobot_edu.models.data_package import PACKAGE_NAME
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.task.task import Task


def available_recordings() -> list[str]:
    """Names of the recordings that come with the toolkit."""
    return sorted(
        package.parent.name for package in shipped("datasets").glob(f"*/{PACKAGE_NAME}")
    )


def read_recording(
    path: str | Path, task: str | Path | Task | None = None
) -> Recording:
    """The recording in a folder, or the one of this name that comes with the toolkit.

    Parameters
    ----------
    path : str or Path
        The folder, its datapackage.json or transitions.csv; or a name.
    task : str, Path or Task, optional
        The task that the recording must be of.

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
        raise ValueError(
            f"a recording is the name of one or the path of its folder, not {path!r:.200}"
        )
    path = Path(path)
    if path.is_dir() or path.suffix in (".csv", ".json"):
        return Recording.load(path, task)
    names = available_recordings()
    if str(path) in names:
        return Recording.load(shipped("datasets") / path, task)
    named = " ".join(str(path).split())  # in one line
    raise FileNotFoundError(
        f"{named}: there is no such recording; give its folder, or one of the toolkit's: {', '.join(names) or 'none'}"
    )
