"""Tables that read well as text and in a notebook (HTML)."""

import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """Rows of words and numbers under named columns.

    caption: what the table is; columns: names; rows: cells, `None` where there is nothing to say
    """

    caption: str
    columns: Sequence[str]
    rows: Sequence[Sequence[object]]

    def __repr__(self) -> str:
        flush, lines = self.lines(_in_a_line)
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        lines.insert(1, ["-" * width for width in widths])
        formats = [f"{sign}{width}" for sign, width in zip(flush, widths, strict=True)]
        rows = ("  ".join(map(format, line, formats)).rstrip() for line in lines)
        return "\n".join([_in_a_line(self.caption), "", *rows])

    def _repr_html_(self) -> str:
        flush, (head, *body) = self.lines(html.escape)
        sides = ["right" if sign == ">" else "left" for sign in flush]

        def row(cells: Sequence[str], tag: str) -> str:
            both = zip(sides, cells, strict=True)
            shown = (
                f'<{tag} style="text-align: {side}">{cell}</{tag}>'
                for side, cell in both
            )
            return f"<tr>{''.join(shown)}</tr>"

        title = f"<caption>{html.escape(self.caption)}</caption><thead>{row(head, 'th')}</thead>"
        return f"<table>{title}<tbody>{''.join(row(cells, 'td') for cells in body)}</tbody></table>"

    def lines(self, escape: Callable[[str], str]) -> tuple[list[str], list[list[str]]]:
        """On which side each column is flush, numbers on the right (>); and cells as text, names first."""
        columns = (
            zip(*self.rows, strict=True) if self.rows else ((),) * len(self.columns)
        )
        flush = [
            ">" if any(isinstance(cell, float | int) for cell in column) else "<"
            for column in columns
        ]
        return flush, [
            [escape(as_text(cell)) for cell in row]
            for row in (self.columns, *self.rows)
        ]


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
    return (
        f"{cell:.4f}"
        if abs(cell) < 0.1
        else f"{cell:.2f}"
        if abs(cell) >= 1
        else f"{cell:.3f}"
    )
