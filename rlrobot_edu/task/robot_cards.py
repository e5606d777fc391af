"""The sensors and commands of each robot: the words that a task file may use, with units and ranges.

The cards stand in ``robot_cards.toml``, so that a task file can be checked without starting a simulator.
"""

import tomllib
from collections.abc import Mapping, Sequence
from numbers import Real
from pathlib import Path
from typing import Any, Literal, NamedTuple

Engine = Literal[
    "pymunk", "pybullet", "kinematic", "python"
]  # who can simulate a robot


class Quantity(NamedTuple):
    """A sensor's reading or a command: its unit and the range it can take [unit]."""

    unit: str
    low: float
    high: float


class RobotCard(NamedTuple):
    """A robot: its sensors and commands by name, the scenes it knows, and who can simulate it.

    stops: where some readings end, by the sensor's name; for people, since a simulator may go a little beyond
    engines: class of the robot (``module:Class`` in the package) by engine; the first that is installed is the default
    size: length and width [m] of a robot on wheels, which can stand in a `Room`; None for the others
    """

    sensors: dict[str, Quantity]
    commands: dict[str, Quantity]
    stops: dict[str, Quantity]
    scenes: Sequence[str]
    engines: dict[Engine, str]
    size: tuple[float, float] | None = None

    def check_command(self, command: Mapping[str, float]) -> None:
        """Raises ValueError if `command` does not give every command of the robot a number within its range."""
        if not isinstance(command, Mapping) or command.keys() != self.commands.keys():
            named = (
                f"{', '.join(self.commands)} (a fixed number for what is to hold still)"
            )
            raise ValueError(
                f"a command must be a dict that gives {named}; got {command!r:.200}"
            )
        for name, (unit, low, high) in self.commands.items():
            if not isinstance(command[name], Real):
                raise ValueError(
                    f"command {name!r}: {command[name]!r:.200} is not a number"
                )
            if not low <= command[name] <= high:  # false for NaN as well
                raise ValueError(
                    f"command {name!r}: {command[name]} {unit} is outside {low:g} to {high:g}"
                )


def _read(path: Path) -> dict[str, RobotCard]:
    """The cards in a file. A robot's sensors and commands are on its own card, or on those that it is `like`."""
    cards = tomllib.loads(path.read_text(encoding="utf-8"))

    def quantities(robot: str, kind: str) -> dict[str, Quantity]:
        found: dict[str, Any] = {}
        for name in cards[robot].get("like", [robot]):
            found |= cards[name].get(kind, {})
        return {name: Quantity(*quantity) for name, quantity in found.items()}

    read = {}
    for robot, card in cards.items():
        read[robot] = RobotCard(
            sensors=quantities(robot, "sensors"),
            commands=quantities(robot, "commands"),
            stops=quantities(robot, "stops"),
            scenes=card["scenes"],
            engines=card["engines"],
            size=card.get("size"),
        )
    return read


ROBOTS = _read(Path(__file__).with_suffix(".toml"))

LASERS = tuple(
    sensor for sensor in ROBOTS["mobile_base"].sensors if sensor.startswith("laser_")
)
FRONT_LASERS = ("laser_front", "laser_front_left", "laser_front_right")
LASER_RANGE = ROBOTS["mobile_base"].sensors["laser_front"].high  # [m]
WHEELS = tuple(ROBOTS["mobile_base"].commands)
JOINTS = tuple(ROBOTS["arm"].commands)
