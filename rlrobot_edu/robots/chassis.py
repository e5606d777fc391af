"""The dimensions of each robot on wheels: its wheels, its body and where its lasers are."""

import math
from collections.abc import Mapping
from itertools import chain
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import pose
from rlrobot_edu.task.robot_cards import LASERS, WHEELS

LASER_HEIGHT = 0.20  # above the floor [m]
BODY_HEIGHT = 0.16  # [m]
EIGHTH_OF_A_TURN = math.pi / 4  # [rad]


class Chassis(NamedTuple):
    """Dimensions of a robot on two wheels [m].

    They are given in the frame whose x, y and theta the robot senses: x ahead, y to the left.

    wheel_radius, wheel_separation: size and distance of the wheels
    axle: x of the point midway between the wheels, about which the robot turns on the spot
    lasers: x, y and direction [rad] of each laser, in the order of LASERS
    inset: how far behind its laser a ray begins: inside the body, so that a wall in contact is seen
    hull: corners of the body's outline, counter-clockwise; without any it is a disc
    radius: of the disc, or of the circle about the frame in which the hull fits
    """

    wheel_radius: float
    wheel_separation: float
    axle: float
    lasers: tuple[tuple[float, float, float], ...]
    inset: float
    hull: tuple[tuple[float, float], ...]
    radius: float

    def body(self) -> tuple[str, tuple[float, ...]]:
        """Shape and size of the body as a `Solid`."""
        if not self.hull:
            return "cylinder", (self.radius, BODY_HEIGHT)
        coordinates = chain.from_iterable(self.hull)
        return "prism", (*coordinates, BODY_HEIGHT)

    def axle_at(self, x: float, y: float, theta: float) -> tuple[float, float]:
        """Where the middle of the axle is [m] while the robot senses x, y [m] and theta [rad]."""
        axle_x = x + self.axle * math.cos(theta)
        axle_y = y + self.axle * math.sin(theta)
        return axle_x, axle_y

    def twist(self, wheels: Mapping[str, float]) -> tuple[float, float]:
        """Speed ahead v [m/s] and turning to the left ω [rad/s] of wheels that turn at these speeds [rad/s]."""
        left, right = (wheels[wheel] for wheel in WHEELS)
        v = self.wheel_radius * (left + right) / 2
        omega = self.wheel_radius * (right - left) / self.wheel_separation
        return v, omega

    def wheel_speeds(self, v: float, omega: float) -> dict[str, float]:
        """Speeds of the wheels [rad/s] with which the robot drives at v [m/s] and turns at ω [rad/s]."""
        aside = omega * self.wheel_separation / 2
        left = (v - aside) / self.wheel_radius
        right = (v + aside) / self.wheel_radius
        return dict(zip(WHEELS, (left, right), strict=True))


def laser_beams(readings: Mapping[str, float], chassis: Chassis) -> np.ndarray:
    """The laser beams, for a viewer to draw; array (8, 2, 3) [m]."""
    here = pose(readings["x"], readings["y"], 0.0, readings["theta"])
    beams = []
    for laser, (x, y, angle) in zip(LASERS, chassis.lasers, strict=True):
        reading = readings[laser]
        hit_x = x + reading * math.cos(angle)
        hit_y = y + reading * math.sin(angle)
        start = here @ (x, y, LASER_HEIGHT, 1.0)
        end = here @ (hit_x, hit_y, LASER_HEIGHT, 1.0)
        beams.append([start[:3], end[:3]])
    return np.array(beams)


_LEFT_SIDE = (
    (0.260, 0.045),
    (0.225, 0.140),
    (0.135, 0.208),
    (-0.099, 0.200),
    (-0.199, 0.150),
    (-0.259, 0.050),
)
_RIGHT_SIDE = tuple((x, -y) for x, y in reversed(_LEFT_SIDE))
PIONEER = Chassis(  # a Pioneer 3-DX, measured in the paper's V-REP scenes
    wheel_radius=0.0975,
    wheel_separation=0.331,
    axle=0.045,
    lasers=(
        (0.220, 0.0, 0.0),
        (0.194, 0.094, EIGHTH_OF_A_TURN),
        (0.0, 0.170, 2 * EIGHTH_OF_A_TURN),
        (-0.194, 0.094, 3 * EIGHTH_OF_A_TURN),
        (-0.220, 0.0, 4 * EIGHTH_OF_A_TURN),
        (-0.194, -0.094, 5 * EIGHTH_OF_A_TURN),
        (0.0, -0.170, 6 * EIGHTH_OF_A_TURN),
        (0.194, -0.094, 7 * EIGHTH_OF_A_TURN),
    ),
    inset=0.02,
    hull=_LEFT_SIDE + _RIGHT_SIDE,
    radius=0.265,
)


def _giraff() -> Chassis:
    radius = 0.23  # of a disc that just covers the wheels
    lasers = []
    for i in range(len(LASERS)):
        angle = i * EIGHTH_OF_A_TURN
        lasers.append((radius * math.cos(angle), radius * math.sin(angle), angle))
    return Chassis(
        wheel_radius=0.075,
        wheel_separation=0.46,
        axle=0.0,
        lasers=tuple(lasers),
        inset=radius,
        hull=(),
        radius=radius,
    )


GIRAFF = _giraff()

CHASSIS = {"mobile_base": PIONEER, "mobile_manipulator": PIONEER, "giraff": GIRAFF}
