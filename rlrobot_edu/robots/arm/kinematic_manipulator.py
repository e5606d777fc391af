"""The mobile manipulator without PyBullet: the base in pymunk, and on its back the arm as geometry alone."""

import math
from collections.abc import Mapping

import numpy as np

from rlrobot_edu.robots.arenas import TABLE_HEIGHT
from rlrobot_edu.robots.arm.arm_body import (
    HOME,
    OBJECT,
    Angles,
    object_at,
    readings_of,
    solids_of,
)
from rlrobot_edu.robots.arm.kinematic_arm import gripper, turned
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import JOINTS

# Where the arm's foot is on top of the chassis, from the middle of the axle [m]
MOUNT = (0.06, 0.0, 0.1425)
OBJECT_PLACE = (1.09, 0.0, TABLE_HEIGHT + OBJECT[1] / 2)  # [m]
# The same in the frame whose x, y and theta the base senses [m]
_FOOT_X = PIONEER.axle + MOUNT[0]
_FOOT_Y = MOUNT[1]
_FOOT_Z = PIONEER.wheel_radius + MOUNT[2]


class KinematicManipulator(MobileBase):
    """The mobile base with the arm on its back. Walls and table stop the base; nothing stops the arm but its limits.

    scene: name of the scene, ``table_room``
    step_time: duration of one control step [s]
    """

    name = "mobile_manipulator"

    def _begin(self, rng: np.random.Generator) -> None:
        super()._begin(rng)
        self._angles: Angles = HOME

    def _move(self, command: Mapping[str, float]) -> None:
        super()._move(command)
        self._angles = turned(self._angles, command, self._step_time)

    def _sense(self) -> dict[str, float]:
        """What the base senses, and gripper and object [m] and the joints' angles [rad]."""
        base = super()._sense()
        cos, sin = math.cos(base["theta"]), math.sin(base["theta"])
        out, aside, up = gripper(*self._angles)  # from the arm's foot
        x = out + _FOOT_X
        y = aside + _FOOT_Y
        gripper_x = base["x"] + x * cos - y * sin
        gripper_y = base["y"] + x * sin + y * cos
        place = (gripper_x, gripper_y, up + _FOOT_Z)
        return base | readings_of(place, OBJECT_PLACE, self._angles)

    def solids(self) -> tuple[Solid, ...]:
        """The parts of base and arm, with their poses on the robot."""
        foot = pose(_FOOT_X, _FOOT_Y, _FOOT_Z)
        angles = Angles(**{joint: self._readings[joint] for joint in JOINTS})
        arm = [part._replace(pose=foot @ part.pose) for part in solids_of(angles)]
        return (*super().solids(), *arm)

    def scene(self) -> Scene:
        """The room with its table, the object, the robot and its laser beams at this instant."""
        room = super().scene()
        return room._replace(solids=(object_at(OBJECT_PLACE), *room.solids))
