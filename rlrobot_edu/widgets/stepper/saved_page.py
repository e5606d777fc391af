"""The programs of the stepper's page, and the page as a file that needs no kernel."""

from __future__ import annotations

import re
from functools import cache
from html import escape
from importlib.resources import files
from string import Template

from rlrobot_edu.widgets.stepper.told import Told, packed

SCRIPTS = (
    "numerals.js",
    "tape.js",
    "tables.js",
    "worlds.js",
    "panes.js",
    "relive.js",
    "credit.js",
    "futures.js",
    "stepper.js",
)

COMMENT = re.compile(r"(^| )\s*// [^\"'`]*$|^\s*//.*")  # as this program's are written


def page_html(title: str, feed: Told, program: str) -> str:
    """One HTML page with all steps of `feed`; it works without a kernel and without a network."""
    parts = {"style": re.sub(r"\s*([{};])\s*", r"\1", _bare(style())), "script": _bare(program), "feed": feed}
    return Template(_text("page/page.html")).substitute(title=escape(title), packed=packed(parts))


def script(lives: str, credit: str, choice: str) -> str:
    """The program of the page; lives: what lives.py tells, in JavaScript; credit, choice: what paid.py tells."""
    life = (files("rlrobot_edu.widgets.javascript") / "life.js").read_text("utf-8")
    programs = [*SCRIPTS, *["advice.js"] * (choice != "null")]  # without a bias nobody asks whose advice it is
    told = (f"const {name} = {value};" for name, value in (("lives", lives), ("updates", credit), ("choice", choice)))
    return "\n".join([life, *(_text(f"page/{name}") for name in programs), *told])


def style() -> str:
    """How the page looks."""
    return _text("page/style.css")


def _bare(program: str) -> str:
    """A program without comments and indents: a page is not where one reads it."""
    lines = (COMMENT.sub("", line).strip() for line in program.splitlines())
    return "\n".join(filter(None, lines))


@cache
def _text(name: str) -> str:
    return (files(__package__) / name).read_text("utf-8")
