"""Which files are handed in: the notebooks that names on the command line stand for, and a copy of each."""

from __future__ import annotations

import glob
import os
import shutil
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

# What macOS and Jupyter leave beside the files of people
SYSTEM_FOLDERS = ("__MACOSX", ".ipynb_checkpoints")
NAMED = 3  # files that a note names


@dataclass(frozen=True)
class HandIn:
    """A notebook, and its copy; there is none if the file cannot be read.

    What is graded, read and compared is the copy: it stays as it is, whatever becomes of the file.
    """

    path: Path
    copy: Path


def handed_in(names: Sequence[str], folder: Path) -> tuple[list[HandIn], list[Path]]:
    """Copy into `folder` the notebooks that names stand for: files, folders with all in them, and patterns.

    Returns the notebooks, each once, in the order of the names; and the other files. Raises FileNotFoundError if a name
    stands for nothing, or none for a notebook.
    """
    notebooks: dict[str, HandIn] = {}
    others: list[Path] = []
    for path in _files(names):
        key = os.path.abspath(path)
        if path.suffix.lower() != ".ipynb":
            others.append(path)
        elif key not in notebooks:
            copy = folder / str(len(notebooks)) / path.name
            copy.parent.mkdir()
            notebooks[key] = HandIn(path, copy)
            if path.is_file():  # a pipe, say, could keep who reads it waiting
                with suppress(OSError):
                    shutil.copyfile(path, copy)
    if not notebooks:
        note = " ".join(
            [f"{', '.join(names)}: there is no notebook in it.", *notes_on(others)]
        )
        raise FileNotFoundError(note)
    return list(notebooks.values()), others


def _files(names: Sequence[str]) -> Iterable[Path]:
    for name in names:
        matches = (
            [name] if os.path.lexists(name) else sorted(glob.glob(name, recursive=True))
        )
        if not matches:
            raise FileNotFoundError(
                f"{name}: there is no such file, nor a notebook in it; name what is to be graded"
            )
        for path in map(Path, matches):
            files = sorted(path.rglob("*")) if path.is_dir() else [path]
            for file in files:
                # a link to a folder is not followed, but named
                is_folder = file.is_dir() and not file.is_symlink()
                if not is_folder and not _is_the_systems(file):
                    yield file


def _is_the_systems(path: Path) -> bool:
    """Whether a program left this file: a checkpoint, or what macOS keeps of a file."""
    return path.name.startswith(".") or any(
        part in SYSTEM_FOLDERS for part in path.parts
    )


def notes_on(others: Iterable[Path], known: Iterable[str] = ()) -> list[str]:
    """Return what the teacher should know of files that are not graded; known: files and folders of the grader."""
    ours = [Path(os.path.abspath(path)) for path in known if path]
    files = []
    for path in others:
        whole = Path(os.path.abspath(path))
        if not any(whole.is_relative_to(one) for one in ours):
            files.append(str(path))
    if not files:
        return []
    more = f" and {len(files) - NAMED} more" if len(files) > NAMED else ""
    return [
        f"Not graded, since these are no files that end in .ipynb: {', '.join(files[:NAMED])}{more}."
    ]
