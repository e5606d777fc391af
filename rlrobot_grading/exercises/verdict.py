"""What a check says to the learner: a card in the notebook, and the same in plain text."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from typing import Any

WIDTH = 100  # characters of a line, so that no output of a notebook must be scrolled sideways

# from the Okabe–Ito set, which colour-blind readers tell apart; as those of the figures
BLUE = "#0067a5"
GREEN = "#007a58"
GREY = "#8d877d"
RED = "#c24e00"

AS_GIVEN = "as_given"  # the id where code that is to be mended is unchanged

# status: sign, headline of the card, colour of its edge
LOOKS = {
    "waiting": ("…", "Waiting", GREY),
    "right": ("✓", "Right", GREEN),
    "wrong": ("✗", "Not yet", RED),
    "hint": ("→", "Hint", BLUE),
    "outcome": ("→", "Outcome", BLUE),
    "score": ("★", "Score", GREEN),
}
CARD = "border-left:5px solid {colour};padding:.4em 1em;margin:.2em 0;max-width:60em;line-height:1.45"
CELL = "text-align:left;padding:.1em 1.2em .1em 0;font-family:monospace;background:none"


def side_by_side(table: Sequence[tuple[str, str, str]]) -> list[str]:
    """A table of three columns as lines of text."""
    widths = [max(len(row[column]) for row in table) for column in range(3)]
    return [
        "  " + "   ".join(f"{cell:>{w}}" for cell, w in zip(row, widths, strict=True))
        for row in table
    ]


@dataclass(frozen=True)
class Verdict:
    """The judgement on one answer; true if the answer is right.

    status: ``waiting``, ``right``, ``wrong``; ``hint`` for a hint on request, ``outcome`` of what was predicted;
        ``score`` of an open challenge
    text: what is to be said, one sentence or two
    called: the arguments of the first case that differs, in words
    rows: name, expected and got, side by side
    hint: the likely cause, where one is known
    gained: of a right answer, what has been gained and where it will be used
    id: of the mistake that was recognised, or the name of the detector that has found the hint; never shown
    below: what a notebook shows below the card, if anything
    """

    status: str
    text: str
    called: str = ""
    rows: tuple[tuple[str, str, str], ...] = ()
    hint: str = ""
    gained: str = ""
    id: str = ""
    below: Any = field(default=None, compare=False)

    def __bool__(self) -> bool:
        return self.status == "right"

    def __repr__(self) -> str:
        lines = textwrap.wrap(f"{LOOKS[self.status][0]} {self.text}", WIDTH)
        if self.called:
            lines += textwrap.wrap(
                f"  called with {self.called}", WIDTH, subsequent_indent=" " * 14
            )
        if self.rows:
            lines += side_by_side([("", "expected", "got"), *self.rows])
        if self.hint:
            lines += textwrap.wrap(f"Hint: {self.hint}", WIDTH)
        if self.gained:
            lines += textwrap.wrap(self.gained, WIDTH)
        return "\n".join(lines)

    def _ipython_display_(self) -> None:
        """Show nothing of a check that nobody has answered, in a notebook that is run to be saved."""
        is_saved = os.environ.get("RLROBOT_EDU_PROGRESS") == "0"
        if self.below is not None:
            # IPython calls this, so it is there
            from IPython.display import display

            card = {"text/plain": repr(self), "text/html": self._repr_html_()}
            display(card, raw=True)  # type: ignore[no-untyped-call]
            display(self.below)  # type: ignore[no-untyped-call]
            return
        waits = self.status == "waiting" and not self.gained
        is_untouched = waits or self.id == AS_GIVEN
        if not is_untouched or not is_saved:
            raise NotImplementedError  # IPython shows it as usual

    def _repr_html_(self) -> str:
        sign, headline, colour = LOOKS[self.status]
        parts = [
            f"<b>{sign} {headline}.</b> {escape(self.text.removeprefix('Right. '))}"
        ]
        if self.called:
            parts.append(f"called with <code>{escape(self.called)}</code>")
        if self.rows:
            cells = [("", "expected", "got"), *self.rows]
            rows = (
                "".join(f'<td style="{CELL}">{escape(cell)}</td>' for cell in row)
                for row in cells
            )
            parts.append(
                "<table>" + "".join(f"<tr>{row}</tr>" for row in rows) + "</table>"
            )
        if self.hint:
            parts.append(f"<b>Hint:</b> {escape(self.hint)}")
        if self.gained:
            parts.append(escape(self.gained))
        body = "".join(f'<div style="margin:.2em 0">{part}</div>' for part in parts)
        return f'<div style="{CARD.format(colour=colour)}">{body}</div>'
