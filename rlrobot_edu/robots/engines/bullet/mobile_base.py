"""The mobile base in PyBullet: the same sensors and commands as in pymunk, but wheels that roll, slip and get stuck."""

import math
from collections.abc import Mapping
from pathlib import Path

from rlrobot_edu.robots.arenas import Arena, Place
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.bullet.robot import BulletRobot, Motors
from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
from rlrobot_edu.task.robot_cards import WHEELS

URDF = Path(__file__).with_name("mobile_base.urdf")
PHYSICS_HZ = 120
GRIP = 6.0  # coefficient of friction of the tyres, so high that the base keeps to the arcs of a rolling wheel


class Wheels:
    """The wheels of the base that is part of `body`, and the lasers of `level`, which neither rolls nor pitches."""

    def __init__(
        self, simulation: BulletSimulation, body: int, level: KinematicBase
    ) -> None:
        self._simulation = simulation
        self._body = body
        self._level = level
        self._motors = Motors(simulation, body, WHEELS)
        wheels = self._motors.numbers.values()
        for part in range(-1, simulation.getNumJoints(body)):
            friction = GRIP if part in wheels else 0.0  # all but the wheels glide
            simulation.changeDynamics(body, part, lateralFriction=friction)
        for wheel in wheels:  # as spheres they stick out of the body
            simulation.floor_only(body, wheel)

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the wheels' speeds to `command` [rad/s]."""
        self._motors.drive(command)

    def readings(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        here = self._simulation.link_pose(self._body, -1)
        theta = math.atan2(here[1, 0], here[0, 0])
        self._level.parts.place[:3] = (here[0, 3], here[1, 3], theta)
        return self._level.look()


def add_arena(simulation: BulletSimulation, arena: Arena) -> None:
    """Put a floor and the walls of `arena` into `simulation`; a goal is only painted on the floor."""
    simulation.changeDynamics(simulation.add_floor(), -1, lateralFriction=1.0)
    for solid in arena.solids():
        if solid.role == "wall":
            simulation.add(solid)


def load(simulation: BulletSimulation, urdf: Path, arena: Arena) -> int:
    """Put a robot with this chassis at its start in `arena`; returns the number of its body."""
    x, y, theta = arena.start
    axle_x, axle_y = PIONEER.axle_at(x, y, theta)
    place = (axle_x, axle_y, PIONEER.wheel_radius)
    return simulation.load(urdf, place, theta)


class BulletBase(BulletRobot):
    """A body on two driven wheels and two casters, in an arena. Its wheels hold, or slip, by friction.

    scene: name of an arena, or a room
    step_time: duration of one control step [s]
    """

    def __init__(self, scene: Place, step_time: float) -> None:
        simulation = BulletSimulation(PHYSICS_HZ)
        level = KinematicBase(scene, step_time)
        add_arena(simulation, level.arena)
        body = load(simulation, URDF, level.arena)
        wheels = Wheels(simulation, body, level)
        super().__init__("mobile_base", simulation, body, [wheels], step_time, level)
