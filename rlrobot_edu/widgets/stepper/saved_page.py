"""The programs of the stepper's page."""

from __future__ import annotations

from rlrobot_edu.widgets.page_file import read_text

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
    "alone.js",
)


def script(lives: str, credit: str, choice: str) -> str:
    """The program of the page; lives: what lives.py tells, in JavaScript; credit, choice: what paid.py tells."""
    programs = [f"stepper/page/{name}" for name in SCRIPTS]
    if choice != "null":  # without a bias nobody asks whose advice it is
        programs.append("stepper/page/advice.js")
    told = (f"const {name} = {value};" for name, value in (("lives", lives), ("updates", credit), ("choice", choice)))
    return "\n".join([*map(read_text, ("javascript/life.js", *programs)), *told])


def style() -> str:
    """How the page looks."""
    return read_text("stepper/page/style.css")
