"""Which files are handed in: the notebooks that names on the command line stand for, and a copy of each that stays."""

from __future__ import annotations

import glob
import os
import re
import shutil
import zipfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.submission import KINDS, LARGEST, is_notebook
from rlrobot_grading.marking.text import ZIP

# What macOS, Windows, Jupyter and editors leave beside the files of people: in a folder, and anywhere
OF_THE_SYSTEM = re.compile(
    r"\..+|thumbs\.db|desktop\.ini|icon\r|~\$.*|#.*#|.*~", re.IGNORECASE
)
ALWAYS = re.compile(
    r"__MACOSX|\.ipynb_checkpoints|\.Trash.*|\$RECYCLE\.BIN", re.IGNORECASE
)
ARCHIVE = re.compile(r".*\.(zip|7z|rar|tar|tgz|gz|bz2|xz)", re.IGNORECASE)
NAMED = 3  # files that a note names
DEEPEST = 3  # archives in each other that are looked into
MOST_UNPACKED = 4 * 2**30  # of all archives [bytes]


@dataclass(frozen=True)
class Kept:
    """A notebook, and its copy; there is none if the file cannot be read.

    What is graded, looked up and compared is the copy: it stays as it is, whatever becomes of the file.

    path: by which it is known; file: on the disk, itself or the archive that it is in
    """

    path: Path
    file: Path
    copy: Path


@dataclass
class HandedIn:
    """Notebooks, and what was not taken for one: files of the operating system, others, and what was not read.

    folder: of the copies
    """

    folder: Path
    notebooks: dict[str, Kept] = field(default_factory=dict)
    of_the_system: list[Path] = field(default_factory=list)
    others: list[Path] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)
    unpacked: int = 0

    def not_read(self, why: object) -> None:
        """Note a file that cannot be read, or is not."""
        self.unread.append(f"Not read: {why}.")

    @property
    def files(self) -> list[Path]:
        """The files on the disk: notebooks and archives."""
        return list(dict.fromkeys(kept.file for kept in self.notebooks.values()))

    def notes(self, known: Sequence[str] = ()) -> list[str]:
        """What the instructor should know of the files that are not graded; known: files and folders of the grader."""
        ours = [Path(os.path.abspath(path)) for path in known if path]
        others = [
            path
            for path in self.others
            if not any(Path(os.path.abspath(path)).is_relative_to(one) for one in ours)
        ]
        notes = list(dict.fromkeys(self.unread))
        if self.of_the_system:
            notes.append(
                f"Left out, as files of the operating system or an editor: {_some(self.of_the_system)}."
            )
        if others:
            notes.append(
                f"Not graded, since these are no notebooks of a lesson: {_some(others)}."
            )
        if any(ARCHIVE.fullmatch(path.name) for path in others):
            notes[-1] += " Unpack what is an archive."
        return notes

    def keep(self, path: Path, file: Path, copied: Path) -> None:
        """Copy a notebook, or what stands in its place, under its own name into a folder of its own."""
        if os.path.abspath(path) in self.notebooks:
            return
        copy = self.folder / str(len(self.notebooks)) / path.name
        copy.parent.mkdir()
        if copied.is_file():  # a pipe, say, could keep who reads it waiting
            with suppress(OSError):
                shutil.copyfile(copied, copy)
        self.notebooks[os.path.abspath(path)] = Kept(path, file, copy)


def handed_in(names: Sequence[str], folder: Path) -> HandedIn:
    """Copy into `folder` what names stand for: files, folders and archives with all in them, and patterns.

    Each is there once, in the order of the names. Raises FileNotFoundError if a name stands for nothing, or none for a
    notebook.
    """
    found = HandedIn(folder)
    for name in names:
        matches = (
            [name] if os.path.lexists(name) else sorted(glob.glob(name, recursive=True))
        )
        if not matches:
            raise FileNotFoundError(
                f"{name}: there is no such file, nor a notebook in it; name what is to be graded"
            )
        for path in map(Path, matches):
            if any(map(ALWAYS.fullmatch, path.parts)):
                found.of_the_system.append(path)
            elif path.is_dir():
                _walk(path, found)
            elif OF_THE_SYSTEM.fullmatch(path.name):
                found.of_the_system.append(path)
            elif not (is_archive(path) and _unpack(path, path, path, found)):
                found.keep(path, path, path)
    if not found.notebooks:
        raise FileNotFoundError(
            " ".join(
                [f"{', '.join(names)}: there is no notebook in it.", *found.notes()]
            )
        )
    return found


