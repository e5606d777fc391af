"""The colours and the look of all pages as one style sheet; a page adds only what it alone has."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from rlrobot_edu.show.palette import DARK, LIGHT


def tokens() -> str:
    """The palette as CSS: ``var(--blue)`` is its blue, light or dark as the page is."""
    colours = []
    for name, light in LIGHT.items():
        colours.append(f"--{name}: light-dark({light}, {DARK[name]});")
    return f"html:has(> body.rl-look), :not(body).rl-look {{ {' '.join(colours)} }}\n"


@cache
def look() -> str:
    """Colours, type, buttons and cards: of a page whose body has the class ``rl-look``, or of a widget's element."""
    sheet = files(__package__).joinpath("look.css").read_text("utf-8")
    return tokens() + sheet
