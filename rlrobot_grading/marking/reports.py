"""Reports of graded notebooks: as text, as sheets, as Gradescope's ``results.json``; and where it is written."""

from __future__ import annotations

import json
import os
import re
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path

from rlrobot_edu.files import write_whole
from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.attribution import CANVAS, MOODLE
from rlrobot_grading.marking.marks import Marked, Score
from rlrobot_grading.marking.rooms import room_of

CELLS = re.compile(r"\b([Cc]ode cells? )(\d+(?:, \d+)*)")
# A file that only the kernel knows, as in "(190330142.py, line 1)"
LINE = re.compile(r"\b([Cc]ode cell )(\d+)( .*?)\((?:\d+\.py|<[^<>]*>), line (\d+)\)")
NOBODY_TYPES = re.compile(r"(EOFError|StdinNotImplementedError): [^\n.]*\.?")
NOBODY_TYPES_TOLD = (
    r"\1: it asks with input(), and nobody is there to type while it is graded."
)
LONGEST = 40  # of a line that is shown
KINDS = {
    "--csv": ".csv",
    "--mistakes": ".csv",
    "--gradescope": ".json",
}  # what a report is, by its option


def as_text(one: Marked) -> str:
    """What a terminal shows of one notebook: points, and remarks on each exercise."""
    where = f" ({_title(one)})" * bool(one.lesson)
    if one.problem:
        return "\n".join(
            [f"{one.name}: not graded{where}", f"  {one.problem}", *_notes(one)]
        )
    lines = [f"{one.name}: {one.score:g} of {one.max_score:g} points{where}"]
    for score in one.scores:
        lines.append(f"  {score.exercise:<20} {score.score:g}/{score.max_score:g}")
        if score.score < score.max_score or score.lent:
            lines.append(textwrap.indent(_said(score), "      "))
    if one.off:
        lines.append(f"  {one.student.late:g} days late: {one.off:g} points off")
    return "\n".join(lines + _notes(one))


def _notes(one: Marked) -> list[str]:
    return [f"  Note: {note}" for note in one.notes if note != one.problem]


def _said(score: Score) -> str:
    return "Not answered yet." if score.is_blank else score.output


def _title(one: Marked) -> str:
    return room_of(one.lesson).replace("_", " ")


def as_sheet(one: Marked, sections: Mapping[str, str], day: date) -> str:
    """What a student gets back, in Markdown: the points, and for each that is missing why, and where to look again.

    sections: the heading under which each exercise stands in the notebook, by its name; day: of the grading
    """
    id = one.student.id or Path(one.name).stem
    student = f"{one.student.name} ({id})" if one.student.name else id
    title = f"{student}, {_title(one)}" if one.lesson else student
    graded = f"`{Path(one.name).name}`, graded on {day.isoformat()}."
    if one.problem:
        again = (
            "Save it again in Jupyter, as a file that ends in .ipynb, and hand that in."
        )
        return "\n".join(
            [f"# {title}: not graded", "", graded, "", one.problem, "", again, ""]
        )
    lines = [f"# {title}: {one.score:g} of {one.max_score:g} points", "", graded, ""]
    if one.off:
        points = f"{one.score + one.off:g} points for the answers"
        lines += [
            f"{points}; {one.student.late:g} days late: {one.off:g} points off.",
            "",
        ]
    for score in one.scores:
        if not score.max_score:
            lines += [f"- `{score.exercise}`: does not count", ""]
        elif score.score == score.max_score:
            lent = f", with the right `{score.lent}` in place of yours" * bool(
                score.lent
            )
            lines += [f"- `{score.exercise}`: right{lent}", ""]
        elif score.is_blank:
            lines += [
                f"- `{score.exercise}`: not answered yet, 0 of {score.max_score:g}",
                "",
            ]
        else:
            points = f"## `{score.exercise}`: {score.score:g} of {score.max_score:g}"
            lines += [points, "", "```text", score.output, "```", ""]
            if score.exercise in sections:
                lines += [
                    f"To look at again: *{sections[score.exercise]}*, in your notebook.",
                    "",
                ]
    return "\n".join(lines)


