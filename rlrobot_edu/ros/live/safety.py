"""What keeps a robot from harm: how much room is ahead, how fast it may be, and a person who says yes."""

import math

import numpy as np

from rlrobot_edu.robots.mobile_base import Chassis
from rlrobot_edu.ros.scan import LaserScan, Mounting, directions, measured

AHEAD = math.radians(60)  # to each side of straight ahead: as far as forward motion can bring the robot near to a thing


def room_ahead(scan: LaserScan, chassis: Chassis, mounting: Mounting) -> float:
    """How far the nearest thing ahead is from the circle around the robot [m]; infinity if there is none.

    NaN if that is not known: the scanner does not look ahead, or none of its rays met anything, as if it were covered.
    Raises ValueError for a scan that cannot be.
    """
    angle_min, increment, ranges = measured(scan)
    angles = directions(mounting, angle_min, increment, len(ranges))
    met = np.isfinite(ranges)
    if not met.any() or not (np.cos(angles) > math.cos(AHEAD)).any():
        return math.nan
    x = chassis.axle + mounting.x + ranges[met] * np.cos(angles[met])
    y = mounting.y + ranges[met] * np.sin(angles[met])
    is_ahead = np.abs(np.arctan2(y, x)) <= AHEAD
    return float((np.hypot(x, y)[is_ahead] - chassis.radius).min(initial=math.inf))


def within(v: float, omega: float, max_speed: float, max_turn: float) -> tuple[float, float]:
    """A motion on the same curve that is nowhere above the limits [m/s], [rad/s].

    Raises ValueError for a motion that is no number.
    """
    if not (math.isfinite(v) and math.isfinite(omega)):
        raise ValueError(f"a robot cannot be told to drive at {v} m/s and to turn at {omega} rad/s")
    excess = max(abs(v) / max_speed, abs(omega) / max_turn, 1.0)
    return v / excess, omega / excess


def confirm(question: str) -> None:
    """Ask the person at the keyboard. Raises PermissionError if the answer is not yes, or if nobody can be asked."""
    try:
        answer = input(f"{question} Type yes: ")
    except (EOFError, OSError, NotImplementedError):  # the last is Jupyter's, where a notebook runs by itself
        raise PermissionError(
            "nobody can be asked whether the robot may move: if that is safe, say rl.RobotLink(…, confirmed=True)"
        ) from None
    if answer.strip().lower() not in ("yes", "y"):
        raise PermissionError(f"the robot was not moved, since the answer was {answer!r:.50}")
