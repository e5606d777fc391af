"""The programs of the stepper's page, and the page as a file that needs no kernel."""

from __future__ import annotations

from functools import cache
from html import escape
from importlib.resources import files
from string import Template

from rlrobot_edu.course.stepper.told import Told, packed

SCRIPTS = ("numerals.js", "tape.js", "tables.js", "worlds.js", "panes.js", "relive.js", "stepper.js")


def page_html(title: str, feed: Told, lives: str) -> str:
    """One HTML page with all steps of `feed`; it works without a kernel and without a network."""
    parts = {"style": style(), "script": script(lives), "feed": feed}
    return Template(_text("page/page.html")).substitute(title=escape(title), packed=packed(parts))


def script(lives: str) -> str:
    """The program of the page; lives: what lives.py tells, in JavaScript."""
    life = (files("rlrobot_edu.javascript") / "life.js").read_text("utf-8")
    return "\n".join([life, *(_text(f"page/{name}") for name in SCRIPTS), f"const lives = {lives};"])


def style() -> str:
    """How the page looks."""
    return _text("page/style.css")


@cache
def _text(name: str) -> str:
    return (files(__package__) / name).read_text("utf-8")
