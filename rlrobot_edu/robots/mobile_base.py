"""The mobile base: a Pioneer 3-DX with eight laser rangefinders, in pymunk (two-dimensional physics)."""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import pymunk

from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, ROBOTS


class Chassis(NamedTuple):
    """Dimensions of a robot on two wheels [m].

    radius: of the body; on its rim are the lasers
    wheel_radius, wheel_separation: size and distance of the wheels
    bumper: radius of the disc that meets walls, as far as the outermost parts of the robot reach when it turns
    """

    radius: float
    wheel_radius: float
    wheel_separation: float
    bumper: float


# The bumper is the swing radius that the maker gives. With it the robot meets walls as the one in the paper's V-REP
# recording does, see docs/vrep_comparison.md.
PIONEER = Chassis(radius=0.22, wheel_radius=0.0975, wheel_separation=0.33, bumper=0.267)
RADIUS, WHEEL_RADIUS = PIONEER.radius, PIONEER.wheel_radius
LASER_HEIGHT = 0.20  # [m]
SUBSTEP = 0.05  # longest physics step [s]: at double speed (0.2 m/s) the body enters a wall by less than 1 cm

LASER_ANGLES = {laser: i * math.pi / 4 for i, laser in enumerate(LASERS)}  # from the front to the left [rad]

_DIRECTIONS = {laser: (math.cos(angle), math.sin(angle)) for laser, angle in LASER_ANGLES.items()}
_NOT_ITSELF = pymunk.ShapeFilter(group=1)  # the rays do not see the body they start in
_ON_ITS_SIDE = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def beams(readings: Mapping[str, float], radius: float) -> np.ndarray:
    """The laser beams from the rim of a body of this `radius` [m], for a viewer to draw; array (8, 2, 3) [m]."""
    here = pose(readings["x"], readings["y"], 0.0, readings["theta"])
    ends = [
        [here @ (dx * r, dy * r, LASER_HEIGHT, 1.0) for r in (radius, radius + readings[laser])]
        for laser, (dx, dy) in _DIRECTIONS.items()
    ]
    return np.array(ends)[:, :, :3]


class MobileBase(SimulatedRobot):
    """A disc on two wheels. In free space it moves on the exact circular arc; along a wall it slides.

    The wheels grip: the body has no momentum of its own (damping 0). In each sub-step a force gives it the commanded
    velocity, and pymunk then takes away the part that would go into a wall. Only its wheels turn it.

    A copy goes on as the robot does, to the last bit. Only where two walls that are not at right angles hold them both,
    pymunk may see to the walls in another order, and the copy is up to 1e-6 m away.

    scene: name of an arena
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; None takes its own
    """

    name = "mobile_base"
    chassis = PIONEER

    def __init__(self, scene: str, step_time: float, chassis: Chassis | None = None) -> None:
        super().__init__(ROBOTS[self.name])
        self.chassis = chassis or self.chassis
        self._arena = ARENAS[scene]
        self._n_substeps = math.ceil(step_time / SUBSTEP)
        self._dt = step_time / self._n_substeps
        self.reset()

    def _begin(self, rng: np.random.Generator) -> None:
        # A new space each time: an old one remembers past contacts, and runs would not repeat bit for bit.
        self._space = pymunk.Space()
        self._space.damping = 0.0
        self._space.collision_slop = 0.001  # [m]; the default of 0.1 is made for pixels
        for wall in self._arena.walls:
            self._space.add(pymunk.Poly(self._space.static_body, wall.corners().tolist()))
        self._body = pymunk.Body(mass=1.0, moment=math.inf)
        disc = pymunk.Circle(self._body, self.chassis.bumper)
        disc.filter = _NOT_ITSELF
        self._space.add(self._body, disc)
        x, y, self._theta = self._arena.start
        self._body.position = x, y

    def __getstate__(self) -> dict[str, Any]:
        # pymunk's copies lack one thing: the speed at which a wall pushes the body out. It counts only together with
        # the velocity, so the velocity may as well hold both: their sum is how far the body would get in 1 s.
        body, here = self._body, self._body.position
        body.position = 0, 0
        body.update_position(body, 1.0)
        body.velocity, body.position = body.position, here
        return self.__dict__

    def _move(self, command: Mapping[str, float]) -> None:
        """Turn the wheels at `command` (left_wheel, right_wheel [rad/s]) for one control step."""
        left, right = command["left_wheel"], command["right_wheel"]
        turn = (right - left) * self.chassis.wheel_radius / self.chassis.wheel_separation * self._dt
        chord = (left + right) / 2 * self.chassis.wheel_radius * self._dt
        if turn:
            chord *= math.sin(turn / 2) / (turn / 2)  # from the length of an arc to that of its chord
        force = chord / self._dt**2  # that gives 1 kg at rest the velocity chord/dt in one sub-step
        # A sub-step of pymunk first moves the body with the velocity it has, then finds the next velocity. So the
        # robot, at rest, moves from the second sub-step on, and stops in the last one, in which no force acts.
        for i in range(self._n_substeps):
            heading = self._theta + (i + 0.5) * turn
            self._body.force = (force * math.cos(heading), force * math.sin(heading))
            self._space.step(self._dt)
        self._space.step(self._dt)
        self._theta = math.remainder(self._theta + self._n_substeps * turn, 2 * math.pi)

    def _sense(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        x, y = centre = self._body.position
        cos, sin = math.cos(self._theta), math.sin(self._theta)
        radius, readings = self.chassis.radius, {}
        reach = radius + LASER_RANGE  # the rays start in the centre of the body [m]
        for laser, (ahead, aside) in _DIRECTIONS.items():
            dx, dy = reach * ahead, reach * aside
            end = (x + cos * dx - sin * dy, y + sin * dx + cos * dy)
            hit = self._space.segment_query_first(centre, end, 0.0, _NOT_ITSELF)
            readings[laser] = LASER_RANGE if hit is None else min(max(0.0, hit.alpha * reach - radius), LASER_RANGE)
        theta = math.pi if self._theta == -math.pi else self._theta
        return readings | {"x": x, "y": y, "theta": theta}

    def solids(self) -> tuple[Solid, ...]:
        """The robot's parts, with their poses on the robot."""
        radius, wheel, separation, bumper = self.chassis
        return (
            Solid("robot/body", "cylinder", (radius, 0.16), pose(0, 0, 0.16), "robot"),
            Solid("robot/bumper", "cylinder", (bumper, 0.02), pose(0, 0, 0.11), "robot"),
            Solid("robot/nose", "box", (0.14, 0.06, 0.04), pose(radius - 0.07, 0, 0.26), "robot"),
            *(
                Solid(f"robot/{side}_wheel", "cylinder", (wheel, 0.04), pose(0, y, wheel) @ _ON_ITS_SIDE, "wheel")
                for side, y in (("left", separation / 2), ("right", -separation / 2))
            ),
        )

    def scene(self) -> Scene:
        """The arena, the robot and its laser beams at this instant."""
        x, y, theta = (self._readings[name] for name in ("x", "y", "theta"))
        here = pose(x, y, 0.0, theta)
        robot = tuple(solid._replace(pose=here @ solid.pose) for solid in self.solids())
        return Scene(self._arena.solids() + robot, beams(self._readings, self.chassis.radius), self._arena.bounds)
