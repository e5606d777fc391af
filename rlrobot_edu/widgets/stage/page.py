"""``rl.stage()``: the page that shows whom a robot asks."""

from __future__ import annotations

from functools import cache, cached_property
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from rlrobot_edu.files import write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.selections.qbiassr import QBIASSR, compute_bias
from rlrobot_edu.learning.selections.softmax import SR
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.room.scene_data import room_script
from rlrobot_edu.show.room.tokens import look
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.page_file import bare, bare_style, read_text
from rlrobot_edu.widgets.playground.kernels import kernels
from rlrobot_edu.widgets.playground.script import script_of
from rlrobot_edu.widgets.playground.worlds import base_world
from rlrobot_edu.widgets.stage.honest import honest, read_numbers, rule

if TYPE_CHECKING:
    from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer
    from rlrobot_edu.widgets.playground.page_frame import PageFrame

TASK = "wander_1k"
SECOND_ROOM = "worked_example"
METHODS = {"TOSL+SR": "asks nobody", "TOSL+QBIASSR": "asks similar states"}
TITLE = "It has never been here. Who does it ask?"
DESCRIPTION = (
    "Two robots learn in the same room. One asks nobody. The other asks its memories of places that differ from its "
    "own in one reading. See what that is worth, and when it misleads."
)
OPENING = (
    "Two robots have learned for an hour in the same room; the one that asked its memories has driven 311 m, the other "
    "266 m. Here the first one stands at a place that is new to it. Pale discs are itself, earlier, in similar places. "
    "Five of them say: drive ahead, fast. That raises the chance of this motion from 11 to 83 percent."
)
OPENING_WIDTH = 720  # of its picture [pixels of a page]
SCRIPTS = (
    "playground/theme.js",
    "stage/life.js",
    "stage/view.js",
    "stage/asking.js",
    "stage/badge.js",
    "stage/page.js",
    "stage/panel.js",
    "stage/hands.js",
)


class Stage(Displayed):
    """The page that shows whom a robot asks. A notebook shows it, and keeps a picture of its opening.

    Attributes
    ----------
    html : str
        The page; it works without a network.
    """

    def __init__(self) -> None:
        numbers = read_numbers()
        programs = [read_text(name) for name in SCRIPTS]
        self.html = Template(read_text("stage/page.html")).substitute(
            title=TITLE,
            description=escape(DESCRIPTION),
            style=bare_style(look() + read_text("stage/style.css")),
            honest=honest(numbers),
            rule=rule(numbers),
            script="\n".join(
                [lives_script(), bare("\n".join([room_script(), *programs]))]
            ),
        )

    def __repr__(self) -> str:
        return "<Stage: it has never been here, who does it ask?>"

    def save(self, path: str | Path) -> None:
        """Write the page to a file that any browser opens, whole or not at all.

        Parameters
        ----------
        path : str or Path
            The file, such as ``stage.html``.
        """
        write_whole(path, self.html)

    def still(self) -> Still:
        """The question and its answer, as a saved notebook keeps them; ``make pictures TASKS=stage`` draws it anew."""
        picture = files(__package__).joinpath("opening.png").read_bytes()
        return Still(OPENING, picture, OPENING_WIDTH)

    @cached_property
    def widget(self) -> PageFrame:
        """The page in a frame; no script of it reaches the notebook around it."""
        # here, because a page in a file needs no package of Jupyter's
        from rlrobot_edu.widgets.playground.page_frame import PageFrame

        return PageFrame(page=self.html, title=TITLE)


@suggests_keywords
def stage(path: str | Path | None = None, room: str = TASK) -> Stage | BiasExplorer:
    """A page on which two robots learn in one room, and one of them asks the states that are similar to its own.

    Both live an hour of ``wander_1k`` with true online SARSA(λ), softmax and the same luck; one has the bias of
    QBIASSR. Then the page shows a moment in which this robot's state was new to it: which similar states it knew, what
    each said, and with which chances it chose. Walls can be moved and memories changed. It needs no network, no Python
    and no server.

    In the second room, ``worked_example``, the moment stands still, and all numbers can be seen and changed: the bias
    explorer of the paper's 24 states, in the state (1, 1, 90°, T) in which a robot had never been.

    Parameters
    ----------
    path : str or Path, optional
        A file to write, such as ``stage.html``; it is written whole or not at all.
    room : str
        ``wander_1k`` or ``worked_example``.

    Returns
    -------
    Stage or BiasExplorer
        What a notebook shows.

    Raises
    ------
    ValueError
        If there is no such room, or the name ends like that of another kind of file.
    OSError
        If the file cannot be written.
    """
    if room not in (TASK, SECOND_ROOM):
        raise ValueError(f"room must be {TASK!r} or {SECOND_ROOM!r}, got {room!r:.200}")
    page: Stage | BiasExplorer
    if room == TASK:
        page = Stage()
    else:
        # here, because the explorer needs packages of Jupyter's, and the first room does not
        from rlrobot_edu.widgets.stage.second_room import second_room

        page = second_room()
    if path is not None:
        page.save(path)
    return page


@cache
def lives_script() -> str:
    """JavaScript without a page: the kernels, the room, the luck of the robot that is shown, and the bias."""
    task = load_task(TASK)
    choices = {
        "sr": SR.compute_probabilities,
        "qbiassr": QBIASSR.compute_probabilities,
        "compute_bias": compute_bias,
    }
    program = kernels(list(METHODS), {TASK: task}, choices)
    luck = [read_numbers()["shown"]]
    script = script_of(program, {TASK: base_world(task)}, METHODS, luck)
    return bare("\n".join([script, read_text("bias_explorer/page/bias.js")]))
