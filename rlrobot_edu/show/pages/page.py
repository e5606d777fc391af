"""One HTML file that holds many views and shows one at a time; the browser needs no kernel and no network."""

import base64
import json
import re
import zlib
from collections.abc import Sequence
from html import escape
from importlib.resources import files
from itertools import zip_longest
from pathlib import Path
from string import Template

from rlrobot_edu.files import write_whole

SPEEDS = (0.5, 1, 2, 5, 10, 20, 30)  # views a second


def save_page(
    path: str | Path,
    title: str,
    views: Sequence[str],
    *,
    unit: str = "step",
    first: int = 0,
    at: int = 0,
    speed: float = 2,
    tables: Sequence[str] = ("",),
    style: str = "",
    below: str = "",
) -> None:
    """Write `views` to a page, whole or not at all. A screen reader reads the text in ``.said span`` of a view aloud.

    views: HTML; first the numbers from `first` on for the first of `tables`, then the same for the next one
    unit: what has a number; at: the number shown first; speed: at which it plays [views a second]
    style: a ``<style>`` for the views; below: HTML that stays while the views change
    A ``<button value="7">`` in a view leads to number 7. Raises ValueError if there is no view.
    """
    if not views:
        raise ValueError(f"{path}: there is nothing to show on a page; it needs at least one {unit}")
    template, script = (files(__package__).joinpath(name).read_text("utf-8") for name in ("page.html", "turning.js"))
    last = first + len(views) // len(tables) - 1
    speeds = "".join(
        f'<option value="{each:g}"{" selected" * (each == speed)}>{each:.3g} a second</option>'
        for each in sorted({*SPEEDS, speed})
    )
    page = Template(template).substitute(
        title=escape(title), unit=escape(unit), first=first, last=last, at=at, speeds=speeds,
        tables="".join(f"<option>{escape(name)}</option>" for name in tables), one_table="hidden" * (len(tables) == 1),
        packed=pack(views, style, below), script=script,
    )  # fmt: skip
    write_whole(path, page)


def pack(views: Sequence[str], style: str = "", below: str = "") -> str:
    """Everything, compressed: the views in columns of like pieces, None for a piece that stays as it was before."""
    columns = []
    for section in zip_longest(*(re.split("(?=<section)", view) for view in views), fillvalue=""):
        pieces = (re.split("(?=<t[dh]|<[gpl])", each) for each in section)  # cells of tables, and what draws in SVG
        for column in zip_longest(*pieces, fillvalue=""):
            before = (None, *column)
            columns.append([None if new == old else new for old, new in zip(before, column, strict=False)])
    text = json.dumps([style, below, columns], ensure_ascii=False, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode("ascii")
