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
    """The sensors and commands of a robot, by name; the scenes it knows; where its class is (``module:Class``)."""

    sensors: dict[str, Quantity]
    commands: dict[str, Quantity]
    scenes: tuple[str, ...]
    robot_class: str

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
LASER_RANGE = 5.0  # [m]

ROBOTS: dict[str, RobotCard] = {
    "mobile_base": RobotCard(
        sensors={
            **{laser: Quantity("m", 0.0, LASER_RANGE) for laser in LASERS},
            "x": Quantity("m", -math.inf, math.inf),
            "y": Quantity("m", -math.inf, math.inf),
            "theta": Quantity("rad", -math.pi, math.pi),
        },
        commands={"left_wheel": Quantity("rad/s", -2.0, 2.0), "right_wheel": Quantity("rad/s", -2.0, 2.0)},
        scenes=("square_2x2", "maze_6x6"),
        robot_class="rlrobot_edu.robots.mobile_base:MobileBase",
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
        robot_class="rlrobot_edu.robots.cell_robot:CellRobot",
    ),
}