def _walk(top: Path, found: HandedIn) -> None:
    for folder, folders, files in os.walk(top, onerror=found.not_read):
        folders.sort()
        for link in (
            path for path in map(Path(folder).joinpath, folders) if path.is_symlink()
        ):
            found.not_read(f"{link} is a link to a folder; name it")
        for file in (Path(folder, name) for name in sorted(files)):
            _take_in(file, file, file, file.relative_to(top), found)


def _take_in(
    path: Path, file: Path, here: Path, inside: Path, found: HandedIn, depth: int = 0
) -> None:
    """Sort one file. path, file: as of `Kept`; here: where it can be read; inside: its path in what was named."""
    if any(
        ALWAYS.fullmatch(part) or OF_THE_SYSTEM.fullmatch(part) for part in inside.parts
    ):
        found.of_the_system += [path] * (path.suffix.lower() == ".ipynb")
    elif not (is_archive(here) and _unpack(path, file, here, found, depth)):
        if is_notebook(here):
            found.keep(path, file, here)
        else:
            found.others.append(path)


def _unpack(
    path: Path, file: Path, here: Path, found: HandedIn, depth: int = 0
) -> bool:
    """Take in what is in a zip archive; whether there is a notebook in it.

    Nothing is written under a name that the archive chooses, and nothing beyond the limits.
    """
    before = len(found.notebooks)
    try:
        with zipfile.ZipFile(here) as archive:
            for member in archive.infolist():
                inside = _inside(member)
                unpacked = any(
                    (folder / inside).is_file()
                    for folder in (path.parent, path.with_suffix(""))
                )
                if unpacked or member.is_dir() or not inside.parts:
                    continue
                if inside.suffix.lower() not in (*KINDS, ".zip") or depth == DEEPEST:
                    found.others.append(path / inside)
                    continue
                data = archive.open(member).read(LARGEST + 1)
                found.unpacked += len(data)
                if len(data) > LARGEST or found.unpacked > MOST_UNPACKED:
                    found.not_read(f"{path / inside} is too large")
                    continue
                place = (
                    found.folder / f"unpacked{found.unpacked}{inside.suffix.lower()}"
                )
                place.write_bytes(data)
                _take_in(path / inside, file, place, inside, found, depth + 1)
                place.unlink()
    except Exception as error:  # of a file that is no archive, or is encrypted, anything may be the matter
        found.not_read(f"{path} ({one_line(str(error))})")
    return len(found.notebooks) > before


def _inside(member: zipfile.ZipInfo) -> Path:
    """The path of a file in an archive: of Windows with backslashes, of macOS in UTF-8 and not said to be."""
    name = member.filename.replace("\\", "/")
    with suppress(UnicodeError):
        name = (
            name if member.flag_bits & 0x800 else name.encode("cp437").decode("utf-8")
        )
    return Path(*(part for part in name.split("/") if part not in ("", ".", "..")))


def is_archive(path: Path) -> bool:
    """Whether a file is a zip archive, whatever its name ends with."""
    with suppress(OSError):
        if path.is_file():
            with path.open("rb") as file:
                return file.read(len(ZIP)) == ZIP
    return False


def _some(paths: Sequence[Path]) -> str:
    paths = list(dict.fromkeys(paths))
    more = f" and {len(paths) - NAMED} more" if len(paths) > NAMED else ""
    return ", ".join(map(str, paths[:NAMED])) + more
