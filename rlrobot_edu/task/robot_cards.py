"""What each robot can sense and do: the words that a task file may use, with units and ranges.

Only data stands here, so that a task file can be checked without starting a simulator.
"""

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

    engines: class of the robot (``module:Class`` in robots/) by engine; the first engine is the default
    """

    sensors: dict[str, Quantity]
    commands: dict[str, Quantity]
    scenes: tuple[str, ...]
    engines: dict[str, str]

    def check_command(self, command: Mapping[str, float]) -> None:
        """Raises ValueError if `command` does not give every command of the robot a number within its range."""
        if not isinstance(command, Mapping):
            raise ValueError(f"a command must be a dict of {', '.join(self.commands)}; got {command!r:.200}")
        if command.keys() != self.commands.keys():
            raise ValueError(f"a command must give {', '.join(self.commands)}; got {list(command)!s:.200}")
        for name, (unit, low, high) in self.commands.items():
            if not isinstance(command[name], Real):
                raise ValueError(f"command {name!r}: {command[name]!r:.200} is not a number")
            if not low <= command[name] <= high:  # false for NaN as well
                raise ValueError(f"command {name!r}: {command[name]} {unit} is outside {low:g} to {high:g}")


_WAYS = ("front", "front_left", "left", "rear_left", "rear", "rear_right", "right", "front_right")
LASERS = tuple(f"laser_{way}" for way in _WAYS)  # every 45 degrees to the left, starting at the front
FRONT_LASERS = ("laser_front", "laser_front_left", "laser_front_right")
LASER_RANGE = 5.0  # [m]

WHEELS = ("left_wheel", "right_wheel")
JOINTS = ("arm", "biceps", "forearm")

_BASE_SENSORS = {
    **{laser: Quantity("m", 0.0, LASER_RANGE) for laser in LASERS},
    **{axis: Quantity("m", -math.inf, math.inf) for axis in "xy"},
    "theta": Quantity("rad", -math.pi, math.pi),
}
_BASE_COMMANDS = {wheel: Quantity("rad/s", -2.0, 2.0) for wheel in WHEELS}
_ARM_SENSORS = {
    **{f"{part}_{axis}": Quantity("m", -2.0, 2.0) for part in ("gripper", "object") for axis in "xyz"},
    **{joint: Quantity("rad", -math.pi, math.pi) for joint in JOINTS},
}
_ARM_COMMANDS = {joint: Quantity("rad/s", -1.0, 1.0) for joint in JOINTS}
_BIT = Quantity("", 0, 1)

ROBOTS: dict[str, RobotCard] = {
    "mobile_base": RobotCard(
        _BASE_SENSORS, _BASE_COMMANDS, scenes=("square_2x2", "maze_6x6", "maze_4x4_goal"),
        engines={"pymunk": "mobile_base:MobileBase", "pybullet": "bullet.mobile_base:BulletBase"},
    ),
    "giraff": RobotCard(_BASE_SENSORS, _BASE_COMMANDS, ("hexagon_giraff",), {"pymunk": "giraff:Giraff"}),
    "arm": RobotCard(_ARM_SENSORS, _ARM_COMMANDS, ("table",), {"pybullet": "bullet.arm:Arm"}),
    "mobile_manipulator": RobotCard(
        _BASE_SENSORS | _ARM_SENSORS, _BASE_COMMANDS | _ARM_COMMANDS, scenes=("table_room",),
        engines={"pybullet": "bullet.mobile_manipulator:MobileManipulator"},
    ),
    "cell_robot": RobotCard(
        {"X": _BIT, "Y": _BIT, "theta": Quantity("deg", -90, 90), "d": _BIT, "bumped": _BIT},
        {"advance": Quantity("cells", 0, 1), "spin": Quantity("deg", -90, 90)},
        scenes=("four_cells",), engines={"python": "cell_robot:CellRobot"},
    ),
}  # fmt: skip
