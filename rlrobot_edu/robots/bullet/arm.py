"""The arm: three joints and a gripper over a table with an object, in PyBullet."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rlrobot_edu.robots.bullet.simulation import BulletRobot, BulletWorld
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import JOINTS

URDF = Path(__file__).with_name("arm.urdf")
HOME = (-0.42, 0.9, 0.26)  # where the joints begin [rad]
PHYSICS_HZ = 60

OBJECT = (0.02, 0.05)  # radius and height of the cylinder [m]
OBJECT_PLACE = (0.27, 0.09)  # where it stands unless it moves: x, y [m]
FIELD = (0.20, -0.16, 0.32, 0.16)  # the part of the table that matters: x_min, y_min, x_max, y_max [m]
TABLE = (-0.10, -0.26, 0.42, 0.26)  # x_min, y_min, x_max, y_max [m]; its top is the floor of this world, z = 0


class ArmJoints:
    """The servos of the arm that `body` has in `world`: they are told speeds and stop at their limits."""

    def __init__(self, world: BulletWorld, body: int) -> None:
        self._world, self._body = world, body
        numbers = world.joints(body)
        self._numbers, self.gripper = [numbers[name] for name in JOINTS], numbers["wrist"]
        limits = [world.getJointInfo(body, i)[8:11] for i in self._numbers]
        self._low, self._high, self._torque = zip(*limits, strict=True)
        for i, angle in zip(self._numbers, HOME, strict=True):
            world.resetJointState(body, i, angle)

    def angles(self) -> list[float]:
        """Angle of each joint [rad]."""
        return [state[0] for state in self._world.getJointStates(self._body, self._numbers)]

    def drive(self, command: Mapping[str, float], seconds: float) -> None:
        """Set the servos' speeds to `command` [rad/s], slower where a limit would be passed within `seconds` [s]."""
        here = zip(JOINTS, self.angles(), self._low, self._high, strict=True)
        speeds = [min(max(command[name], (low - q) / seconds), (high - q) / seconds) for name, q, low, high in here]
        self._world.setJointMotorControlArray(
            self._body, self._numbers, self._world.VELOCITY_CONTROL, targetVelocities=speeds, forces=self._torque
        )

    def readings(self, place: np.ndarray) -> dict[str, float]:
        """Gripper and object (at `place`, array (3,)) in the world [m], and the joints' angles [rad]."""
        gripper = self._world.link_pose(self._body, self.gripper)[:3, 3]
        return {
            **{f"gripper_{axis}": float(v) for axis, v in zip("xyz", gripper, strict=True)},
            **{f"object_{axis}": float(v) for axis, v in zip("xyz", place, strict=True)},
            **dict(zip(JOINTS, self.angles(), strict=True)),
        }


class Arm(BulletRobot):
    """An arm at the edge of a table. An object stands on the table, too heavy for the arm to push.

    scene: name of the scene, ``table``
    step_time: duration of one control step [s]
    object_moves: whether `reset` draws a new place for the object from its `rng`, anywhere in the field
    """

    def __init__(self, scene: str, step_time: float, object_moves: bool = False) -> None:
        self._object_moves = object_moves
        world = BulletWorld(PHYSICS_HZ)
        world.add_floor()  # the table's top
        self._place = np.array([*OBJECT_PLACE, OBJECT[1] / 2])
        self._object = world.add(Solid("object", "cylinder", OBJECT, pose(*self._place), "object"))
        self._body = world.load(URDF, (0, 0, 0), fixed=True)
        self._joints = ArmJoints(world, self._body)
        super().__init__("arm", world, step_time)

    def reset(self, rng: np.random.Generator | None = None) -> dict[str, float]:
        """Put the joints where they began and return the readings; `rng` draws the object's place if it moves."""
        if self._object_moves:
            x_min, y_min, x_max, y_max = FIELD
            self._place[:2] = rng.uniform((x_min, y_min), (x_max, y_max))
        readings = super().reset()
        if self._object_moves:  # `restoreState` has put it back to where it was at first
            self._world.resetBasePositionAndOrientation(self._object, self._place.tolist(), (0, 0, 0, 1))
        return readings

    def _drive(self, command: Mapping[str, float]) -> None:
        self._joints.drive(command, self._step_time)

    def _sense(self) -> dict[str, float]:
        return self._joints.readings(self._place)

    def scene(self) -> Scene:
        """The table with its field, the object and the arm at this instant."""
        x_min, y_min, x_max, y_max = FIELD
        middle = pose((x_min + x_max) / 2, (y_min + y_max) / 2, 0.001)
        around = (
            Solid("field", "box", (x_max - x_min, y_max - y_min, 0.002), middle, "wall"),
            Solid("object", "cylinder", OBJECT, pose(*self._place), "object"),
        )
        return Scene(around + self._world.solids(self._body, "gripper"), np.empty((0, 2, 3)), TABLE)
