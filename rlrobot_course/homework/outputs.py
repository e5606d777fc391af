"""Where reports go: what would cost an input is refused beforehand, and each report is written by itself."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

from rlrobot_course.grading.values import one_line
from rlrobot_course.homework.rooms import room_of
from rlrobot_course.homework.whose import CANVAS, MOODLE
from rlrobot_edu.files import write_whole


def check_paths(reports: Mapping[str, str], folder: str, inputs: Iterable[str | Path]) -> None:
    """Raise ValueError if a report cannot be written to its path, or would be written over an input or another report.

    reports: paths by their options; folder: of the sheets, empty if there is none
    """
    inputs, taken = list(inputs), dict(reports)
    for option, path in reports.items():
        if Path(path).is_dir():
            raise ValueError(f"{option} {path}: this is a folder; give the name of a file")
        _check_folder(option, path, Path(path).absolute().parent)
    if folder:
        taken["--feedback"] = folder
        _check_folder("--feedback", folder, Path(folder).absolute())
        for path in inputs:
            if Path(path).suffix == ".md" and Path(_real(folder)) in Path(_real(path)).parents:
                raise ValueError(f"--feedback {folder}: {path} lies there, and sheets are .md files, too")
    for option, path in taken.items():
        if over := next((str(one) for one in inputs if _are_one(path, one)), ""):
            raise ValueError(f"{option} {path} would be written over {over}, which is an input: choose another path")
        if other := next((name for name, one in taken.items() if name < option and _are_one(path, one)), ""):
            raise ValueError(f"{other} and {option} have the same path, {path}: choose two")


def _check_folder(option: str, path: str, folder: Path) -> None:
    """Raise ValueError if a folder cannot be made, or written into."""
    there = next(each for each in (folder, *folder.parents) if os.path.lexists(each))
    if not there.is_dir():
        raise ValueError(f"{option} {path}: {there} is a file, not a folder")
    if not os.access(there, os.W_OK):
        raise ValueError(f"{option} {path}: nothing can be written in {there}")


def _are_one(path: str | Path, other: str | Path) -> bool:
    """Whether two paths are of the same file, perhaps by a link."""
    try:
        return os.path.samefile(path, other)
    except OSError:  # one of them is not there yet
        return _real(path) == _real(other)


def _real(path: str | Path) -> str:
    """A path without links; unlike Path.resolve, also of links that lead in a circle."""
    return os.path.realpath(path)


def write_each(reports: Mapping[str, Callable[[], str]]) -> bool:
    """Make and write reports, by their paths; whether all have been written. One that cannot be costs no other."""
    written = True
    for path, made in reports.items():
        try:
            write_whole(path, made())
        except Exception as error:  # whatever it is, the points are there and should be told
            print(f"{path} could not be written: {one_line(f'{type(error).__name__}: {error}')}", file=sys.stderr)
            written = False
    return written


def sheet_names(handed_in: Iterable[tuple[str, str, str]]) -> Iterator[str]:
    """The names of sheets: of the student and the lesson; as Moodle or Canvas take them back, if they come from there.

    handed_in: for each sheet the path of the notebook, the student's id if there is a list, and the lesson
    """
    taken: set[str] = set()
    for path, student, lesson in handed_in:
        name = _sheet_name(Path(path), student, lesson)
        if name.lower() in taken:
            name = f"{_flat(Path(path))}.md"
        taken.add(name.lower())
        yield name


def _sheet_name(path: Path, student: str, lesson: str) -> str:
    if CANVAS.match(path.name) or MOODLE.search(path.name):
        return f"{path.stem}.md"
    if MOODLE.search(path.parent.name):
        return f"{path.parent.name}/{path.stem}.md"
    if student:
        words = (re.sub(r"[^\w.@-]+", "_", student), room_of(lesson) if lesson else "")
        return f"{'_'.join(word for word in words if word)}.md"
    return f"{_flat(path)}.md"


def _flat(path: Path) -> str:
    """A path as one name, for in some hand-ins all notebooks have the same."""
    near = path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
    return "__".join(part for part in near.with_suffix("").parts if part not in (near.anchor, ".."))
