"""The mobile base: a Pioneer 3-DX with eight laser rangefinders, in pymunk (two-dimensional physics)."""

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pymunk
from pymunk._chipmunk import ffi
from pymunk._chipmunk import lib as chipmunk

from rlrobot_edu.robots.arenas import Place
from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.wheeled_base import WheeledBase
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, WHEELS

# `_roll` and `_free_part`, where most of the time goes, call pymunk's library in C. For this they need private names
# of pymunk: `_chipmunk`, `_space` and `_body`. With its public functions, which do the same to the last bit, learning
# on wander_1k has 27 % fewer steps a second (median of 15 runs in turn: 2,820 instead of 3,640).

SUBSTEP = 0.05  # longest physics step [s]: at double speed (0.2 m/s) the body enters a wall by less than 1 cm
Point = tuple[float, float]  # x, y [m]

_NOT_ITSELF = pymunk.ShapeFilter(group=1)  # the rays do not see the body they start in


class Ray(NamedTuple):
    """The path of a laser beam, in the robot's frame: where it begins, and the way from there to its end [m]."""

    x: float
    y: float
    dx: float
    dy: float


def rays_of(chassis: Chassis) -> dict[str, Ray]:
    """The ray of each laser; it begins `inset` behind the laser."""
    reach = chassis.inset + LASER_RANGE
    rays = {}
    for laser, (x, y, angle) in zip(LASERS, chassis.lasers, strict=True):
        ahead, aside = math.cos(angle), math.sin(angle)
        start_x = x - chassis.inset * ahead
        start_y = y - chassis.inset * aside
        rays[laser] = Ray(start_x, start_y, reach * ahead, reach * aside)
    return rays