def as_gradescope(one: Marked) -> str:
    """Gradescope's ``results.json``: a visible test for each exercise, and what only the instructor should see."""
    tests = [
        {"name": score.exercise, "score": score.score, "max_score": score.max_score, "output": score.output,
         "status": "passed" if score.score == score.max_score else "failed", "visibility": "visible"}
        for score in one.scores
    ]  # fmt: skip
    if one.notes:
        tests.append(
            {"name": "notes for the instructor", "score": 0.0, "max_score": 0.0, "output": "\n".join(one.notes),
             "visibility": "hidden"}
        )  # fmt: skip
    return (
        json.dumps({"score": one.score, "tests": tests}, indent=1, ensure_ascii=False)
        + "\n"
    )


def placed(one: Marked, cells: Sequence[str]) -> Marked:
    """A marked notebook, with the cells and lines that its messages name shown."""
    scores = [
        replace(score, output=in_words(score.output, cells)) for score in one.scores
    ]
    return replace(
        one, scores=scores, notes=[in_words(note, cells) for note in one.notes]
    )


def in_words(text: str, cells: Sequence[str]) -> str:
    """A message, with the first line of each code cell that it names, and with the line of an error."""

    def line(match: re.Match[str]) -> str:
        shown = _shown(_lines(cells, match[2])[int(match[4]) - 1 : int(match[4])])
        return (
            f"{match[1]}{match[2]}{match[3].rstrip()}, in its line {match[4]}{shown}"
            if shown
            else match[0]
        )

    def first(match: re.Match[str]) -> str:
        told = (
            n + _shown([line for line in _lines(cells, n) if line.strip()])
            for n in match[2].split(", ")
        )
        return match[1] + ", ".join(told)

    return CELLS.sub(first, LINE.sub(line, NOBODY_TYPES.sub(NOBODY_TYPES_TOLD, text)))


def _lines(cells: Sequence[str], number: str) -> list[str]:
    return cells[int(number) - 1].splitlines() if 0 < int(number) <= len(cells) else []


def _shown(lines: Sequence[str]) -> str:
    """The first of the lines, in brackets; nothing if there is none."""
    return f" (“{one_line(lines[0].strip(), LONGEST)}”)" if lines else ""


def check_paths(
    reports: Mapping[str, str], folder: str, inputs: Iterable[str | Path]
) -> None:
    """Raise ValueError if a report cannot be written to its path, or would be written over an input or another report.

    reports: paths by their options; folder: of the sheets, empty if there is none
    """
    inputs, taken = list(inputs), dict(reports)
    for option, path in reports.items():
        if Path(path).is_dir():
            raise ValueError(
                f"{option} {path}: this is a folder; give the name of a file"
            )
        _check_folder(option, path, Path(path).absolute().parent)
    if folder:
        taken["--feedback"] = folder
        _check_folder("--feedback", folder, Path(folder).absolute())
    for option, path in taken.items():
        if over := next((str(one) for one in inputs if _are_one(path, one)), ""):
            raise ValueError(
                f"{option} {path} would be written over {over}, which is an input: choose another path"
            )
        if other := next(
            (
                name
                for name, one in taken.items()
                if name < option and _are_one(path, one)
            ),
            "",
        ):
            raise ValueError(
                f"{other} and {option} have the same path, {path}: choose two"
            )
        if (kind := KINDS.get(option, "")) and Path(path).suffix.lower() not in (
            "",
            kind,
        ):
            raise ValueError(
                f"{option} {path}: this report is a {kind} file; give its name that ending"
            )


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
        except (
            Exception
        ) as error:  # whatever it is, the points are there and should be told
            print(
                f"{path} could not be written: {one_line(f'{type(error).__name__}: {error}')}",
                file=sys.stderr,
            )
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
    return "__".join(
        part for part in near.with_suffix("").parts if part not in (near.anchor, "..")
    )
