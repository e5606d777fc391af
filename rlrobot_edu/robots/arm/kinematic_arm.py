"""The arm as geometry alone, without PyBullet: angles change by speed × time, a formula gives the gripper's place.

There are no weights, no motors and no collisions: the gripper passes through the object and the table's top.
docs/studies/kinematic_arm.md measures how often that makes a difference.
"""

import math
from collections import namedtuple
from collections.abc import Mapping

import numpy as np

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.robots.arm.arm_body import (
    HOME,
    OBJECT_PLACE,
    Angles,
    joints,
    scene_of,
    solids_of,
)
from rlrobot_edu.robots.engines.kinematic.robot import KinematicRobot
from rlrobot_edu.robots.engines.kinematic.trigonometry import cosine, sine
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS

_KNOWN = joints()
LIMITS = tuple(_KNOWN[name].limits for name in JOINTS)
# height of the shoulder above the foot's base; from there to the elbow; from there to the fingertips [m]
SHOULDER = float(_KNOWN["arm"].origin[2, 3] + _KNOWN["biceps"].origin[2, 3])
UPPER = float(_KNOWN["forearm"].origin[2, 3])
LOWER = float(_KNOWN["wrist"].origin[0, 3])


@compiled
def gripper(arm, biceps, forearm):
    """The point between the fingertips, from the middle of the foot's base: x, y, z [m], for the joints' angles [rad].

    From the side: out = UPPER · sin(biceps) + LOWER · cos(biceps + forearm) and
    up = SHOULDER + UPPER · cos(biceps) − LOWER · sin(biceps + forearm). Then the joint arm turns what is out:
    x = out · cos(arm), y = out · sin(arm), z = up.
    """
    out = UPPER * sine(biceps) + LOWER * cosine(biceps + forearm)
    up = SHOULDER + UPPER * cosine(biceps) - LOWER * sine(biceps + forearm)
    return out * cosine(arm), out * sine(arm), up


# place: array (3,), the joints' angles [rad]; step_time [s]
Parts = namedtuple("Parts", "place step_time")


@compiled
def move(arm, speeds):
    """Turn the joints for one control step at these speeds [rad/s], array (3,); they stop at their limits.

    Rounded to 9 digits, so that to and fro leads back to the same angles.
    """
    for i in range(3):
        angle = min(
            max(arm.place[i] + speeds[i] * arm.step_time, LIMITS[i][0]), LIMITS[i][1]
        )
        arm.place[i] = math.floor(angle * 1e9 + 0.5) / 1e9


def speeds_of(command: Mapping[str, float]) -> np.ndarray:
    """The joints' speeds [rad/s], array (3,)."""
    return np.array([command[joint] for joint in JOINTS], dtype=float)


def turned(angles: Angles, command: Mapping[str, float], seconds: float) -> Angles:
    """The joints' angles after `seconds` at the speeds of `command`, see `move`."""
    arm = Parts(np.array(angles), seconds)
    move(arm, speeds_of(command))
    return Angles(*arm.place.tolist())


@compiled
def sense(arm, readings):
    """Fill in gripper and object [m], and the joints' angles [rad]; readings: array (9,)."""
    readings[0], readings[1], readings[2] = gripper(
        arm.place[0], arm.place[1], arm.place[2]
    )
    for i in range(3):
        readings[3 + i], readings[6 + i] = OBJECT_PLACE[i], arm.place[i]


class KinematicArm(KinematicRobot):
    """An arm at the edge of a table, on which an object stands. Nothing stops the arm but the limits of its joints.

    scene: name of the scene, ``table``
    step_time: duration of one control step [s]
    """

    kernels = move, sense

    def __init__(self, scene: str, step_time: float) -> None:
        super().__init__(ROBOTS["arm"])
        self.parts = Parts(np.array(HOME), step_time)
        self._readings = self._sense()

    def _begin(self, rng: np.random.Generator) -> None:
        self.parts.place[:] = HOME

    def start(self) -> np.ndarray:
        """The place at which each episode begins, array (3,)."""
        return np.array(HOME)

    command_array = staticmethod(speeds_of)

    def scene(self) -> Scene:
        """The table with its field, the object and the arm at this instant."""
        angles = Angles(**{joint: self._readings[joint] for joint in JOINTS})
        return scene_of(solids_of(angles))
