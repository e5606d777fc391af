"""Tables that read well as text, in a notebook (HTML) and in a document (Markdown)."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """Rows of words and numbers under named columns.

    caption: what the table is; columns: names; rows: cells, `None` where there is nothing to say
    """

    caption: str
    columns: Sequence[str]
    rows: Sequence[Sequence[object]]

    def __str__(self) -> str:
        lines = [list(self.columns), *self._cells()]
        widths = [max(len(line[i]) for line in lines) for i in range(len(self.columns))]
        ruled = [lines[0], ["-" * width for width in widths], *lines[1:]]
        rows = ["  ".join(c.rjust(w) if n else c.ljust(w) for c, w, n in self._laid(line, widths)) for line in ruled]
        return "\n".join([self.caption, "", *(row.rstrip() for row in rows)])

    __repr__ = __str__

    @property
    def markdown(self) -> str:
        """The table for a Markdown document."""
        rule = ["---:" if number else ":---" for number in self._is_number()]
        lines = [[c.replace("|", "\\|") for c in line] for line in (self.columns, rule, *self._cells())]
        return "\n".join([f"**{self.caption}**", "", *(f"| {' | '.join(line)} |" for line in lines)])

    def _repr_markdown_(self) -> str:
        return self.markdown

    def _repr_html_(self) -> str:
        def row(cells: Sequence[str], tag: str) -> str:
            sides = ["right" if number else "left" for number in self._is_number()]
            cells = [
                f'<{tag} style="text-align: {side}">{html.escape(cell)}</{tag}>'
                for cell, side in zip(cells, sides, strict=True)
            ]
            return f"<tr>{''.join(cells)}</tr>"

        body = "".join(row(cells, "td") for cells in self._cells())
        head = f"<caption>{html.escape(self.caption)}</caption><thead>{row(self.columns, 'th')}</thead>"
        return f"<table>{head}<tbody>{body}</tbody></table>"

    def _cells(self) -> list[list[str]]:
        return [[as_text(cell) for cell in row] for row in self.rows]

    def _is_number(self) -> list[bool]:
        columns = zip(*self.rows, strict=True) if self.rows else [()] * len(self.columns)
        return [any(isinstance(cell, float | int) for cell in column) for column in columns]

    def _laid(self, line: Sequence[str], widths: Sequence[int]) -> Iterable[tuple[str, int, bool]]:
        return zip(line, widths, self._is_number(), strict=True)


def as_text(cell: object) -> str:
    """A number with the digits that matter, anything else as it is."""
    if cell is None:
        return ""
    if not isinstance(cell, float):
        return str(cell)
    if cell != 0 and abs(cell) < 5e-4:
        return f"{cell:.2e}"
    return f"{cell:.4f}" if abs(cell) < 0.1 else f"{cell:.2f}" if abs(cell) >= 1 else f"{cell:.3f}"
