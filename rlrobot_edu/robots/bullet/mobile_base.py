"""The mobile base in PyBullet: the same sensors and commands as in pymunk, but wheels that roll, slip and get stuck."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.bullet.simulation import BulletRobot, BulletWorld
from rlrobot_edu.robots.mobile_base import LASER_HEIGHT, RADIUS, WHEEL_RADIUS
from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS

URDF = Path(__file__).with_name("mobile_base.urdf")
WHEELS = ("left_wheel", "right_wheel")
PHYSICS_HZ = 120
GRIP = 6.0  # coefficient of friction of the tyres, so high that the base keeps to the arcs of a rolling wheel

_ANGLES = np.arange(len(LASERS)) * math.pi / 4  # of the lasers, from the robot's front to the left [rad]


class Wheels:
    """The wheels and lasers of the base that `body` has in `world`."""

    def __init__(self, world: BulletWorld, body: int) -> None:
        self._world, self._body = world, body
        numbers = world.joints(body)
        self._numbers = [numbers[name] for name in WHEELS]
        self._torque = [world.getJointInfo(body, i)[10] for i in self._numbers]
        for part in range(-1, world.getNumJoints(body)):  # what touches the floor or a wall glides, but for the wheels
            world.changeDynamics(body, part, lateralFriction=GRIP if part in self._numbers else 0.0)
        for wheel in self._numbers:  # as spheres they stick out of the body
            world.floor_only(body, wheel)

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the wheels' speeds to `command` [rad/s]."""
        self._world.setJointMotorControlArray(
            self._body,
            self._numbers,
            self._world.VELOCITY_CONTROL,
            targetVelocities=[command[name] for name in WHEELS],
            forces=self._torque,
        )

    def readings(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        here = self._world.link_pose(self._body, -1)
        x, y, theta = float(here[0, 3]), float(here[1, 3]), math.atan2(here[1, 0], here[0, 0])
        reach = RADIUS + LASER_RANGE  # the rays start in the centre of the body [m]
        parts = self._world.lengths_of_beams(*_rays(x, y, theta, 0.0, reach).swapaxes(0, 1))
        lengths = [min(max(0.0, part * reach - RADIUS), LASER_RANGE) for part in parts]
        return dict(zip(LASERS, lengths, strict=True)) | {"x": x, "y": y, "theta": theta}


def _rays(x: float, y: float, theta: float, near: float, far: float | np.ndarray) -> np.ndarray:
    """Start and end of the beams from `near` to `far` from the robot's centre [m]; array (8, 2, 3) [m]."""
    ahead = np.column_stack([np.cos(theta + _ANGLES), np.sin(theta + _ANGLES), np.zeros(len(_ANGLES))])
    ends = [ahead * np.reshape(distance, (-1, 1)) for distance in (near, far)]
    return np.array([x, y, LASER_HEIGHT]) + np.stack(ends, axis=1)


def beams(readings: Mapping[str, float]) -> np.ndarray:
    """The laser beams for a viewer to draw; array (8, 2, 3) [m]."""
    lengths = np.array([readings[laser] for laser in LASERS])
    return _rays(readings["x"], readings["y"], readings["theta"], RADIUS, RADIUS + lengths)


def add_room(world: BulletWorld, solids: tuple[Solid, ...]) -> None:
    """Put a floor and the walls among `solids` into `world`; a goal is only painted on the floor."""
    world.changeDynamics(world.add_floor(), -1, lateralFriction=1.0)
    world.add_walls([solid for solid in solids if solid.role == "wall"])


class BulletBase(BulletRobot):
    """A round body on two driven wheels and two casters, in an arena. Its wheels hold, or slip, by friction.

    scene: name of an arena
    step_time: duration of one control step [s]
    """

    def __init__(self, scene: str, step_time: float) -> None:
        self._arena = ARENAS[scene]
        world = BulletWorld(PHYSICS_HZ)
        add_room(world, self._arena.solids())
        x, y, theta = self._arena.start
        self._body = world.load(URDF, (x, y, WHEEL_RADIUS), theta)
        self._wheels = Wheels(world, self._body)
        super().__init__("mobile_base", world, step_time)

    def _drive(self, command: Mapping[str, float]) -> None:
        self._wheels.drive(command)

    def _sense(self) -> dict[str, float]:
        return self._wheels.readings()

    def scene(self) -> Scene:
        """The arena, the robot and its laser beams at this instant."""
        robot = self._world.solids(self._body, "chassis")
        return Scene(self._arena.solids() + robot, beams(self._readings), self._arena.bounds)
