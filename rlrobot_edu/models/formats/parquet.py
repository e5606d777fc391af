"""Recordings as Parquet files, one row a step."""

from pathlib import Path

from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.formats.described import KEY, check_size, from_package, from_rows, needed, package_of
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.messages import in_words
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


def to_parquet(recording: Recording, path: str | Path) -> None:
    """Write a recording to one Parquet file, whole or not at all.

    Parameters
    ----------
    recording : Recording
        What to write.
    path : str or Path
        The file; what was there is replaced.

    Raises
    ------
    ImportError
        If pyarrow is missing; it says what to install.

    Notes
    -----
    Columns ``s``, ``a``, ``r``, ``s_next``, ``terminated`` and ``truncated``; ``episode`` and ``step`` besides, which
    follow from them and are not read again. The data package, which says what the numbers mean, is the JSON text under
    ``rlrobot_edu`` in the schema's metadata.
    """
    pyarrow, parquet = needed("pyarrow"), needed("pyarrow.parquet")
    columns = {name: getattr(recording, name) for name in ("episode", "step", *Transitions._fields)}
    sink = pyarrow.BufferOutputStream()
    parquet.write_table(pyarrow.table(columns, metadata={KEY: package_of(recording)}), sink)
    write_whole(path, sink.getvalue().to_pybytes())


def from_parquet(path: str | Path, task: str | Path | Task | None = None) -> Recording:
    """The recording in a Parquet file.

    Parameters
    ----------
    path : str or Path
        A file of `to_parquet`, or of another program with the same columns.
    task : str, Path or Task, optional
        The task that the recording must be of; needed for another program's file, which does not say.

    Returns
    -------
    Recording
        Every row, checked.

    Raises
    ------
    ValueError
        In one sentence, for a file that is not whole and right or that is of another task.
    FileNotFoundError
        If there is no such file.
    ImportError
        If pyarrow is missing; it says what to install.
    """
    pyarrow, parquet = needed("pyarrow"), needed("pyarrow.parquet")
    path, task = Path(path), None if task is None else load_task(task)
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such Parquet file")
    try:
        check_size(path.stat().st_size)
        file = parquet.ParquetFile(pyarrow.BufferReader(path.read_bytes()))
        names, package = list(Transitions._fields), (file.schema_arrow.metadata or {}).get(KEY.encode())
        check_size(8 * len(names) * sum(file.metadata.row_group(i).num_rows for i in range(file.num_row_groups)))
        for name in names:
            if not pyarrow.types.is_primitive(kind := file.schema_arrow.field(name).type):
                raise ValueError(f"column {name} is of type {kind!s:.80}, expected numbers")
        table = file.read(columns=names)
        transitions = Transitions(*(table[name].to_numpy() for name in names))
        text = None if package is None else package.decode()
    except Exception as error:  # of a damaged file anything may be the matter
        raise ValueError(f"{path}: this is not a whole Parquet file of one recording ({in_words(error)})") from error
    if text is not None:
        return from_package(path, transitions, text, task)
    if task is None:
        raise ValueError(
            f"{path}: this file does not say what its numbers mean; give the task that was recorded, task="
        )
    return from_rows(path, transitions, Source.of_task(task), task)
