"""The programs of the stepper's page."""

from __future__ import annotations

from rlrobot_edu.show.palette import BLUE, ORANGE, RED
from rlrobot_edu.show.room.scene_data import room_script
from rlrobot_edu.show.room.tokens import look
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
    """The program of the page. Its arguments are JavaScript expressions, see replay.py and credit_kernels.py."""
    # letters can be read on these three, thinned, in light and in dark
    values = f'const BLUE = "{BLUE}", VERMILION = "{RED}", ORANGE = "{ORANGE}";'
    programs = [read_text("javascript/simulation.js"), room_script(), values]
    for name in SCRIPTS:
        programs.append(read_text(f"stepper/page/{name}.js"))
    programs.append(f"const replayData = {replay_data};")
    programs.append(f"const updates = {updates};")
    programs.append(f"const choice = {choice};")
    return "\n".join(programs)


def style() -> str:
    """How the page looks."""
    return look() + read_text("stepper/page/style.css")
