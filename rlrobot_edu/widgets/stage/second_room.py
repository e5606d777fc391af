"""The second room: the paper's 24 states, four cells and a box, in which every number can be followed by hand."""

from __future__ import annotations

from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.widgets.bias_explorer.explorer import BiasExplorer
from rlrobot_edu.widgets.stage.page import SECOND_ROOM

# Two robots that stand in a state for the first time: their seed, and the steps before
NEW_IN = {
    "new in state 21, the paper's": (138, 71),
    "new in state 1, lesson 05's": (131, 158),
}


def second_room() -> BiasExplorer:
    """The explorer in the paper's state (1, 1, 90°, T), with the table of a robot that had never been there."""
    tables = {name: grown(*which) for name, which in NEW_IN.items()}
    return BiasExplorer(SECOND_ROOM, tables)


def grown(seed: int, steps: int) -> Agent:
    """A robot that learns as lesson 05's does, after so many steps."""
    robot = Agent(SECOND_ROOM, "Q+SR", alpha=0.3, seed=seed, loop_evasion=False)
    learn(robot, make_env(SECOND_ROOM, seed=seed), steps, progress=False)
    return robot
