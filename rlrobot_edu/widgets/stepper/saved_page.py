"""The programs of the stepper's page."""

from __future__ import annotations

from rlrobot_edu.widgets.page_file import read_text

SCRIPTS = (
    "numerals",
    "tape",
    "tables",
    "worlds",
    "panes",
    "replay",
    "credit",
    "advice",
    "comparison",
    "stepper",
    "standalone",
)


def script(replay_data: str, updates: str, choice: str) -> str:
    """The program of the page; what it is given are JavaScript expressions, see replay.py and credit_kernels.py."""
    programs = [
        "javascript/simulation.js",
        *(f"stepper/page/{name}.js" for name in SCRIPTS),
    ]
    values = [
        f"const replayData = {replay_data};",
        f"const updates = {updates};",
        f"const choice = {choice};",
    ]
    return "\n".join([*map(read_text, programs), *values])


def style() -> str:
    """How the page looks."""
    return read_text("stepper/page/style.css")
