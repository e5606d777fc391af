"""The arm as geometry alone, without PyBullet: angles change by speed × time, a formula says where the gripper is.

There are no weights and no motors, and nothing to bump into: the gripper passes through the object and the table's top.
How often that makes a difference: docs/kinematic_arm.md.
"""

import math
from collections.abc import Mapping

import numpy as np

from rlrobot_edu.robots.arm.arm_body import FIELD, HOME, OBJECT_PLACE, Angles, joints, readings_of, scene_of, solids_of
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS

_KNOWN = joints()
_LIMITS = {name: _KNOWN[name].limits for name in JOINTS}
SHOULDER = float(_KNOWN["arm"].origin[2, 3] + _KNOWN["biceps"].origin[2, 3])  # height above the foot's base [m]
UPPER, LOWER = float(_KNOWN["forearm"].origin[2, 3]), float(_KNOWN["wrist"].origin[0, 3])  # to elbow, to fingertips [m]


def gripper(arm: float, biceps: float, forearm: float) -> tuple[float, float, float]:
    """The point between the fingertips, from the middle of the foot's base: x, y, z [m], for the joints' angles [rad].

    From the side: out = UPPER · sin(biceps) + LOWER · cos(biceps + forearm) and
    up = SHOULDER + UPPER · cos(biceps) − LOWER · sin(biceps + forearm). Then the joint arm turns what is out:
    x = out · cos(arm), y = out · sin(arm), z = up.
    """
    out = UPPER * math.sin(biceps) + LOWER * math.cos(biceps + forearm)
    up = SHOULDER + UPPER * math.cos(biceps) - LOWER * math.sin(biceps + forearm)
    return out * math.cos(arm), out * math.sin(arm), up


def turned(angles: Angles, command: Mapping[str, float], seconds: float) -> Angles:
    """The joints' angles after `seconds` at the speeds of `command`; they stop at their limits.

    Rounded, so that to and fro leads back to the same angles.
    """
    there = {name: angle + command[name] * seconds for name, angle in angles._asdict().items()}
    return Angles(**{name: round(min(max(there[name], low), high), 9) for name, (low, high) in _LIMITS.items()})


class KinematicArm(SimulatedRobot):
    """An arm at the edge of a table, on which an object stands. Nothing stops the arm but the limits of its joints.

    scene: name of the scene, ``table``
    step_time: duration of one control step [s]
    object_moves: whether `reset` draws a new place for the object from its `rng`, anywhere in the field
    """

    def __init__(self, scene: str, step_time: float, object_moves: bool = False) -> None:
        super().__init__(ROBOTS["arm"])
        self._step_time, self._object_moves = step_time, object_moves
        self._angles: Angles = HOME
        self._place = OBJECT_PLACE
        self._readings = self._sense()

    def _begin(self, rng: np.random.Generator) -> None:
        self._angles = HOME
        if self._object_moves:
            x_min, y_min, x_max, y_max = FIELD
            self._place = (*rng.uniform((x_min, y_min), (x_max, y_max)).tolist(), OBJECT_PLACE[2])

    def _move(self, command: Mapping[str, float]) -> None:
        self._angles = turned(self._angles, command, self._step_time)

    def _sense(self) -> dict[str, float]:
        """Gripper and object [m], and the joints' angles [rad]."""
        return readings_of(gripper(*self._angles), self._place, self._angles)

    def scene(self) -> Scene:
        """The table with its field, the object and the arm at this instant."""
        return scene_of(solids_of(self._angles), self._place)
