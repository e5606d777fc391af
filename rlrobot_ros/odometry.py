"""A pose from odometry as the readings x, y and theta of the toolkit's robots."""

import math

from rlrobot_edu.robots.chassis import Chassis

EARTH = 4e7  # its circumference [m]: no odometry is further from where it began


def heading(x: float, y: float, z: float, w: float) -> float:
    """The angle in (−π, π] by which a quaternion turns about the vertical [rad]; it need not be of length 1.

    Raises ValueError for a quaternion of length 0, or if a part of it is not finite.
    """
    length = math.hypot(x, y, z, w)
    if not 0 < length < math.inf:
        raise ValueError(f"the quaternion ({x}, {y}, {z}, {w}) is no orientation")
    x /= length
    y /= length
    z /= length
    w /= length
    theta = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return math.pi if theta == -math.pi else theta


def pose_readings(
    x: float, y: float, theta: float, chassis: Chassis
) -> dict[str, float]:
    """The readings of a robot whose ``base_link`` is at x, y [m] and looks in direction theta [rad].

    The readings x and y are those of the middle of the robot's body; its axle may be elsewhere.
    Raises ValueError for a pose that is not finite, or further away than any place on Earth.
    """
    if not (math.hypot(x, y) <= EARTH and math.isfinite(theta)):  # true for NaN, too
        raise ValueError(f"the pose ({x}, {y}, {theta}) is no place")
    return {
        "x": x - chassis.axle * math.cos(theta),
        "y": y - chassis.axle * math.sin(theta),
        "theta": theta,
    }
