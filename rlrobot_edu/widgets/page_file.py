"""A page's program and all that it shows, as one file that needs no kernel and no network."""

from __future__ import annotations

import base64
import json
import re
import zlib
from functools import cache
from html import escape
from importlib.resources import files
from string import Template
from typing import Any

COMMENT = re.compile(r"(^| )\s*// [^\"'`]*$|^\s*//.*")  # as these programs' are written


def page_html(
    title: str, description: str, feed: dict[str, Any], program: str, style: str
) -> str:
    """One HTML page, on which ``standalone(feed, place)`` of the program shows its data in an element of the page.

    title, description: of the page, also for a card that shows a link to it
    """
    parts = {
        "style": bare_style(style),
        "script": bare(program),
        "feed": feed,
    }
    text = json.dumps(parts, ensure_ascii=False, separators=(",", ":"))
    packed = base64.b64encode(zlib.compress(text.encode(), 9)).decode("ascii")
    return Template(read_text("page_file.html")).substitute(
        title=escape(title), description=escape(description), packed=packed
    )


@cache
def read_text(name: str) -> str:
    """A file of a page's program; its name begins with the folder, such as ``stepper``."""
    return (files(__package__) / name).read_text("utf-8")


def bare_style(style: str) -> str:
    """A style sheet without comments and blanks."""
    return re.sub(r"\s*([{};])\s*", r"\1", bare(style))


def bare(program: str) -> str:
    """A program without comments and indents, which only make a page larger."""
    lines = [COMMENT.sub("", line).strip() for line in program.splitlines()]
    return "\n".join(line for line in lines if line)
