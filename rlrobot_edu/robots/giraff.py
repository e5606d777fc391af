"""Giraff: a telepresence robot, a screen on a mast, with a safety stop before walls."""

from collections.abc import Mapping

from rlrobot_edu.robots.chassis import GIRAFF
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.scene import Solid, pose
from rlrobot_edu.task.robot_cards import FRONT_LASERS

STOP_DISTANCE = 0.18  # [m]


class Giraff(MobileBase):
    """A mobile base with a safety stop: while a front laser sees something nearer than 0.18 m, it only turns.

    Only the three front lasers count. Otherwise a disc close to a wall beside or behind it could never drive away.
    """

    name = "giraff"
    chassis = GIRAFF

    def _move(self, command: Mapping[str, float]) -> None:
        """Turn the wheels as commanded; the safety stop lets the robot turn on the spot only."""
        speed = (command["left_wheel"] + command["right_wheel"]) / 2
        nearest = min(self._readings[laser] for laser in FRONT_LASERS)
        if speed > 0 and nearest < STOP_DISTANCE:
            command = {wheel: value - speed for wheel, value in command.items()}
        super()._move(command)

    def solids(self) -> tuple[Solid, ...]:
        """The robot's parts, with their poses on the robot."""
        mast_at = pose(-0.1, 0, 0.79)
        mast = Solid("robot/mast", "cylinder", (0.03, 1.1), mast_at, "robot")
        screen_at = pose(-0.08, 0, 1.4)
        screen = Solid("robot/screen", "box", (0.04, 0.24, 0.3), screen_at, "robot")
        return (*super().solids(), mast, screen)
