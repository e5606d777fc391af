"""The arm as geometry alone, without PyBullet: angles change by speed × time, a formula says where the gripper is.

There are no weights and no motors, and nothing to bump into: the gripper passes through the object and the table's top.
How often that makes a difference: docs/kinematic_arm.md.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from rlrobot_edu.learning.jit import compiled
from rlrobot_edu.robots.arm.arm_body import FIELD, HOME, OBJECT_PLACE, Angles, joints, scene_of, solids_of
from rlrobot_edu.robots.engines.kinematic.motion import cosine, sine
from rlrobot_edu.robots.engines.kinematic.world import Kinematics
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS

_KNOWN = joints()
LIMITS = tuple(_KNOWN[name].limits for name in JOINTS)
SHOULDER = float(_KNOWN["arm"].origin[2, 3] + _KNOWN["biceps"].origin[2, 3])  # height above the foot's base [m]
UPPER, LOWER = float(_KNOWN["forearm"].origin[2, 3]), float(_KNOWN["wrist"].origin[0, 3])  # to elbow, to fingertips [m]
X_MIN, Y_MIN, X_MAX, Y_MAX = FIELD


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


@compiled
def turn(angles, speeds, seconds):
    """Turn the joints for some seconds at these speeds [rad/s]; they stop at their limits. Arrays (3,).

    Rounded to 9 digits, so that to and fro leads back to the same angles.
    """
    for i in range(3):
        angle = min(max(angles[i] + speeds[i] * seconds, LIMITS[i][0]), LIMITS[i][1])
        angles[i] = math.floor(angle * 1e9 + 0.5) / 1e9


def turned(angles: Angles, command: Mapping[str, float], seconds: float) -> Angles:
    """The joints' angles after `seconds` at the speeds of `command`, see `turn`."""
    there = np.array(angles)
    turn(there, speeds_of(command), seconds)
    return Angles(*there.tolist())


def speeds_of(command: Mapping[str, float]) -> np.ndarray:
    """The joints' speeds [rad/s], array (3,)."""
    return np.array([command[joint] for joint in JOINTS], dtype=float)


class Parts(NamedTuple):
    """An arm and its object.

    place: array (6,), the joints' angles [rad] and the object's x, y, z [m]
    start: array (6,), the place at which an episode begins
    object_moves: whether a new episode draws another place for the object
    step_time: duration of one control step [s]
    """

    place: np.ndarray
    start: np.ndarray
    object_moves: bool
    step_time: float


@compiled
def begin(arm, rng):
    """Put the arm at its start, and the object, perhaps, anywhere in the field."""
    arm.place[:3] = arm.start[:3]
    if arm.object_moves:
        arm.place[3] = X_MIN + (X_MAX - X_MIN) * rng.random()
        arm.place[4] = Y_MIN + (Y_MAX - Y_MIN) * rng.random()


@compiled
def move(arm, command):
    """Turn for one control step; command: array (3,), the joints' speeds [rad/s]."""
    turn(arm.place, command, arm.step_time)


@compiled
def sense(arm, readings):
    """Fill in gripper and object [m], and the joints' angles [rad]; readings: array (9,)."""
    readings[0], readings[1], readings[2] = gripper(arm.place[0], arm.place[1], arm.place[2])
    for i in range(3):
        readings[3 + i], readings[6 + i] = arm.place[3 + i], arm.place[i]


class KinematicArm(SimulatedRobot):
    """An arm at the edge of a table, on which an object stands. Nothing stops the arm but the limits of its joints.

    scene: name of the scene, ``table``
    step_time: duration of one control step [s]
    object_moves: whether `reset` draws a new place for the object from its `rng`, anywhere in the field
    """

    def __init__(self, scene: str, step_time: float, object_moves: bool = False) -> None:
        super().__init__(ROBOTS["arm"])
        start = np.array([*HOME, *OBJECT_PLACE])
        self._parts = Parts(start.copy(), start, object_moves, step_time)
        self._readings = self._sense()

    def kinematics(self, commands: Sequence[Mapping[str, float]]) -> Kinematics:
        """What the robot is to a kernel that gives it these commands."""
        return Kinematics(begin, move, sense, self._parts, np.stack([*map(speeds_of, commands)]))

    def _begin(self, rng: np.random.Generator) -> None:
        begin(self._parts, rng)

    def _move(self, command: Mapping[str, float]) -> None:
        move(self._parts, speeds_of(command))

    def _sense(self) -> dict[str, float]:
        """Gripper and object [m], and the joints' angles [rad]."""
        readings = np.empty(len(self._card.sensors))
        sense(self._parts, readings)
        return dict(zip(self._card.sensors, readings.tolist(), strict=True))

    def scene(self) -> Scene:
        """The table with its field, the object and the arm at this instant."""
        place = self._parts.place.tolist()
        return scene_of(solids_of(Angles(*place[:3])), place[3:])
