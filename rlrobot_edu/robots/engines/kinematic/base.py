"""The mobile base without a physics engine: what ``engine="kinematic"`` makes of it."""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import pymunk
from numpy.typing import NDArray

from rlrobot_edu.robots.arenas import Arena, Place
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.robots.mobile_base import Chassis, MobileBase
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS

Array = NDArray[np.float64]


class Body(NamedTuple):
    """What the kernels know of a robot: the arrays and numbers that motion.py describes."""

    hull: Array
    radius: float
    moment: float
    rays: Array

    @classmethod
    def of(cls, chassis: Chassis) -> "Body":
        """The body of this chassis. Raises ValueError if it is a disc."""
        if not chassis.hull:
            raise ValueError("a kinematic base needs a hull with corners; this chassis is a disc: use engine='pymunk'")
        corners = np.array(chassis.hull) - (chassis.axle, 0.0)
        along = np.roll(corners, -1, axis=0) - corners
        normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
        x, y, angles = np.array(chassis.lasers).T
        cos, sin = np.cos(angles), np.sin(angles)
        return cls(
            hull=np.concatenate([corners, normals], axis=1),
            radius=float(np.hypot(*corners.T).max()),
            moment=float(pymunk.moment_for_poly(1.0, corners.tolist())),
            rays=np.stack([x - chassis.axle - chassis.inset * cos, y - chassis.inset * sin, cos, sin], axis=1),
        )


def walls_of(arena: Arena) -> Array:
    """The walls as motion.py describes them; array (n, 6)."""
    boxes = [(w.x, w.y, w.length / 2, w.thickness / 2, math.cos(w.angle), math.sin(w.angle)) for w in arena.walls]
    return np.array(boxes).reshape(-1, 6)  # also without any wall


class KinematicBase(MobileBase):
    """A body on two wheels that moves on exact arcs; walls push its hull away, which turns it, too.

    Without momentum, friction or lag. It looks like the base in pymunk.

    scene: name of an arena, or a drawing of one
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; None takes its own. Raises ValueError for a disc.
    """

    def __init__(self, scene: Place, step_time: float, chassis: Chassis | None = None) -> None:
        self._step_time, self._shape = step_time, Body.of(chassis or self.chassis)
        super().__init__(scene, step_time, chassis)

    def _begin(self, rng: np.random.Generator) -> None:
        self._walls = walls_of(self.arena)
        self._room = np.empty(len(self._walls), np.int64), np.empty(7)  # for the kernels to work in
        x, y, theta = self.arena.start
        axle = self.chassis.axle
        self._place = np.array([x + axle * math.cos(theta), y + axle * math.sin(theta), theta])

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__  # arrays and numbers alone

    def _move(self, command: Mapping[str, float]) -> None:
        """Turn the wheels at `command` (left_wheel, right_wheel [rad/s]) for one control step."""
        v, omega = self.chassis.twist(command)
        hull, radius, moment, _ = self._shape
        drive(self._place, v, omega, self._step_time, hull, radius, moment, self._walls, *self._room)

    def _look(self, rays: Array, reach: float) -> Array:
        """How long the rays are up to the first wall, or `reach` if that is less [m]; array (n,)."""
        lengths = np.empty(len(rays))
        look(self._place, rays, reach, self._walls, lengths)
        return lengths

    def _sense(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        inset, axle = self.chassis.inset, self.chassis.axle
        ranges = np.clip(self._look(self._shape.rays, inset + LASER_RANGE) - inset, 0.0, LASER_RANGE)
        x, y, theta = self._place.tolist()
        here = {"x": x - axle * math.cos(theta), "y": y - axle * math.sin(theta), "theta": theta}
        return dict(zip(LASERS, ranges.tolist(), strict=True)) | here

    def look_around(self, rays: int) -> list[float]:
        """How far it is [m] from the point midway between the wheels to the walls, the first ray straight ahead and the
        others evenly to the left; infinity if there is nothing within twice LASER_RANGE."""
        angles, axle, reach = 2 * math.pi / rays * np.arange(rays), np.zeros(rays), 2 * LASER_RANGE
        lengths = self._look(np.stack([axle, axle, np.cos(angles), np.sin(angles)], axis=1), reach)
        return [length if length < reach else math.inf for length in lengths.tolist()]
