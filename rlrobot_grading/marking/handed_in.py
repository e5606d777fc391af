"""Which files are handed in: the notebooks that names on the command line stand for, and a copy of each."""

from __future__ import annotations

import glob
import os
import shutil
import stat
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

# What macOS and Jupyter leave beside the files of people
SYSTEM_FOLDERS = ("__MACOSX", ".ipynb_checkpoints")
NAMED = 3  # files that a note names


@dataclass(frozen=True)
class HandIn:
    """A notebook, and its copy, which is what is graded, read and compared: it stays, whatever becomes of the file.

    fault: why there is no copy; empty if there is one
    note: what the teacher should know of the file
    """

    path: Path
    copy: Path
    fault: str = ""
    note: str = ""


class Names(NamedTuple):
    """Of a file on its disk: the file's number, and how many names (hard links) it has."""

    file: tuple[int, int]
    number: int


def handed_in(names: Sequence[str], folder: Path) -> tuple[list[HandIn], list[Path]]:
    """Copy into `folder` the notebooks that names stand for: files, folders with all in them, and patterns.

    What is no file of its own is not copied: a link, a pipe, a second name of another one's file. Returns the
    notebooks, each once, in the order of the names; and the other files. Raises FileNotFoundError if a name stands for
    nothing, or none for a notebook.
    """
    matches = [match for name in names for match in _matches(name)]
    top = _top(names, matches)
    notebooks: dict[str, HandIn] = {}
    names_of: dict[str, Names] = {}
    others: list[Path] = []
    for path in _files(matches):
        key = os.path.abspath(path)
        if path.suffix.lower() != ".ipynb":
            others.append(path)
        elif key not in notebooks:
            copy = folder / str(len(notebooks)) / path.name
            copy.parent.mkdir()
            fault = _link_in(Path(key), top)
            try:
                if not fault:
                    names_of[key] = _copy(path, copy)
            except OSError as error:
                fault = f"It cannot be read: {error.strerror}."
            except ValueError as error:
                fault = str(error)
            notebooks[key] = HandIn(path, copy, fault)
    if not notebooks:
        note = " ".join(
            [f"{', '.join(names)}: there is no notebook in it.", *notes_on(others)]
        )
        raise FileNotFoundError(note)
    found = [
        _with_other_names(key, one, names_of, notebooks)
        for key, one in notebooks.items()
    ]
    return found, others


def _copy(path: Path, copy: Path) -> Names:
    """Copy a file, and return its names. Raises OSError; ValueError if it is no file that can be read to its end."""

    def without_links(name: str, flags: int) -> int:
        # it may have become a link, or a pipe that keeps who opens it waiting; Windows has neither flag
        more = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
        return os.open(name, flags | more)

    with open(path, "rb", opener=without_links) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise ValueError("It is a pipe or a device, and no file.")
        with copy.open("wb") as its_copy:
            shutil.copyfileobj(file, its_copy)
    return Names((status.st_dev, status.st_ino), status.st_nlink)


def _link_in(path: Path, top: Path) -> str:
    """Say which part of a path below `top` is a link, and so leads to what may be another one's; empty if none is."""
    below = [one for one in path.parents if top in one.parents]
    for one in [path, *below]:
        if one.is_symlink():
            return (
                f"{one.name} is a link to {os.readlink(one)}, which may be another one's, and links are not followed: "
                "put the notebook itself in its place."
            )
    return ""


def _with_other_names(
    key: str,
    one: HandIn,
    names_of: Mapping[str, Names],
    notebooks: Mapping[str, HandIn],
) -> HandIn:
    """A hand-in with what is to be said of the other names of its file."""
    names = names_of.get(key)
    if names is None or names.number == 1:
        return one
    same = [other for other in names_of if names_of[other].file == names.file]
    same.remove(key)
    if same:
        others = ", ".join(str(notebooks[other].path) for other in same)
        fault = (
            f"It is the same file as {others} (a hard link), so that nobody can tell whose it is: put a file of its "
            "own in its place."
        )
        return replace(one, fault=fault)
    note = f"Its file has {names.number} names on this computer (hard links); the others are not among these."
    return replace(one, note=note)


def _matches(name: str) -> list[Path]:
    """The files and folders that a name on the command line stands for. Raises FileNotFoundError if there are none."""
    if os.path.lexists(name):
        return [Path(name)]
    matches = sorted(glob.glob(name, recursive=True))
    if not matches:
        raise FileNotFoundError(
            f"{name}: there is no such file, nor a notebook in it; name what is to be graded"
        )
    return [Path(match) for match in matches]


def _top(names: Sequence[str], matches: Sequence[Path]) -> Path:
    """The folder around all that is handed in: up to here the path is the teacher's, below it the students'."""
    if [str(match) for match in matches] == [str(Path(name)) for name in names[:1]]:
        only = Path(os.path.abspath(matches[0]))
        return only if only.is_dir() else only.parent
    folders = [os.path.dirname(os.path.abspath(match)) for match in matches]
    try:
        return Path(os.path.commonpath(folders))
    except ValueError:  # of two drives of Windows
        return Path()


def _files(matches: Iterable[Path]) -> Iterable[Path]:
    for path in matches:
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
    files, links = [], []
    for path in others:
        whole = Path(os.path.abspath(path))
        if not any(whole.is_relative_to(one) for one in ours):
            found = links if path.is_symlink() else files
            found.append(str(path))
    notes = []
    if files:
        notes.append(
            f"Not graded, since these are no files that end in .ipynb: {_first(files)}."
        )
    if links:
        notes.append(f"Not graded, since these are links: {_first(links)}.")
    return notes


def _first(files: Sequence[str]) -> str:
    more = f" and {len(files) - NAMED} more" if len(files) > NAMED else ""
    return f"{', '.join(files[:NAMED])}{more}"
