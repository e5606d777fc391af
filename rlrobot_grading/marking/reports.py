"""Reports of graded notebooks: what a terminal shows, a sheet for each student, and where reports are written."""

from __future__ import annotations

import os
import re
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path

from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.course import title_of
from rlrobot_grading.marking.marks import Marked, Score

CELLS = re.compile(r"\b([Cc]ode cells? )(\d+(?:, \d+)*)")
# A file that only the kernel knows, as in "(190330142.py, line 1)"
LINE = re.compile(r"\b([Cc]ode cell )(\d+)( .*?)\((?:\d+\.py|<[^<>]*>), line (\d+)\)")
NO_INPUT = re.compile(r"(EOFError|StdinNotImplementedError): [^\n.]*\.?")
INPUT = r"\1: it asks with input(), and nobody is there to type while it is graded."
LONGEST = 40  # of a line that is shown
AGAIN = "Save it again in Jupyter, as a file that ends in .ipynb, and hand that in."


def as_text(one: Marked) -> str:
    """Return what a terminal shows of one notebook: points, and remarks on each exercise."""
    where = f" ({title_of(one.lesson)})" if one.lesson else ""
    notes = [f"  Note: {note}" for note in one.notes if note != one.problem]
    if one.problem:
        return "\n".join([f"{one.name}: not graded{where}", f"  {one.problem}", *notes])
    lines = [f"{one.name}: {one.score:g} of {one.max_score:g} points{where}"]
    for score in one.scores:
        lines.append(f"  {score.exercise:<20} {score.score:g}/{score.max_score:g}")
        if score.is_blank:
            lines.append("      Not answered yet.")
        elif score.score < score.max_score or score.substituted:
            lines.append(textwrap.indent(score.output, "      "))
    if one.off:
        lines.append(f"  {one.student.late:g} days late: {one.off:g} points off")
    return "\n".join(lines + notes)


def as_sheet(one: Marked, sections: Mapping[str, str], day: date) -> str:
    """Return what a student gets back, in Markdown: points, why some are missing, and where to look again.

    sections: the heading under which each exercise stands in the notebook, by its name; day: of the grading
    """
    id = one.student.id or Path(one.name).stem
    title = f"{one.student.name} ({id})" if one.student.name else id
    if one.lesson:
        title += f", {title_of(one.lesson)}"
    graded = f"`{Path(one.name).name}`, graded on {day.isoformat()}."
    if one.problem:
        parts = [f"# {title}: not graded", graded, one.problem, AGAIN]
        return "\n\n".join(parts) + "\n"
    parts = [f"# {title}: {one.score:g} of {one.max_score:g} points", graded]
    if one.off:
        parts.append(
            f"{one.score + one.off:g} points for the answers; {one.student.late:g} days late: {one.off:g} points off."
        )
    for score in one.scores:
        parts.append(_on_sheet(score, sections.get(score.exercise, "")))
    return "\n\n".join(parts) + "\n"


def _on_sheet(score: Score, section: str) -> str:
    """Return what the sheet says of one exercise; section: where it stands in the notebook."""
    if not score.max_score:
        return f"- `{score.exercise}`: does not count"
    if score.is_blank:
        return f"- `{score.exercise}`: not answered yet, 0 of {score.max_score:g}"
    if score.score == score.max_score and score.substituted:
        return f"- `{score.exercise}`: right, with the right `{score.substituted}` in place of yours"
    if score.score == score.max_score:
        return f"- `{score.exercise}`: right"
    points = f"## `{score.exercise}`: {score.score:g} of {score.max_score:g}"
    said = f"{points}\n\n```text\n{score.output}\n```"
    if section:
        said += f"\n\nTo look at again: *{section}*, in your notebook."
    return said


def with_cells_shown(one: Marked, cells: Sequence[str]) -> Marked:
    """Return a marked notebook, with the cells and lines that its messages name shown."""
    scores = [
        replace(score, output=cells_shown(score.output, cells)) for score in one.scores
    ]
    notes = [cells_shown(note, cells) for note in one.notes]
    return replace(one, scores=scores, notes=notes)


def cells_shown(text: str, cells: Sequence[str]) -> str:
    """Return a message with the first line of each code cell that it names, and with the line of an error."""

    def with_line(match: re.Match[str]) -> str:
        number = int(match[4])
        shown = _shown(_lines(cells, match[2])[number - 1 : number])
        if not shown:
            return match[0]
        return f"{match[1]}{match[2]}{match[3].rstrip()}, in its line {number}{shown}"

    def with_first_lines(match: re.Match[str]) -> str:
        named = []
        for number in match[2].split(", "):
            lines = [line for line in _lines(cells, number) if line.strip()]
            named.append(number + _shown(lines))
        return match[1] + ", ".join(named)

    text = NO_INPUT.sub(INPUT, text)
    return CELLS.sub(with_first_lines, LINE.sub(with_line, text))


def _lines(cells: Sequence[str], number: str) -> list[str]:
    return cells[int(number) - 1].splitlines() if 0 < int(number) <= len(cells) else []


def _shown(lines: Sequence[str]) -> str:
    """Return the first of the lines, in brackets; nothing if there is none."""
    return f" (“{one_line(lines[0].strip(), LONGEST)}”)" if lines else ""


def check_paths(reports: Mapping[str, str], inputs: Iterable[str | Path]) -> None:
    """Raise ValueError if a report would be written over an input or another report.

    reports: paths by their options
    """
    taken = {os.path.realpath(path): str(path) for path in inputs}
    for option, path in reports.items():
        real = os.path.realpath(path)
        if real in taken:
            raise ValueError(
                f"{option} {path} would be written over {taken[real]}: choose another path"
            )
        taken[real] = path
        if option == "--feedback":
            if os.path.isfile(path):
                raise ValueError(f"{option} {path}: this is a file, not a folder")
        elif os.path.isdir(path):
            raise ValueError(
                f"{option} {path}: this is a folder; give the name of a file"
            )


def write_each(reports: Mapping[str, Callable[[], str]]) -> bool:
    """Make and write reports, by their paths; whether all have been written. One that cannot be costs no other."""
    written = True
    for path, made in reports.items():
        try:
            text = made()
            Path(path).parent.mkdir(parents=True, exist_ok=True)
            Path(path).write_text(text, encoding="utf-8")
        except (
            Exception
        ) as error:  # whatever it is, the points are known and can be said
            why = one_line(f"{type(error).__name__}: {error}")
            print(f"{path} could not be written: {why}", file=sys.stderr)
            written = False
    return written


def sheet_names(marked: Iterable[Marked]) -> Iterator[str]:
    """Return the names of sheets: of the student, or else of the notebook, and of the lesson; none is there twice."""
    taken: set[str] = set()
    for one in marked:
        words = [one.student.id or Path(one.name).stem]
        if one.lesson:
            words.append(title_of(one.lesson))
        name = re.sub(r"[^\w.@-]+", "_", "_".join(words))
        number = 2
        unique = name
        while unique.lower() in taken:
            unique = f"{name}_{number}"
            number += 1
        taken.add(unique.lower())
        yield f"{unique}.md"
