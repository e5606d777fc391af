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
    first: int = 0,
    at: int = 0,
    speed: float = 2,
    style: str = "",
) -> None:
    """Write `views` to a page, whole or not at all. A screen reader reads the text in ``.said span`` of a view aloud.

    views: HTML of the steps with the numbers from `first` on; at: the number shown first
    speed: at which it plays [views a second]; style: a ``<style>`` for the views
    Raises ValueError if there is no view.
    """
    if not views:
        raise ValueError(
            f"{path}: there is nothing to show on a page; it needs at least one step"
        )
    template, script = (
        files(__package__).joinpath(name).read_text("utf-8")
        for name in ("page.html", "turning.js")
    )
    last = first + len(views) - 1
    speeds = "".join(
        f'<option value="{each:g}"{" selected" * (each == speed)}>{each:.3g} a second</option>'
        for each in sorted({*SPEEDS, speed})
    )
    page = Template(template).substitute(
        title=escape(title), first=first, last=last, at=at, speeds=speeds, packed=pack(views, style), script=script
    )  # fmt: skip
    write_whole(path, page)


def pack(views: Sequence[str], style: str = "") -> str:
    """Everything, compressed: the views in columns of like pieces, None for a piece that stays as it was before."""
    columns = []
    for section in zip_longest(
        *(re.split("(?=<section)", view) for view in views), fillvalue=""
    ):
        pieces = (
            re.split("(?=<t[dh]|<[gpl])", each) for each in section
        )  # cells of tables, and what draws in SVG
        for column in zip_longest(*pieces, fillvalue=""):
            before = (None, *column)
            columns.append(
                [
                    None if new == old else new
                    for old, new in zip(before, column, strict=False)
                ]
            )
    text = json.dumps([style, columns], ensure_ascii=False, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode("ascii")
