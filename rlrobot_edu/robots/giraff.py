"""Giraff: a telepresence robot, a screen on a mast, that keeps its distance from walls."""

from collections.abc import Mapping

from rlrobot_edu.robots.chassis import GIRAFF
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.scene import Solid, pose
from rlrobot_edu.task.robot_cards import FRONT_LASERS

STOP_DISTANCE = 0.18  # [m]


class Giraff(MobileBase):
    """A mobile base with a safety stop: while a front laser sees something nearer than 0.18 m, it only turns.

    Only the three front lasers count. A disc so near to a wall on its side or behind it could never drive away.
    """

    name = "giraff"
    chassis = GIRAFF

    def _move(self, command: Mapping[str, float]) -> None:
        """Held back by the safety stop, the robot turns as commanded but on the spot."""
        speed = (command["left_wheel"] + command["right_wheel"]) / 2
        if (
            speed > 0
            and min(self._readings[laser] for laser in FRONT_LASERS) < STOP_DISTANCE
        ):
            command = {wheel: value - speed for wheel, value in command.items()}
        super()._move(command)

    def solids(self) -> tuple[Solid, ...]:
        """The robot's parts, with their poses on the robot."""
        mast = Solid(
            "robot/mast", "cylinder", (0.03, 1.1), pose(-0.1, 0, 0.79), "robot"
        )
        screen = Solid(
            "robot/screen", "box", (0.04, 0.24, 0.3), pose(-0.08, 0, 1.4), "robot"
        )
        return (*super().solids(), mast, screen)
