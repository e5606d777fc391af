"""The mobile base: a Pioneer 3-DX with eight laser rangefinders, in pymunk (two-dimensional physics)."""

import math
from collections.abc import Mapping

import numpy as np
import pymunk
from pymunk._chipmunk import ffi
from pymunk._chipmunk import lib as chipmunk

from rlrobot_edu.robots.arenas import Place, arena_of
from rlrobot_edu.robots.chassis import PIONEER, Chassis, laser_beams
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import ON_ITS_SIDE, Scene, Solid, pose
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, ROBOTS, WHEELS

# `_roll` and `_free_part`, where most of the time goes, call pymunk's library in C. For this they need private names
# of pymunk: `_chipmunk`, `_space` and `_body`. With its public functions, which do the same to the last bit, learning
# on wander_1k has 27 % fewer steps a second (median of 15 runs in turn: 2,820 instead of 3,640).

SUBSTEP = 0.05  # longest physics step [s]: at double speed (0.2 m/s) the body enters a wall by less than 1 cm

_NOT_ITSELF = pymunk.ShapeFilter(group=1)  # the rays do not see the body they start in


class MobileBase(SimulatedRobot):
    """A body on two wheels. In free space its axle moves on the exact circular arc; along a wall it slides.

    The wheels grip: the body has no momentum of its own (damping 0). In each sub-step a force and a torque give it the
    commanded velocities, and pymunk then removes the part of the motion that would enter a wall. So walls turn it,
    too, as far as they push beside its axle.

    A copy goes on as the robot does, to the last bit.

    scene: name of an arena, or a room
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; None takes its own
    realism: its weaknesses, of which lag and wall friction act here, the others in a `RealisticRobot`; None is the
        ideal robot. Raises ValueError if it cannot have them
    arena: where it is; another one counts from the next `reset` on
    """

    name = "mobile_base"
    chassis = PIONEER

    def __init__(
        self,
        scene: Place,
        step_time: float,
        chassis: Chassis | None = None,
        realism: Realism | None = None,
    ) -> None:
        super().__init__(ROBOTS[self.name])
        realism = realism or Realism()
        realism.check(self._card, "pymunk", step_time)
        self.chassis = chassis or self.chassis
        self.arena = arena_of(scene)
        self._step_time = step_time
        self._lag = realism.lag
        self._friction = realism.wall_friction
        inset = self.chassis.inset
        reach = inset + LASER_RANGE
        self._rays = []  # where each begins, and its way from there
        for laser, (x, y, angle) in zip(LASERS, self.chassis.lasers, strict=True):
            ahead, aside = math.cos(angle), math.sin(angle)
            start = x - inset * ahead, y - inset * aside
            self._rays.append((laser, *start, reach * ahead, reach * aside))
        self.reset()

    def _begin(self, rng: np.random.Generator) -> None:
        # A new space each time: an old one remembers past contacts, and runs would not repeat bit for bit.
        self._space = pymunk.Space()
        self._space.damping = 0.0
        self._space.collision_slop = 0.001  # [m]; the default of 0.1 is made for pixels
        for wall in self.arena.walls:
            panel = pymunk.Poly(self._space.static_body, wall.corners().tolist())
            panel.friction = 1.0  # pymunk multiplies the two of a contact
            self._space.add(panel)
        # Its position is that of the axle: so the wheels' velocities are the body's own.
        axle, radius = self.chassis.axle, self.chassis.radius
        hull = [(x - axle, y) for x, y in self.chassis.hull]
        self._outline: pymunk.Shape
        if hull:
            self._body = pymunk.Body(1.0, pymunk.moment_for_poly(1.0, hull))
            self._outline = pymunk.Poly(self._body, hull)
        else:
            moment = pymunk.moment_for_circle(1.0, 0.0, radius)
            self._body = pymunk.Body(1.0, moment)
            self._outline = pymunk.Circle(self._body, radius)
        self._outline.friction = self._friction
        self._outline.filter = _NOT_ITSELF
        self._space.add(self._body, self._outline)
        x, y, theta = self.arena.start
        self._body.position = self.chassis.axle_at(x, y, theta)
        self._body.angle = theta
        self._former = dict.fromkeys(WHEELS, 0.0)

    def _move(self, command: Mapping[str, float]) -> None:
        """Turn the wheels at `command` (left_wheel, right_wheel [rad/s]) for one control step."""
        self._forget_contacts()
        if self._lag:
            self._roll(*self.chassis.twist(self._former), self._lag)
        self._roll(*self.chassis.twist(command), self._step_time - self._lag)
        self._former = dict(command)
        self._keep_push_as_velocity()

    def _forget_contacts(self) -> None:
        """Put the outline anew: a copy would not share its memory of past contacts to the last bit."""
        self._space.remove(self._outline)
        self._space.add(self._outline)

    def _keep_push_as_velocity(self) -> None:
        """Add the speeds at which a wall pushes the body out to its velocities: pymunk's copies lack them.

        They count only together with the velocities. Their sum is how far the body would get in 1 s.
        """
        body = self._body
        here, heading = body.position, body.angle
        body.position = 0.0, 0.0
        body.angle = 0.0
        pymunk.Body.update_position(body, 1.0)
        body.velocity = body.position
        body.angular_velocity = body.angle
        body.position = here
        body.angle = heading

    def _roll(self, v: float, omega: float, seconds: float) -> None:
        """Drive at v [m/s] and turn at ω [rad/s] for a while [s]."""
        n = math.ceil(seconds / SUBSTEP)
        dt = seconds / n
        turn = omega * dt
        chord = v * dt
        if turn:
            chord *= math.sin(turn / 2) / (
                turn / 2
            )  # from the length of an arc to that of its chord
        force = (
            chord / dt**2
        )  # that gives 1 kg at rest the velocity chord/dt in one sub-step
        torque = turn / dt**2 * self._body.moment
        # A sub-step of pymunk first moves the body with the velocities it has, then finds the next ones. So the robot,
        # at rest, moves from the second sub-step on, and stops in the last one, in which nothing drives it. The chord
        # lies half a turn from the heading that the body will have after it has moved.
        space, body = self._space._space, self._body._body
        turned_until_then = 0.0
        for _ in range(n):
            if force:
                lead = turn / 2 + turned_until_then
                push = force * math.cos(lead), force * math.sin(lead)
                chipmunk.cpBodyApplyForceAtLocalPoint(body, push, (0, 0))
            if torque:
                chipmunk.cpBodySetTorque(body, torque)  # 0 after each sub-step
            chipmunk.cpSpaceStep(space, dt)
            turned_until_then = chipmunk.cpBodyGetAngularVelocity(body) * dt
        chipmunk.cpSpaceStep(space, dt)
        self._body.angle = math.remainder(self._body.angle, 2 * math.pi)

    def _sense(self) -> dict[str, float]:
        """Lasers [m], x, y [m], theta in (−π, π] [rad]."""
        x, y = self._body.position
        theta = self._body.angle
        cos, sin = math.cos(theta), math.sin(theta)
        x, y = x - self.chassis.axle * cos, y - self.chassis.axle * sin
        inset, readings = self.chassis.inset, {}
        for laser, ahead, aside, dx, dy in self._rays:
            start_x, start_y = (
                x + cos * ahead - sin * aside,
                y + sin * ahead + cos * aside,
            )
            end = (start_x + cos * dx - sin * dy, start_y + sin * dx + cos * dy)
            way = self._free_part((start_x, start_y), end) * (inset + LASER_RANGE)
            readings[laser] = min(max(0.0, way - inset), LASER_RANGE)
        return readings | {
            "x": x,
            "y": y,
            "theta": math.pi if theta == -math.pi else theta,
        }

    def look_around(self, rays: int) -> list[float]:
        """How far it is [m] from the point midway between the wheels to the walls, the first ray straight ahead and the
        others evenly to the left; infinity if there is nothing within twice LASER_RANGE."""
        x, y = self._body.position
        reach = 2 * LASER_RANGE
        angles = self._body.angle + 2 * math.pi / rays * np.arange(rays)
        ends = [
            (x + reach * math.cos(angle), y + reach * math.sin(angle))
            for angle in angles
        ]
        return [self._free_part((x, y), end) * reach for end in ends]

    def _free_part(self, start: tuple[float, float], end: tuple[float, float]) -> float:
        """What part of the way from start to end [m] is free up to the first wall; infinity without a wall."""
        hit = ffi.new("cpSegmentQueryInfo *")
        wall = chipmunk.cpSpaceSegmentQueryFirst(
            self._space._space, start, end, 0.0, _NOT_ITSELF, hit
        )
        return hit.alpha if wall else math.inf

    def solids(self) -> tuple[Solid, ...]:
        """The robot's parts, with their poses on the robot."""
        chassis, half = self.chassis, self.chassis.wheel_separation / 2
        tyre = "cylinder", (chassis.wheel_radius, 0.04)
        left, right = (
            pose(chassis.axle, y, chassis.wheel_radius) @ ON_ITS_SIDE
            for y in (half, -half)
        )
        return (
            Solid("robot/body", *chassis.body(), pose(0, 0, 0.16), "robot"),
            Solid(
                "robot/nose",
                "box",
                (0.14, 0.06, 0.04),
                pose(chassis.radius - 0.075, 0, 0.26),
                "robot",
            ),
            Solid("robot/left_wheel", *tyre, left, "wheel"),
            Solid("robot/right_wheel", *tyre, right, "wheel"),
        )

    def scene(self) -> Scene:
        """The arena, the robot and its laser beams at this instant."""
        x, y, theta = (self._readings[name] for name in ("x", "y", "theta"))
        here = pose(x, y, 0.0, theta)
        robot = tuple(solid._replace(pose=here @ solid.pose) for solid in self.solids())
        return Scene(
            self.arena.solids() + robot,
            laser_beams(self._readings, self.chassis),
            self.arena.bounds,
        )
