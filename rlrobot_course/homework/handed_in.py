"""Which files are handed in: the notebooks that names on the command line stand for, and a copy of each that stays."""

from __future__ import annotations

import filecmp
import glob
import os
import re
import shutil
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

# What macOS, Windows, Jupyter and editors leave beside the files of people: in a folder, and anywhere
OF_THE_SYSTEM = re.compile(r"\..+|thumbs\.db|desktop\.ini|icon\r|~\$.*|#.*#|.*~", re.IGNORECASE)
ALWAYS = re.compile(r"__MACOSX|\.ipynb_checkpoints|\.Trash.*|\$RECYCLE\.BIN", re.IGNORECASE)
NAMED = 3  # files that a note names


@dataclass
class HandedIn:
    """Notebooks, and what was not taken for one: files of the operating system, and others, with their reasons."""

    notebooks: list[Path] = field(default_factory=list)
    of_the_system: list[Path] = field(default_factory=list)
    others: list[Path] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)

    def notes(self, known: Sequence[str] = ()) -> list[str]:
        """What the instructor should know of the files that are not graded; known: files and folders of the grader."""
        ours = [Path(os.path.abspath(path)) for path in known if path]
        self.others = [
            path for path in self.others if not any(Path(os.path.abspath(path)).is_relative_to(one) for one in ours)
        ]
        notes = list(dict.fromkeys(self.unread))
        if self.of_the_system:
            notes.append(f"Left out, as files of the operating system or an editor: {_some(self.of_the_system)}.")
        if self.others:
            unpack = " Unpack what is an archive." if any(map(is_archive, self.others)) else ""
            notes.append(f"Not graded, since the name does not end in .ipynb: {_some(self.others)}.{unpack}")
        return notes


def handed_in(names: Sequence[str]) -> HandedIn:
    """The files that names stand for: files, folders with all in them, patterns that the shell has left as they are.

    Each is there once, in the order of the names. Raises FileNotFoundError if a name stands for nothing, or none for a
    notebook.
    """
    found = HandedIn()
    for name in names:
        matches = [name] if os.path.lexists(name) else sorted(glob.glob(name, recursive=True))
        if not matches:
            raise FileNotFoundError(f"{name}: there is no such file, nor a notebook in it; name what is to be graded")
        for path in map(Path, matches):
            _take_in(path, found)
    once: dict[str, Path] = {}
    for path in found.notebooks:
        once.setdefault(os.path.abspath(path), path)
    found.notebooks = list(once.values())
    if not found.notebooks:
        raise FileNotFoundError(" ".join([f"{', '.join(names)}: there is no notebook in it.", *found.notes()]))
    return found


def _take_in(path: Path, found: HandedIn) -> None:
    if any(map(ALWAYS.fullmatch, path.parts)):
        found.of_the_system.append(path)
    elif not path.is_dir():
        (found.of_the_system if OF_THE_SYSTEM.fullmatch(path.name) else found.notebooks).append(path)
    else:
        for folder, folders, files in os.walk(path, onerror=lambda error: found.unread.append(f"Not read: {error}.")):
            folders.sort()
            links = [each for each in folders if Path(folder, each).is_symlink()]
            found.unread += [f"Not read: {Path(folder, each)} is a link to a folder; name it." for each in links]
            for name in sorted(files):
                file = Path(folder, name)
                inside = file.relative_to(path)
                is_notebook = inside.suffix.lower() == ".ipynb"
                if any(ALWAYS.fullmatch(part) or OF_THE_SYSTEM.fullmatch(part) for part in inside.parts):
                    found.of_the_system += [file] * is_notebook
                else:
                    (found.notebooks if is_notebook else found.others).append(file)


@dataclass(frozen=True)
class Kept:
    """A file, its copy, and why there is none that could be graded.

    What is graded, looked up and compared is the copy: it stays as it is, whatever becomes of the file.
    """

    path: Path
    copy: Path
    problem: str = ""

    @property
    def has_changed(self) -> bool:
        """Whether the file is not as it was when it was copied, or not there any more."""
        if self.problem:
            return False
        try:
            return not filecmp.cmp(self.path, self.copy, shallow=False)
        except OSError:
            return True


def kept(paths: Sequence[Path], folder: Path) -> list[Kept]:
    """Copy each file, under its own name, into a folder of its own in `folder`."""
    return [_kept(path, folder / str(i) / path.name) for i, path in enumerate(paths)]


def _kept(path: Path, copy: Path) -> Kept:
    copy.parent.mkdir()
    if not path.is_file():
        return Kept(path, copy, "It cannot be read: there is no such file any more.")
    try:
        shutil.copyfile(path, copy)
    except OSError as error:
        return Kept(path, copy, f"It cannot be read: {error.strerror}.")
    return Kept(
        path, copy, "It is an archive, not a notebook: unpack it, and grade what is in it." if is_archive(copy) else ""
    )


def is_archive(path: Path) -> bool:
    """Whether a file is a zip archive, whatever its name ends with."""
    with suppress(OSError):
        if path.is_file():  # a pipe, say, could keep who reads it waiting
            with path.open("rb") as file:
                return file.read(4) == b"PK\x03\x04"
    return False


def _some(paths: Sequence[Path]) -> str:
    paths = list(dict.fromkeys(paths))
    more = f" and {len(paths) - NAMED} more" if len(paths) > NAMED else ""
    return ", ".join(map(str, paths[:NAMED])) + more