class MobileBase(WheeledBase):
    """A body on two wheels. In free space its axle moves on the exact circular arc; along a wall it slides.

    The wheels grip: the body has no momentum of its own (damping 0). In each sub-step a force and a torque give it the
    commanded velocities, and pymunk then removes the part of the motion that would enter a wall. So a wall also turns
    the body, as far as it pushes beside the axle.

    A copy goes on as the robot does, to the last bit.

    scene: name of an arena, or a room
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; by default those of its class
    realism: imperfections to simulate. Lag and wall friction act here, the others in `RealisticRobot`; by default there
        are none. Raises ValueError if the robot cannot have them
    """

    def __init__(
        self,
        scene: Place,
        step_time: float,
        chassis: Chassis | None = None,
        realism: Realism | None = None,
    ) -> None:
        super().__init__(scene, step_time, chassis)
        if realism is None:
            realism = Realism()
        realism.check(self._card, "pymunk", step_time)
        self._lag = realism.lag
        self._wall_friction = realism.wall_friction
        self._rays = rays_of(self.chassis)
        self.reset()

    def _begin(self, rng: np.random.Generator) -> None:
        # A new space each time: an old one remembers past contacts, and runs would not repeat bit for bit.
        self._space = self._new_space()
        self._body, self._outline = self._new_body()
        self._space.add(self._body, self._outline)
        x, y, theta = self.arena.start
        self._body.position = self.chassis.axle_at(x, y, theta)
        self._body.angle = theta
        self._last_command = dict.fromkeys(WHEELS, 0.0)

    def _new_space(self) -> pymunk.Space:
        """A space with the walls of the arena."""
        space = pymunk.Space()
        space.damping = 0.0
        space.collision_slop = 0.001  # [m]; the default of 0.1 is made for pixels
        for wall in self.arena.walls:
            panel = pymunk.Poly(space.static_body, wall.corners().tolist())
            panel.friction = 1.0  # pymunk multiplies the frictions of two bodies
            space.add(panel)
        return space

    def _new_body(self) -> tuple[pymunk.Body, pymunk.Shape]:
        """The body and its outline. Its position is that of the axle, so the wheels' velocities are the body's own."""
        axle, radius = self.chassis.axle, self.chassis.radius
        hull = [(x - axle, y) for x, y in self.chassis.hull]
        outline: pymunk.Shape
        if hull:
            body = pymunk.Body(1.0, pymunk.moment_for_poly(1.0, hull))
            outline = pymunk.Poly(body, hull)
        else:
            body = pymunk.Body(1.0, pymunk.moment_for_circle(1.0, 0.0, radius))
            outline = pymunk.Circle(body, radius)
        outline.friction = self._wall_friction
        outline.filter = _NOT_ITSELF
        return body, outline

    def _move(self, command: Mapping[str, float]) -> None:
        """Turn the wheels at `command` (left_wheel, right_wheel [rad/s]) for one control step."""
        self._forget_contacts()
        if self._lag:
            self._roll(self._last_command, self._lag)
        self._roll(command, self._step_time - self._lag)
        self._last_command = dict(command)
        self._keep_push_as_velocity()

    def _forget_contacts(self) -> None:
        """Take the outline out and put it back: pymunk does not copy what it remembers of past contacts."""
        self._space.remove(self._outline)
        self._space.add(self._outline)

    def _keep_push_as_velocity(self) -> None:
        """Add to the body's velocities the speeds at which a wall pushes it out, because pymunk does not copy those.

        pymunk can only move a body by the sums of both. The motion of 1 s, from position 0 and angle 0, is these sums.
        """
        body = self._body
        position, angle = body.position, body.angle
        body.position = (0.0, 0.0)
        body.angle = 0.0
        pymunk.Body.update_position(body, 1.0)
        body.velocity = body.position
        body.angular_velocity = body.angle
        body.position = position
        body.angle = angle

    def _roll(self, wheels: Mapping[str, float], seconds: float) -> None:
        """Turn the wheels at these speeds [rad/s] for a while [s].

        In a sub-step of dt the axle moves on an arc, which turns it by ω dt. Its place changes by the chord of the arc,
        whose direction is ω dt / 2 to the left of the heading at the beginning of the arc.

        pymunk first moves the body with the velocities that it has, then finds the next ones from force and torque. So
        the robot, at rest, moves from the second sub-step on; it stops in one more, in which nothing drives it. When
        the force acts, the body has still to turn with its present velocity until the arc begins.
        """
        v, omega = self.chassis.twist(wheels)
        n = math.ceil(seconds / SUBSTEP)
        dt = seconds / n
        turn = omega * dt
        chord = v * dt  # the length of the arc, at first
        if turn:
            chord *= math.sin(turn / 2) / (turn / 2)
        force = chord / dt**2  # gives 1 kg at rest the velocity chord / dt
        torque = turn / dt**2 * self._body.moment
        space, body = self._space._space, self._body._body
        turn_until_then = 0.0
        for _ in range(n):
            if force:
                direction = turn / 2 + turn_until_then
                push = (force * math.cos(direction), force * math.sin(direction))
                chipmunk.cpBodyApplyForceAtLocalPoint(body, push, (0, 0))
            if torque:
                chipmunk.cpBodySetTorque(body, torque)  # 0 after each sub-step
            chipmunk.cpSpaceStep(space, dt)
            turn_until_then = chipmunk.cpBodyGetAngularVelocity(body) * dt
        chipmunk.cpSpaceStep(space, dt)
        self._body.angle = math.remainder(self._body.angle, 2 * math.pi)

    def _sense(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        axle_x, axle_y = self._body.position
        theta = self._body.angle
        cos, sin = math.cos(theta), math.sin(theta)
        x = axle_x - self.chassis.axle * cos
        y = axle_y - self.chassis.axle * sin
        inset = self.chassis.inset
        readings = {}
        for laser, ray in self._rays.items():
            start_x = x + cos * ray.x - sin * ray.y
            start_y = y + sin * ray.x + cos * ray.y
            end_x = start_x + cos * ray.dx - sin * ray.dy
            end_y = start_y + sin * ray.dx + cos * ray.dy
            free_part = self._free_part((start_x, start_y), (end_x, end_y))
            distance = free_part * (inset + LASER_RANGE) - inset
            readings[laser] = min(max(0.0, distance), LASER_RANGE)
        if theta == -math.pi:
            theta = math.pi
        return readings | {"x": x, "y": y, "theta": theta}

    def look_around(self, rays: int) -> list[float]:
        """Distances [m] from the middle of the axle to the walls, in evenly spread directions.

        The first ray points straight ahead, the others follow to the left. A distance is infinite if there is no wall
        within twice LASER_RANGE.
        """
        x, y = self._body.position
        reach = 2 * LASER_RANGE
        distances = []
        for angle in self._body.angle + 2 * math.pi / rays * np.arange(rays):
            end = (x + reach * math.cos(angle), y + reach * math.sin(angle))
            distances.append(self._free_part((x, y), end) * reach)
        return distances

    def _free_part(self, start: Point, end: Point) -> float:
        """The part of the way from start to end that is free up to the first wall, 0 to 1; infinite without a wall."""
        hit = ffi.new("cpSegmentQueryInfo *")
        wall = chipmunk.cpSpaceSegmentQueryFirst(
            self._space._space, start, end, 0.0, _NOT_ITSELF, hit
        )
        return hit.alpha if wall else math.inf
