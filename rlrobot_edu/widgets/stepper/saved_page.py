"""The programs of the stepper's page."""

from __future__ import annotations

from rlrobot_edu.widgets.page_file import read_text

SCRIPTS = (
    "numerals",
    "tape",
    "tables",
    "worlds",
    "panes",
    "relive",
    "credit",
    "futures",
    "stepper",
    "alone",
)


def script(lives: str, credit: str, choice: str) -> str:
    """The program of the page; lives: what lives.py tells, in JavaScript; credit, choice: what paid.py tells."""
    names = [
        *SCRIPTS,
        *["advice"] * (choice != "null"),
    ]  # without a bias nobody asks whose advice it is
    programs = ["javascript/life.js", *(f"stepper/page/{name}.js" for name in names)]
    told = (
        f"const {name} = {value};"
        for name, value in (("lives", lives), ("updates", credit), ("choice", choice))
    )
    return "\n".join([*map(read_text, programs), *told])


def style() -> str:
    """How the page looks."""
    return read_text("stepper/page/style.css")
