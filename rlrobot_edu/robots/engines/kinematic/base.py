"""The mobile base without a physics engine: what ``engine="kinematic"`` makes of it."""

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import pymunk
from numpy.typing import NDArray

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.robots.arenas import Arena, Place
from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.robots.engines.kinematic.holding import drive_held
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.robots.engines.kinematic.robot import KinematicRobot
from rlrobot_edu.robots.engines.kinematic.trigonometry import cosine, sine
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.wheeled_base import WheeledBase
from rlrobot_edu.task.robot_cards import LASER_RANGE

Array = NDArray[np.float64]

# Columns of `place`
LAST_V = 3  # [m/s]
LAST_OMEGA = 4  # [rad/s]


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
            raise ValueError(
                "a kinematic base needs a hull with corners; this chassis is a disc: use engine='pymunk'"
            )
        corners = np.array(chassis.hull) - (chassis.axle, 0.0)
        along = np.roll(corners, -1, axis=0) - corners
        normals = (
            np.stack([along[:, 1], -along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
        )
        x, y, angles = np.array(chassis.lasers).T
        cos, sin = np.cos(angles), np.sin(angles)
        return cls(
            hull=np.concatenate([corners, normals], axis=1),
            radius=float(np.hypot(*corners.T).max()),
            moment=float(pymunk.moment_for_poly(1.0, corners.tolist())),
            rays=np.stack(
                [
                    x - chassis.axle - chassis.inset * cos,
                    y - chassis.inset * sin,
                    cos,
                    sin,
                ],
                axis=1,
            ),
        )


def walls_of(arena: Arena) -> Array:
    """The walls as motion.py describes them; array (n, 6)."""
    boxes = [
        (w.x, w.y, w.length / 2, w.thickness / 2, math.cos(w.angle), math.sin(w.angle))
        for w in arena.walls
    ]
    return np.array(boxes).reshape(-1, 6)  # also without any wall


class Parts(NamedTuple):
    """A base among walls; for `walls`, `near` and `touch` see motion.py, for `contacts` and `motion` holding.py.

    place: array (5,), as in motion.py, then the last command: LAST_V and LAST_OMEGA
    lag: how long the last command goes on before the next one acts [s]
    friction: coefficient of friction between walls and hull
    back: the part of a motion by which the hull comes back out of walls, as `motion`
    """

    place: Array
    body: Body
    walls: Array
    near: NDArray[np.int64]
    touch: Array
    contacts: Array
    motion: Array
    back: Array
    step_time: float  # [s]
    lag: float
    friction: float
    axle: float  # of the chassis [m]
    inset: float  # of its lasers [m]
    reach: float  # of its lasers [m]


@compiled
def roll(base, v, omega, seconds):
    """Drive at v [m/s] and omega [rad/s] for some seconds."""
    if base.friction > 0.0:
        drive_held(base, v, omega, seconds)
        return
    body = base.body
    drive(
        base.place,
        v,
        omega,
        seconds,
        body.hull,
        body.radius,
        body.moment,
        base.walls,
        base.near,
        base.touch,
    )


@compiled
def move(base, command):
    """Drive for one control step; command: array (2,), v [m/s] and omega [rad/s]."""
    place = base.place
    if base.lag > 0.0:
        roll(base, place[LAST_V], place[LAST_OMEGA], base.lag)
    roll(base, command[0], command[1], base.step_time - base.lag)
    place[LAST_V] = command[0]
    place[LAST_OMEGA] = command[1]


@compiled
def sense(base, readings):
    """Fill in n lasers [m], x, y [m], and theta in (−π, π] [rad]; readings: array (n + 3,)."""
    look(base.place, base.body.rays, base.inset + base.reach, base.walls, readings)
    n = base.body.rays.shape[0]
    for k in range(n):
        readings[k] = min(max(readings[k] - base.inset, 0.0), base.reach)
    readings[n] = base.place[0] - base.axle * cosine(base.place[2])
    readings[n + 1] = base.place[1] - base.axle * sine(base.place[2])
    readings[n + 2] = base.place[2]


class KinematicBase(KinematicRobot, WheeledBase):
    """A body on two wheels that moves on exact arcs; walls push its hull away, which turns it, too.

    It has no momentum. It looks like the base in pymunk.

    scene: name of an arena, or a room
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; None takes its own. Raises ValueError for a disc.
    realism: imperfections of the robot. Lag and wall friction act here, the others in `RealisticRobot`; by default
        there are none. Raises ValueError if the robot cannot have them
    """

    kernels = move, sense

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
        realism.check(self._card, "kinematic", step_time)
        self.realism = realism
        self.reset()

    def _begin(self, rng: np.random.Generator) -> None:
        chassis = self.chassis
        x, y, theta = self.arena.start
        self._start = np.array([*chassis.axle_at(x, y, theta), theta, 0.0, 0.0])
        self._arena_of_parts = self.arena
        walls = walls_of(self.arena)
        self.parts = Parts(
            place=self._start.copy(),
            body=Body.of(chassis),
            walls=walls,
            near=np.empty(len(walls), np.int64),
            touch=np.empty(7),
            contacts=np.empty((2 * len(walls), 7)),
            motion=np.empty(3),
            back=np.empty(3),
            step_time=self._step_time,
            lag=self.realism.lag,
            friction=self.realism.wall_friction,
            axle=chassis.axle,
            inset=chassis.inset,
            reach=LASER_RANGE,
        )

    def start(self) -> Array | None:
        """The place at which each episode begins, array (5,).

        None once `arena` has been replaced: the next episode begins elsewhere.
        """
        if self.arena is not self._arena_of_parts:
            return None
        return self._start

    def command_array(self, command: Mapping[str, float]) -> Array:
        """Speed ahead [m/s] and turning to the left [rad/s], array (2,)."""
        return np.array(self.chassis.twist(command))
