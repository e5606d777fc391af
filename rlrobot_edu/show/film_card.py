"""The card that a page without scripts shows of a film: its words, the moving picture, and a pause.

A GIF cannot stand still, so what is paused gives its place to a picture that does. Where a page drops style sheets, as
GitHub does, both stand one below the other, in the colours of that page.
"""

from rlrobot_edu.show.palette import DARK, LIGHT

PAUSE = "‖ Pause"
PLAY = "▶ Play"


def _either(name: str) -> str:
    """This colour of the palette, light or dark as the card is."""
    return f"light-dark({LIGHT[name]}, {DARK[name]})"


# A reader who wants no motion has the still picture first. Themes: of pages, JupyterLab, VS Code and Colab
STYLE = f"""<style>
.rl-film {{ color-scheme: light dark; box-sizing: border-box; padding: 8px 10px; border: 1px solid {_either("line")};
border-radius: 12px; background: {_either("paper")}; color: {_either("ink")}; font: 16px/1.4 system-ui, sans-serif }}
:is([data-theme=light], [data-jp-theme-light=true], .vscode-light) .rl-film {{ color-scheme: light }}
:is([data-theme=dark], [data-jp-theme-light=false], .vscode-dark, [theme=dark]) .rl-film {{ color-scheme: dark }}
.rl-film p {{ margin: 0 6px; font: 600 19px/1.3 Georgia, serif }}
.rl-film p + p {{ margin: 2px 6px 0; font: 14px/1.4 system-ui, sans-serif; color: {_either("faint")} }}
.rl-film .green {{ color: {_either("green")} !important }}
.rl-film .red {{ color: {_either("red")} !important }}
.rl-film .grey {{ color: {_either("grey")} !important }}
.rl-film label {{ display: inline-block !important; margin: 4px 6px; padding: 3px 10px;
border: 1px solid {_either("blue")}; border-radius: 9px; font-size: 14px; cursor: pointer }}
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


def card(words: str, moving: str, still: str, width: int) -> str:
    """A film's card.

    words, moving, still: as HTML, what stands above, the moving picture, and the one that takes its place
    width: of the pictures [pixels of a page]
    """
    pause = '<label hidden><input type="checkbox" aria-label="Pause or play"></label>'
    return (
        f'{STYLE}<div class="rl-film" style="max-width: {width + 28}px">{words}{pause}'
        f'<div class="moving">{moving}</div><div class="still">{still}</div></div>'
    )


def swatch(name: str) -> str:
    """A mark in this colour of the palette, to stand before its meaning."""
    return f'<span class="{name}" style="color: {LIGHT[name]}">■</span>&nbsp;'
