"""``rl.playground()``: the page in which a robot learns."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache, cached_property
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import Any

from rlrobot_edu.checks import check_name
from rlrobot_edu.environments import make_env
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.memory import SETTINGS
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.seeds import ENVIRONMENT, generator
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.top_down import plot_scene
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.playground.kernels import kernels
from rlrobot_edu.widgets.playground.page_frame import PageFrame
from rlrobot_edu.widgets.playground.worlds import base_world, cells_world, cliff_world

TASKS = {  # of the base, as they are called on the page
    "wander_1k": "wander in a maze (1,024 states)",
    "wander_simple": "wander in a square (4 states)",
    "navigation_1k": "drive to the goal (1,024 states)",
}
WANDERER = "Nobody tells this robot how to drive. It earns points for driving on and loses some when it bumps. "
STORIES = {  # what a visitor reads first
    "wander_1k": WANDERER + "The rest it learns by trying.",
    "wander_simple": WANDERER
    + "It sees only whether something is near on its left and on its right.",
    "navigation_1k": "Nobody tells this robot the way. It earns points when it comes nearer to the goal, and loses "
    "some when it bumps. The rest it learns by trying.",
    "worked_example": "The robot, a disc that looks one way, earns points for each cell that it drives on, and loses "
    "some when it bumps into a wall or into the box. The rest it learns by trying.",
    "cliff": "Each step to the goal costs a point, and a fall from the cliff costs a hundred. Which way will it learn?",
}
BUMPS = {"called": "bumps", "atMost": -2}  # a step counts that pays so little
SCORES: dict[str, dict[str, Any]] = {
    "wander_1k": BUMPS,
    "wander_simple": BUMPS,
    "navigation_1k": {
        "called": "arrivals at the goal",
        "atMost": None,
    },  # the end of an episode counts
    "worked_example": BUMPS,
    "cliff": {"called": "falls", "atMost": -100},
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
SLIDERS = ("alpha", "gamma", "lam", "temperature", "epsilon")
LUCKS = 10  # seeds to choose from
SCRIPTS = (
    "theme.js",
    "room.js",
    "cells.js",
    "curve.js",
    "run.js",
    "page.js",
    "settings.js",
    "pointer.js",
    "buttons.js",
)
TITLE = "A robot learns, while you watch"


class Playground(Displayed):
    """The page in which a robot learns. A notebook shows it, and keeps a picture of the maze.

    Attributes
    ----------
    html : str
        The page; it works without a network.
    """

    def __init__(self, begin: Mapping[str, str]) -> None:
        self._task = begin["task"]
        script = [
            simulation_script(),
            f"const beginning = {json.dumps(begin)};",
            *map(_text, SCRIPTS),
        ]
        parts = {
            "style": _text("style.css"),
            "script": "\n".join(script),
            "description": escape(STORIES[self._task]),
        }
        self.html = Template(_text("page.html")).substitute(parts)

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
        """The robot at its start, as a saved notebook keeps it; nothing of the cliff, which has no robot."""
        if self._task == "cliff":
            return None
        env = make_env(self._task, engine="kinematic" if self._task in TASKS else None)
        env.reset()
        return plot_scene(env.unwrapped.robot.scene()).still()  # type: ignore[attr-defined]

    @cached_property
    def widget(self) -> PageFrame:
        """The page in a frame; no script of it reaches the notebook around it."""
        return PageFrame(page=self.html, title=TITLE)


def playground(
    path: str | Path | None = None,
    *,
    task: str = "wander_1k",
    method: str = "TOSL+QBIASSR",
) -> Playground:
    """A page in which a robot learns while you watch, with the library's own kernels.

    Method, task, α, γ, λ, temperature and walls can be changed there. With the same settings and the same luck (a seed,
    0 to 9) it comes to the same Q as ``rl.learn``, on the base with ``engine="kinematic"``. It needs no network, no
    Python and no server.

    Parameters
    ----------
    path : str or Path, optional
        Of a file to write, such as ``playground.html``; it is written whole or not at all.
    task, method : str
        What the page begins with: ``wander_1k``, ``wander_simple``, ``navigation_1k``, ``worked_example`` or ``cliff``,
        and a method of its list, such as ``Q+EG``.

    Returns
    -------
    Playground
        What a notebook shows.

    Raises
    ------
    ValueError
        If the page has no such task or method; it lists them. Or if the file's name ends like that of another kind.
    OSError
        If the file cannot be written.
    """
    check_name(task, (*TASKS, "worked_example", "cliff"), "task", "the playground")
    check_name(method, METHODS, "method", "the playground")
    page = Playground({"task": task, "method": method})
    if path is not None:
        page.save(path)
    return page


@cache
def simulation_script() -> str:
    """JavaScript without a page: ``newSimulation(settings)`` is a learner in its world, see new_simulation.js."""
    tasks = {name: load_task(name) for name in TASKS}
    worlds = {
        name: base_world(task) | {"called": TASKS[name]} for name, task in tasks.items()
    }
    worlds["worked_example"] = cells_world(load_task("worked_example")) | {
        "called": "the worked example (24 states)"
    }
    worlds["cliff"] = cliff_world() | {"called": "the cliff (48 states)"}
    about = {
        "worlds": {
            name: {**world, "story": STORIES[name], "score": SCORES[name]}
            for name, world in worlds.items()
        },
        "methods": [
            {"name": name, "called": called} for name, called in METHODS.items()
        ],
        "lucks": [_luck(seed) for seed in range(LUCKS)],
        "parameters": {name: getattr(Parameters(), name) for name in SLIDERS},
        "defaults": {
            name: getattr(Parameters(), name) for name in SETTINGS.names or ()
        },
    }
    parts = [
        files("rlrobot_edu.widgets.javascript")
        .joinpath("simulation.js")
        .read_text("utf-8"),
        f"const kernels = {kernels(list(METHODS), tasks)};",
        f"const about = {json.dumps(about, ensure_ascii=False, separators=(',', ':'))};",
        _text("walls.js"),
        _text("new_simulation.js"),
    ]
    return "\n".join(parts)


def _text(name: str) -> str:
    return files(__package__).joinpath(name).read_text("utf-8")


def _luck(seed: int) -> dict[str, dict[str, str]]:
    """Where the random numbers of an agent and of a world with this seed begin: states of PCG64, in hex."""
    states: dict[str, Any] = {
        name: generator(seed, role).bit_generator.state["state"]
        for name, role in {"agent": (), "world": ENVIRONMENT}.items()
    }
    return {
        name: {part: hex(state[part]) for part in ("state", "inc")}
        for name, state in states.items()
    }
