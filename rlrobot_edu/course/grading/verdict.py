"""What a check says to the learner."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

WIDTH = 100  # characters of a line, so that no output of a notebook must be scrolled sideways


@dataclass(frozen=True)
class Verdict:
    """The judgement on one answer; true if the answer is right.

    status: ``waiting``, ``right`` or ``wrong``
    text: what is to be said, one sentence or two
    called: the arguments of the first wrong step, in words
    rows: name, expected and got, side by side
    hint: the likely cause, where one is known
    """

    status: str
    text: str
    called: str = ""
    rows: tuple[tuple[str, str, str], ...] = ()
    hint: str = ""

    def __bool__(self) -> bool:
        return self.status == "right"

    def __repr__(self) -> str:
        mark = {"waiting": "…", "right": "✓", "wrong": "✗"}[self.status]
        lines = textwrap.wrap(f"{mark} {self.text}", WIDTH)
        if self.called:
            lines += textwrap.wrap(f"  called with {self.called}", WIDTH, subsequent_indent=" " * 14)
        if self.rows:
            table = [("", "expected", "got"), *self.rows]
            widths = [max(len(row[column]) for row in table) for column in range(3)]
            lines += ["  " + "   ".join(f"{cell:>{w}}" for cell, w in zip(row, widths, strict=True)) for row in table]
        if self.hint:
            lines += textwrap.wrap(f"Hint: {self.hint}", WIDTH)
        return "\n".join(lines)
