"""Tables that read well as text and in a notebook (HTML)."""

import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """Rows of words and numbers under named columns.

    caption: what the table shows; columns: names; rows: cells, `None` for an empty one
    """

    caption: str
    columns: Sequence[str]
    rows: Sequence[Sequence[object]]

    def __repr__(self) -> str:
        flush, lines = self.lines(_in_a_line)
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        lines.insert(1, ["-" * width for width in widths])
        formats = [f"{sign}{width}" for sign, width in zip(flush, widths, strict=True)]
        shown = [_in_a_line(self.caption), ""]
        for line in lines:
            shown.append("  ".join(map(format, line, formats)).rstrip())
        return "\n".join(shown)

    def _repr_html_(self) -> str:
        flush, (head, *body) = self.lines(html.escape)
        sides = ["right" if sign == ">" else "left" for sign in flush]

        def row(cells: Sequence[str], tag: str) -> str:
            shown = ""
            for side, cell in zip(sides, cells, strict=True):
                shown += f'<{tag} style="text-align: {side}">{cell}</{tag}>'
            return f"<tr>{shown}</tr>"

        title = f"<caption>{html.escape(self.caption)}</caption>"
        names = f"<thead>{row(head, 'th')}</thead>"
        rows = "".join(row(cells, "td") for cells in body)
        return f"<table>{title}{names}<tbody>{rows}</tbody></table>"

    def lines(self, escape: Callable[[str], str]) -> tuple[list[str], list[list[str]]]:
        """The side of each column, right (>) for numbers; and the cells as text, with a first line of names."""
        flush = ["<"] * len(self.columns)
        for row in self.rows:
            for i, cell in enumerate(row):
                if isinstance(cell, float | int):
                    flush[i] = ">"
        lines = []
        for row in (self.columns, *self.rows):
            lines.append([escape(as_text(cell)) for cell in row])
        return flush, lines


def _in_a_line(text: str) -> str:
    return " ".join(text.splitlines())


class Tabled:
    """A mixin: `print` and a notebook show its table."""

    table: Callable[[], Table]

    def __repr__(self) -> str:
        return str(self.table())

    def _repr_html_(self) -> str:
        return self.table()._repr_html_()


def as_text(cell: object) -> str:
    """A number with the digits that matter, anything else as it is."""
    if not isinstance(cell, float):
        return "" if cell is None else str(cell)
    if cell != 0 and abs(cell) < 5e-4:
        return f"{cell:.2e}"
    if abs(cell) < 0.1:
        return f"{cell:.4f}"
    if abs(cell) >= 1:
        return f"{cell:.2f}"
    return f"{cell:.3f}"
