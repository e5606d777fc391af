"""``rl.playground()``: the page in which a robot learns."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache, cached_property
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Any

from rlrobot_edu.checks import check_name
from rlrobot_edu.environments import make_env
from rlrobot_edu.files import write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.painting.room import painted
from rlrobot_edu.show.room.scene_data import room_script
from rlrobot_edu.show.room.tokens import look
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.playground.kernels import kernels
from rlrobot_edu.widgets.playground.script import script_of
from rlrobot_edu.widgets.playground.worlds import (
    World,
    base_world,
    cliff_world,
)

if TYPE_CHECKING:
    from rlrobot_edu.widgets.playground.page_frame import PageFrame

TASKS = {  # of the base, as they are called on the page
    "wander_1k": "wander in a maze (1,024 states)",
    "navigation_1k": "drive to the goal (1,024 states)",
}
CALLED = {**TASKS, "cliff": "the cliff (48 states)"}
STORIES = {  # what a visitor reads first
    "wander_1k": "Nobody tells this robot how to drive. It earns points for driving on and loses some when it bumps. "
    "The rest it learns by trying.",
    "navigation_1k": "Nobody tells this robot the way. It earns points when it comes nearer to the goal, and loses "
    "some when it bumps. The rest it learns by trying.",
    "cliff": "Each step to the goal costs a point, and a fall from the cliff costs a hundred. Which way will it learn?",
}
# What is counted: steps whose reward is at most this number, or with None the ends of episodes
Score = dict[str, Any]
SCORES: dict[str, Score] = {
    "wander_1k": {"called": "bumps", "atMost": -2},
    "navigation_1k": {"called": "arrivals at the goal", "atMost": None},
    "cliff": {"called": "falls", "atMost": -100},
}
HOUR, DAY = 3600, 86400  # in steps of a second
AGES = {  # that the page leads to: steps, and how a button calls them; at the second one it opens
    "wander_1k": [(0, "a beginner"), (HOUR, "after an hour"), (DAY, "after a day")],
    "navigation_1k": [
        (0, "a beginner"),
        (4 * HOUR, "after four hours"),
        (DAY, "after a day"),
    ],
    "cliff": [
        (0, "a beginner"),
        (HOUR, "after 3,600 steps"),
        (DAY, "after 86,400 steps"),
    ],
}
# In how many of the ten seeds learning shows at the second age, with the method and the settings of the paper: the
# number has halved, or for arrivals doubled to at least two. A task in which it shows in fewer than five has no place
# here. Seed 0, which the page opens with, is the first of them.
SHOWS = {"wander_1k": 6, "navigation_1k": 10, "cliff": 10}
RULES = {
    "wander_1k": "Is that luck? Of ten robots like this one, {shows} at least halved their bumps in an hour; you see "
    "the first of these. It goes on trying, so some bumps remain.",
    "navigation_1k": "Is that luck? Of ten robots like this one, {shows} at least doubled their arrivals in four "
    "hours; you see the first of these.",
    "cliff": "Is that luck? Of ten learners like this one, {shows} at least halved their falls in 3,600 steps; you see "
    "the first of these.",
}
METHODS = {
    "TOSL+QBIASSR": "TOSL+QBIASSR, the paper's method",
    "TOSL+SR": "true online SARSA(λ), softmax",
    "SL+SR": "SARSA(λ), softmax",
    "SARSA+SR": "SARSA, softmax",
    "SARSA+EG": "SARSA, ε-greedy",
    "Q+EG": "Q-learning, ε-greedy",
    "Q+RANDOM": "chance: it learns, and never uses it",
}
LUCKS = 10  # seeds to choose from
SCRIPTS = (
    "theme.js",
    "picture.js",
    "cells.js",
    "numbers.js",
    "curve.js",
    "run.js",
    "page.js",
    "settings.js",
    "pointer.js",
    "buttons.js",
)
TITLE = "A robot learns, while you watch"


class Playground(Displayed):
    """The page in which a robot learns. A notebook shows it, and keeps a picture of the robot's world.

    Attributes
    ----------
    html : str
        The page; it works without a network.
    """

    def __init__(self, begin: Mapping[str, str]) -> None:
        self._task = begin["task"]
        beginning = f"const beginning = {json.dumps(begin)};"
        programs = [_text(name) for name in SCRIPTS]
        self.html = Template(_text("page.html")).substitute(
            style=look() + _text("style.css"),
            script="\n".join(
                [simulation_script(), beginning, room_script(), *programs]
            ),
            description=escape(STORIES[self._task]),
        )

    def __repr__(self) -> str:
        return "<Playground: a robot learns, while you watch>"

    def save(self, path: str | Path) -> None:
        """Write the page to a file that any browser opens, whole or not at all.

        Parameters
        ----------
        path : str or Path
            The file, such as ``playground.html``.
        """
        write_whole(path, self.html)

    def still(self) -> Still | None:
        """The robot at its start, as a saved notebook keeps it; None for the cliff, which has no robot."""
        if self._task == "cliff":
            return None
        env = make_env(self._task, engine="kinematic")
        env.reset()
        return painted([env.unwrapped.robot.scene()])  # type: ignore[attr-defined]

    @cached_property
    def widget(self) -> PageFrame:
        """The page in a frame; no script of it reaches the notebook around it."""
        # here, because a page in a file needs no package of Jupyter's
        from rlrobot_edu.widgets.playground.page_frame import PageFrame

        return PageFrame(page=self.html, title=TITLE)


@suggests_keywords
def playground(
    path: str | Path | None = None,
    *,
    task: str = "wander_1k",
    method: str = "TOSL+QBIASSR",
) -> Playground:
    """A page in which a robot learns while you watch, with the library's own kernels.

    Method, task, α, γ, λ, temperature and walls can be changed there. With the same settings and the same luck (a seed
    from 0 to 9) it learns the same Q as ``rl.learn``, on the base with ``engine="kinematic"``. It needs no network, no
    Python and no server.

    Parameters
    ----------
    path : str or Path, optional
        A file to write, such as ``playground.html``; it is written whole or not at all.
    task, method : str
        What the page begins with: ``wander_1k``, ``navigation_1k`` or ``cliff``, and a method of its list, such as
        ``Q+EG``.

    Returns
    -------
    Playground
        What a notebook shows.

    Raises
    ------
    ValueError
        If the page has no such task or method (the message lists them), or if the name ends like that of another kind
        of file.
    OSError
        If the file cannot be written.
    """
    check_name(task, CALLED, "task", "the playground")
    check_name(method, METHODS, "method", "the playground")
    page = Playground({"task": task, "method": method})
    if path is not None:
        page.save(path)
    return page


@cache
def simulation_script() -> str:
    """JavaScript without a page: ``newSimulation(settings)`` is a learner in its world, see new_simulation.js."""
    tasks = {name: load_task(name) for name in TASKS}
    program = kernels(list(METHODS), tasks)
    return script_of(program, _worlds(tasks), METHODS, range(LUCKS))


def _worlds(tasks: Mapping[str, Task]) -> dict[str, World]:
    """The worlds by name, with their texts."""
    worlds = {name: base_world(task) for name, task in tasks.items()}
    worlds["cliff"] = cliff_world()
    for name, world in worlds.items():
        world["called"] = CALLED[name]
        world["story"] = STORIES[name]
        world["score"] = SCORES[name]
        world["ages"] = AGES[name]
        world["rule"] = RULES[name].format(shows=SHOWS[name])
    return worlds


def _text(name: str) -> str:
    return files(__package__).joinpath(name).read_text("utf-8")
