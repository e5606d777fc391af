"""The card that a page without scripts shows of films: words, moving pictures, a pause, and below it the key.

A GIF cannot stand still, so what is paused gives its place to pictures that do. Where a page drops style sheets, as
GitHub does, all stand one below the other, in the colours of that page.
"""

from collections.abc import Iterable, Iterator, Sequence
from html import escape
from typing import NamedTuple

from rlrobot_edu.show.display import Still, address
from rlrobot_edu.show.palette import DARK, LIGHT

PAUSE = "‖ Pause"
PLAY = "▶ Play"
IN_A_ROW = 2  # pictures that stand still


class Reel(NamedTuple):
    """One film of a card.

    moving: it; stills: what takes its place while it is paused, each with its caption
    name, said: what stands above it; empty if the card says it
    """

    moving: Still
    stills: Sequence[tuple[str, Still]]
    name: str = ""
    said: str = ""


def _either(name: str) -> str:
    """This colour of the palette, light or dark as the card is."""
    return f"light-dark({LIGHT[name]}, {DARK[name]})"


# A reader who wants no motion has the still pictures first. Themes: of pages, JupyterLab, VS Code and Colab.
# Pages have looks of their own for tables and pictures, which are not meant here.
STYLE = f"""<style>
.rl-film {{ color-scheme: light dark; --ink: {_either("ink")}; --faint: {_either("faint")};
box-sizing: border-box; padding: 10px 12px; border: 1px solid {_either("line")}; border-radius: 12px;
background: {_either("paper")}; color: var(--faint); font: .9rem/1.4 system-ui, sans-serif }}
:is([data-theme=light], [data-jp-theme-light=true], .vscode-light) .rl-film {{ color-scheme: light }}
:is([data-theme=dark], [data-jp-theme-light=false], .vscode-dark, [theme=dark]) .rl-film {{ color-scheme: dark }}
.rl-film p {{ margin: 0 0 6px; font: inherit; color: inherit }}
.rl-film br {{ display: none }}
.rl-film b {{ color: var(--ink) }}
.rl-film .title {{ margin: 0 0 2px; font: 600 1.15rem/1.3 Georgia, serif }}
.rl-film .green {{ color: {_either("green")} !important }}
.rl-film .red {{ color: {_either("red")} !important }}
.rl-film .grey {{ color: {_either("grey")} !important }}
.rl-film img {{ display: block; width: 100%; height: auto; margin: 0 0 4px; border-radius: 8px }}
.rl-film :is(table, tbody, tr, td) {{ display: block; box-sizing: border-box; max-width: none; margin: 0; padding: 0;
border: 0; text-align: left; white-space: normal; font: inherit; color: inherit }}
.rl-film :is(table, tbody, tr, td, img) {{ background: none !important }}
.rl-film tr {{ display: flex; flex-wrap: wrap; gap: 10px; margin: 0 0 6px }}
.rl-film td {{ flex: 1 1 240px; min-width: 0 }}
.rl-film .still td {{ flex-basis: 40% }}
.rl-film label {{ display: inline-block !important; margin: 6px 0 8px; padding: 4px 12px;
border: 1px solid {_either("blue")}; border-radius: 9px; color: var(--ink); cursor: pointer }}
.rl-film label:focus-within {{ outline: 3px solid {_either("focus")} }}
.rl-film input {{ position: absolute; opacity: 0 }}
.rl-film label::after {{ content: "{PAUSE}" }}
.rl-film:has(:checked) label::after {{ content: "{PLAY}" }}
.rl-film .still, .rl-film:has(:checked) .moving {{ display: none }}
.rl-film:has(:checked) .still {{ display: block }}
@media (prefers-reduced-motion: reduce) {{
.rl-film label::after {{ content: "{PLAY}" }}
.rl-film:has(:checked) label::after {{ content: "{PAUSE}" }}
.rl-film .moving, .rl-film:has(:checked) .still {{ display: none }}
.rl-film .still, .rl-film:has(:checked) .moving {{ display: block }}
}}
</style>""".replace("\n", " ")
BUTTON = '<label hidden><input type="checkbox" aria-label="Pause or play"></label>'


def card(title: str, line: str, reels: Sequence[Reel], key: str, width: int) -> str:
    """A card of films that run side by side; on a narrow page one below the other.

    title: what became of them; line: what one sees, as HTML; key: what else is to be known, as HTML; each may be empty
    width: of all films together [pixels of a page]
    """
    films = ["".join(_parts(reel)) for reel in reels]
    shown = films[0] if len(films) == 1 else _row(films)
    return (
        f'{STYLE}<div class="rl-film" style="max-width: {width + 26}px">'
        f"{_paragraph(escape(title), 'title')}{_paragraph(line)}"
        f"{shown}{BUTTON}{_paragraph(key)}</div>"
    )


def swatch(name: str) -> str:
    """A mark in this colour of the palette, and its name, to stand before its meaning."""
    return f'<span class="{name}" style="color: {LIGHT[name]}">■</span>&nbsp;{name}'


def _parts(reel: Reel) -> Iterator[str]:
    """A film on its card: its words, the moving picture, and the pictures that take its place."""
    if reel.name:
        yield f"<p><b>{escape(reel.name)}</b>: {escape(reel.said)}</p>"
    yield f'<div class="moving">{_picture(reel.moving)}</div>'
    cells = [f"{_picture(still)}<br>{escape(words)}" for words, still in reel.stills]
    if len(cells) > 1:
        pairs = (cells[i : i + IN_A_ROW] for i in range(0, len(cells), IN_A_ROW))
        cells = [_row(pair) for pair in pairs]
    yield f'<div class="still">{"".join(cells)}</div>'


def _row(cells: Iterable[str]) -> str:
    """Cells side by side, also where a page drops style sheets."""
    inside = "".join(f"<td>{cell}</td>" for cell in cells)
    return f'<table role="presentation"><tr>{inside}</tr></table>'


def _paragraph(inside: str, kind: str = "") -> str:
    """A paragraph with this HTML; none if it is empty. The title stays bold where style sheets are dropped."""
    if not inside:
        return ""
    if kind:
        return f'<p class="{kind}"><b>{inside}</b></p>'
    return f"<p>{inside}</p>"


def _picture(still: Still) -> str:
    """A picture as wide as its place, at most as its file."""
    source = address(still.data, still.mime)
    return f'<img alt="{escape(still.alt)}" width="{still.width}" src="{source}">'
