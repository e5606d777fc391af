"""Which cell, and which line: what the grader says of code cells, so that it can be found in a notebook.

No editor numbers code cells, so a cell is also told by its first line, and an error in it by the line itself.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from rlrobot_course.grading.values import one_line
from rlrobot_course.homework.marks import Marked

CELLS = re.compile(r"\b([Cc]ode cells? )(\d+(?:, \d+)*)")
# A file that only the kernel knows, as in "(190330142.py, line 1)"
LINE = re.compile(r"\b([Cc]ode cell )(\d+)( .*?)\((?:\d+\.py|<[^<>]*>), line (\d+)\)")
NOBODY_TYPES = re.compile(r"(EOFError|StdinNotImplementedError): [^\n.]*\.?")
NOBODY_TYPES_TOLD = r"\1: it asks with input(), and nobody is there to type while it is graded."
LONGEST = 40  # of a line that is shown


def placed(one: Marked, cells: Sequence[str]) -> Marked:
    """A marked notebook, with the cells and lines that its messages name shown."""
    scores = [replace(score, output=in_words(score.output, cells)) for score in one.scores]
    return replace(one, scores=scores, notes=[in_words(note, cells) for note in one.notes])


def in_words(text: str, cells: Sequence[str]) -> str:
    """A message, with the first line of each code cell that it names, and with the line of an error."""

    def line(match: re.Match[str]) -> str:
        shown = _shown(_lines(cells, match[2])[int(match[4]) - 1 : int(match[4])])
        return f"{match[1]}{match[2]}{match[3].rstrip()}, in its line {match[4]}{shown}" if shown else match[0]

    def first(match: re.Match[str]) -> str:
        told = (n + _shown([line for line in _lines(cells, n) if line.strip()]) for n in match[2].split(", "))
        return match[1] + ", ".join(told)

    return CELLS.sub(first, LINE.sub(line, NOBODY_TYPES.sub(NOBODY_TYPES_TOLD, text)))


def _lines(cells: Sequence[str], number: str) -> list[str]:
    return cells[int(number) - 1].splitlines() if 0 < int(number) <= len(cells) else []


def _shown(lines: Sequence[str]) -> str:
    """The first of the lines, in brackets; nothing if there is none."""
    return f" (“{one_line(lines[0].strip(), LONGEST)}”)" if lines else ""
