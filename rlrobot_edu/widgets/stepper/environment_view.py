"""The best available view of an environment."""

from __future__ import annotations

import gymnasium

from rlrobot_edu.robots.cell_robot import CellRobot
from rlrobot_edu.widgets.stepper.cell_values import INPUTS, CellValues
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.robot_view import RobotView
from rlrobot_edu.widgets.stepper.state_view import StateView
from rlrobot_edu.widgets.stepper.tape import EnvironmentView


def view_of(env: gymnasium.Env, names: Names) -> EnvironmentView:
    """The robot from above, or else the state with its inputs."""
    robot = getattr(env.unwrapped, "robot", None)
    if not hasattr(robot, "scene"):
        return StateView(names)
    marks = None
    if isinstance(robot, CellRobot) and names.task is not None:
        inputs = set(names.inputs)
        if inputs <= INPUTS:
            marks = CellValues(names.task)
    return RobotView(robot, marks, names)
