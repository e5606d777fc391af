"""Tables that read well as text, in a notebook (HTML) and in a document (Markdown)."""

from __future__ import annotations

import html
from collections.abc import Sequence
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
        sides, lines = self._lines()
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        lines.insert(1, ["-" * width for width in widths])
        laid = ([f"{c:{side}{w}}" for c, side, w in zip(line, sides, widths, strict=True)] for line in lines)
        return "\n".join([self.caption, "", *("  ".join(cells).rstrip() for cells in laid)])

    __repr__ = __str__

    @property
    def markdown(self) -> str:
        """The table for a Markdown document."""
        sides, (head, *body) = self._lines()
        rule = ["---:" if side == ">" else ":---" for side in sides]
        rows = (" | ".join(cell.replace("|", "\\|") for cell in line) for line in (head, rule, *body))
        return "\n".join([f"**{self.caption}**", "", *(f"| {row} |" for row in rows)])

    def _repr_markdown_(self) -> str:
        return self.markdown

    def _repr_html_(self) -> str:
        sides, (head, *body) = self._lines()

        def row(cells: Sequence[str], tag: str) -> str:
            styles = (f'{tag} style="text-align: {"right" if side == ">" else "left"}"' for side in sides)
            told = (f"<{style}>{html.escape(cell)}</{tag}>" for style, cell in zip(styles, cells, strict=True))
            return f"<tr>{''.join(told)}</tr>"

        caption, rows = html.escape(self.caption), "".join(row(cells, "td") for cells in body)
        return f"<table><caption>{caption}</caption><thead>{row(head, 'th')}</thead><tbody>{rows}</tbody></table>"

    def _lines(self) -> tuple[list[str], list[list[str]]]:
        """On which side each column is flush, numbers on the right (>); and all cells as text, the names first."""
        columns = zip(*self.rows, strict=True) if self.rows else ((),) * len(self.columns)
        sides = [">" if any(isinstance(cell, float | int) for cell in column) else "<" for column in columns]
        return sides, [list(self.columns), *([as_text(cell) for cell in row] for row in self.rows)]


def as_text(cell: object) -> str:
    """A number with the digits that matter, anything else as it is."""
    if cell is None:
        return ""
    if not isinstance(cell, float):
        return str(cell)
    if cell != 0 and abs(cell) < 5e-4:
        return f"{cell:.2e}"
    return f"{cell:.4f}" if abs(cell) < 0.1 else f"{cell:.2f}" if abs(cell) >= 1 else f"{cell:.3f}"
