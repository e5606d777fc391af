"""What keeps a robot from harm: the room ahead, limits of its speed, and a person who says yes."""

import math

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_ros.scan import (
    EPSILON,
    GAP,
    Floats,
    LaserScan,
    Mounting,
    Rays,
    directions,
    measured,
    turned,
)

# To each side of straight ahead: as far as forward motion can bring the robot near to a thing [rad]
AHEAD = math.radians(60)
# Share of the rays ahead that must have measured something. Now and then a ray is lost by chance. If most are lost,
# the reason is dirt, the sun or a fault, and what the others miss is not chance either.
MOST_KNOWN = 0.5
MAX_AGE = 0.5  # of odometry and scan while the robot moves [s]
# of many robots: how late a command acts [s], and how they brake [m/s²]
LAG = 0.3
BRAKES = 0.5


def room_ahead(scan: LaserScan, chassis: Chassis, mounting: Mounting) -> float:
    """How far the nearest thing ahead is from the circle around the robot [m]; infinity if there is none.

    NaN if that is not known: see `look_ahead`. Raises ValueError for a scan that cannot be.
    """
    return look_ahead(measured(scan, mounting.far), chassis, mounting)[0]


def look_ahead(rays: Rays, chassis: Chassis, mounting: Mounting) -> tuple[float, str]:
    """How far the nearest thing ahead is from the circle around the robot [m], and if that is NaN, why.

    What is unknown is not free. Something too near to be measured is at the scanner itself.
    """
    angles = directions(mounting, rays.angle_min, rays.increment, len(rays.ranges))
    off = np.abs(turned(angles, 0.0))
    looks_ahead = off <= AHEAD + EPSILON
    why_unknown = _why_unknown(rays, off, looks_ahead)
    if why_unknown:
        return math.nan, why_unknown
    met = np.isfinite(rays.ranges)
    x = chassis.axle + mounting.x + rays.ranges[met] * np.cos(angles[met])
    y = mounting.y + rays.ranges[met] * np.sin(angles[met])
    is_too_near = looks_ahead & (rays.ranges == 0)
    is_ahead = (np.abs(np.arctan2(y, x)) <= AHEAD + EPSILON) | is_too_near[met]
    rooms = np.hypot(x, y)[is_ahead] - chassis.radius
    return float(rooms.min(initial=math.inf)), ""


def _why_unknown(rays: Rays, off: Floats, looks_ahead: NDArray[np.bool_]) -> str:
    """Why the rays do not show what is ahead; empty if they do.

    off: angle of each ray from straight ahead [rad]; looks_ahead: whether that is at most `AHEAD`
    """
    nearest = off.min()
    if nearest >= min(abs(rays.increment) / 2 + GAP, AHEAD):
        return f"no ray of the scan looks straight ahead, the nearest is {math.degrees(nearest):.0f}° off"
    n = len(rays.ranges)
    if not np.isfinite(rays.ranges).any():
        return f"none of the {n} rays of the scan met anything, as if it were covered"
    lost = ~rays.known[looks_ahead]
    hides = np.isnan(rays.ranges[looks_ahead])
    if hides.any() or lost.mean() > 1 - MOST_KNOWN:
        return (
            f"{lost.sum()} of the {len(lost)} rays ahead say nothing (0, NaN, or above range_max), {hides.sum()} of "
            f"them in gaps of more than {math.degrees(GAP):.1f}°"
        )
    return ""


def within(
    v: float, omega: float, max_speed: float, max_turn: float
) -> tuple[float, float]:
    """A motion on the same curve that is nowhere above the limits [m/s], [rad/s].

    Raises ValueError for a motion that is not finite.
    """
    if not (math.isfinite(v) and math.isfinite(omega)):
        raise ValueError(
            f"a robot cannot be told to drive at {v} m/s and to turn at {omega} rad/s"
        )
    excess = max(abs(v) / max_speed, abs(omega) / max_turn, 1.0)
    return v / excess, omega / excess


def stopping_distance(speed: float) -> float:
    """How far a robot gets at this speed [m/s] before it stands [m]: until it knows and brakes, and then."""
    return speed * (MAX_AGE + LAG) + speed**2 / (2 * BRAKES)


def confirm(question: str) -> None:
    """Ask the person at the keyboard. Raises PermissionError if the answer is not yes, or if nobody can be asked."""
    try:
        answer = input(f"{question} Type yes: ")
    # NotImplementedError is Jupyter's, where a notebook runs by itself.
    except (EOFError, OSError, NotImplementedError):
        raise PermissionError(
            "nobody can be asked whether the robot may move: if that is safe, say RobotLink(…, confirmed=True)"
        ) from None
    if answer.strip().lower() not in ("yes", "y"):
        raise PermissionError(
            f"the robot was not moved, since the answer was {answer!r:.50}"
        )
