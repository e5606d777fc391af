"""The mobile base in PyBullet: the same sensors and commands as in pymunk, but wheels that roll, slip and get stuck."""

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rlrobot_edu.robots.arenas import ARENAS, Arena
from rlrobot_edu.robots.bullet.robot import BulletRobot, Motors
from rlrobot_edu.robots.bullet.simulation import BulletSimulation
from rlrobot_edu.robots.mobile_base import LASER_ANGLES, LASER_HEIGHT, RADIUS, WHEEL_RADIUS, beams
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, WHEELS

URDF = Path(__file__).with_name("mobile_base.urdf")
PHYSICS_HZ = 120
GRIP = 6.0  # coefficient of friction of the tyres, so high that the base keeps to the arcs of a rolling wheel
REACH = RADIUS + LASER_RANGE  # of a laser's ray, which starts in the centre of the body [m]

_ANGLES = np.array(list(LASER_ANGLES.values()))


class Wheels:
    """The wheels and lasers of the base that is part of `body`."""

    def __init__(self, simulation: BulletSimulation, body: int) -> None:
        self._simulation, self._body, self._motors = simulation, body, Motors(simulation, body, WHEELS)
        wheels = self._motors.numbers
        for part in range(-1, simulation.getNumJoints(body)):  # what touches floor or wall glides, but for the wheels
            simulation.changeDynamics(body, part, lateralFriction=GRIP if part in wheels else 0.0)
        for wheel in wheels:  # as spheres they stick out of the body
            simulation.floor_only(body, wheel)

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the wheels' speeds to `command` [rad/s]."""
        self._motors.drive([command[name] for name in WHEELS])

    def readings(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        here = self._simulation.link_pose(self._body, -1)
        x, y, theta = float(here[0, 3]), float(here[1, 3]), math.atan2(here[1, 0], here[0, 0])
        centre = np.array([x, y, LASER_HEIGHT])
        ahead = np.column_stack([np.cos(theta + _ANGLES), np.sin(theta + _ANGLES), np.zeros(len(LASERS))])
        parts = self._simulation.lengths_of_beams(np.tile(centre, (len(LASERS), 1)), centre + ahead * REACH)
        lengths = [min(max(0.0, part * REACH - RADIUS), LASER_RANGE) for part in parts]
        return dict(zip(LASERS, lengths, strict=True)) | {"x": x, "y": y, "theta": theta}


def add_arena(simulation: BulletSimulation, arena: Arena) -> None:
    """Put a floor and the walls of `arena` into `simulation`; a goal is only painted on the floor."""
    simulation.changeDynamics(simulation.add_floor(), -1, lateralFriction=1.0)
    simulation.add_walls([solid for solid in arena.solids() if solid.role == "wall"])


class BulletBase(BulletRobot):
    """A round body on two driven wheels and two casters, in an arena. Its wheels hold, or slip, by friction.

    scene: name of an arena
    step_time: duration of one control step [s]
    """

    def __init__(self, scene: str, step_time: float) -> None:
        self._arena = ARENAS[scene]
        simulation = BulletSimulation(PHYSICS_HZ)
        add_arena(simulation, self._arena)
        x, y, theta = self._arena.start
        body = simulation.load(URDF, (x, y, WHEEL_RADIUS), theta)
        super().__init__("mobile_base", simulation, body, [Wheels(simulation, body)], step_time, leader="chassis")

    def scene(self) -> Scene:
        """The arena, the robot and its laser beams at this instant."""
        return Scene(self._arena.solids() + self.solids(), beams(self._readings, RADIUS), self._arena.bounds)
