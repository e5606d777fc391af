"""The steps of a tape as one HTML page, which needs no kernel: the views are those of the widget."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.panes import code_pane
from rlrobot_edu.course.stepper.style import STYLE
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.show.pages.page import save_page


def save_steps(path: str | Path, tape: Tape, names: Names, view: Callable[[], str], last: int | None = None) -> None:
    """Write the steps from the earliest kept to `last` (None: the end); the tape then is at the position as before.

    view: gives the HTML of the position of `tape`. Raises ValueError if `last` is no longer kept.
    """
    shown, views = tape.t, []
    try:
        tape.go(tape.end if last is None else last)
        last = tape.t
        tape.go(tape.first)
        first = tape.t
        views.append(view())
        while tape.t < last:
            tape.forward()
            views.append(view())
    finally:
        tape.go(max(shown, tape.first))  # new steps may have taken the place of the one shown
    world = f" in {names.task.name}" if names.task else ""
    title = f"{tape.agent.method}{world}, step by step"
    save_page(path, title, views, first=first, at=min(tape.t, last), style=STYLE, below=code_pane(tape.agent))
