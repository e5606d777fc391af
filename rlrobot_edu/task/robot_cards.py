"""What each robot can sense and do: the words that a task file may use, with units and ranges.

Only data stands here, so that a task file can be checked without starting a simulator.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from numbers import Real
from typing import NamedTuple


class Quantity(NamedTuple):
    """A sensor's reading or a command: its unit and the range it can take [unit]."""

    unit: str
    low: float
    high: float


class RobotCard(NamedTuple):
    """A robot: its sensors and commands by name, the scenes it knows, and who can simulate it.

    engines: class of the robot (``module:Class``) by engine; the first engine is the default
    """

    sensors: dict[str, Quantity]
    commands: dict[str, Quantity]
    scenes: tuple[str, ...]
    engines: dict[str, str]

    def check_command(self, command: Mapping[str, float]) -> None:
        """Raises ValueError if `command` does not give every command of the robot a number within its range."""
        if not isinstance(command, Mapping):
            raise ValueError(f"a command must be a dict of {', '.join(self.commands)}; got {command!r}")
        if command.keys() != self.commands.keys():
            raise ValueError(f"a command must give {', '.join(self.commands)}; got {', '.join(command) or 'nothing'}")
        for name, (unit, low, high) in self.commands.items():
            if not isinstance(command[name], Real):
                raise ValueError(f"command {name!r}: {command[name]!r} is not a number")
            if not low <= command[name] <= high:  # false for NaN as well
                raise ValueError(f"command {name!r}: {command[name]} {unit} is outside {low:g} to {high:g}")


# Every 45 degrees to the left, starting at the front.
LASERS = (
    "laser_front",
    "laser_front_left",
    "laser_left",
    "laser_rear_left",
    "laser_rear",
    "laser_rear_right",
    "laser_right",
    "laser_front_right",
)
FRONT_LASERS = ("laser_front", "laser_front_left", "laser_front_right")
LASER_RANGE = 5.0  # [m]

_BASE_SENSORS = {
    **{laser: Quantity("m", 0.0, LASER_RANGE) for laser in LASERS},
    "x": Quantity("m", -math.inf, math.inf),
    "y": Quantity("m", -math.inf, math.inf),
    "theta": Quantity("rad", -math.pi, math.pi),
}
WHEELS = ("left_wheel", "right_wheel")
_BASE_COMMANDS = {wheel: Quantity("rad/s", -2.0, 2.0) for wheel in WHEELS}
JOINTS = ("arm", "biceps", "forearm")
_ARM_SENSORS = {
    **{f"gripper_{axis}": Quantity("m", -2.0, 2.0) for axis in "xyz"},
    **{f"object_{axis}": Quantity("m", -2.0, 2.0) for axis in "xyz"},
    **{joint: Quantity("rad", -math.pi, math.pi) for joint in JOINTS},
}
_ARM_COMMANDS = {joint: Quantity("rad/s", -1.0, 1.0) for joint in JOINTS}

ROBOTS: dict[str, RobotCard] = {
    "mobile_base": RobotCard(
        sensors=_BASE_SENSORS,
        commands=_BASE_COMMANDS,
        scenes=("square_2x2", "maze_6x6", "maze_4x4_goal"),
        engines={
            "pymunk": "rlrobot_edu.robots.mobile_base:MobileBase",
            "pybullet": "rlrobot_edu.robots.bullet.mobile_base:BulletBase",
        },
    ),
    "giraff": RobotCard(
        sensors=_BASE_SENSORS,
        commands=_BASE_COMMANDS,
        scenes=("hexagon_giraff",),
        engines={"pymunk": "rlrobot_edu.robots.giraff:Giraff"},
    ),
    "arm": RobotCard(
        sensors=_ARM_SENSORS,
        commands=_ARM_COMMANDS,
        scenes=("table",),
        engines={"pybullet": "rlrobot_edu.robots.bullet.arm:Arm"},
    ),
    "mobile_manipulator": RobotCard(
        sensors={**_BASE_SENSORS, **_ARM_SENSORS},
        commands={**_BASE_COMMANDS, **_ARM_COMMANDS},
        scenes=("table_room",),
        engines={"pybullet": "rlrobot_edu.robots.bullet.mobile_manipulator:MobileManipulator"},
    ),
    "cell_robot": RobotCard(
        sensors={
            "X": Quantity("", 0, 1),
            "Y": Quantity("", 0, 1),
            "theta": Quantity("deg", -90, 90),
            "d": Quantity("", 0, 1),
            "bumped": Quantity("", 0, 1),
        },
        commands={"advance": Quantity("cells", 0, 1), "spin": Quantity("deg", -90, 90)},
        scenes=("four_cells",),
        engines={"python": "rlrobot_edu.robots.cell_robot:CellRobot"},
    ),
}
