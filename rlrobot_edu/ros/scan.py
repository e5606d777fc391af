"""Any laser scan as the readings of the robot's eight lasers: how far each would see from its place on the body."""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.robots.mobile_base import Chassis
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS

EPSILON = 1e-6  # what rounding makes of angles [rad] and lengths [m] that were single precision
MOST_RAYS = 100_000


class LaserScan(Protocol):
    """ROS's sensor_msgs/LaserScan, as far as it counts here."""

    angle_min: float
    angle_increment: float
    range_min: float
    range_max: float
    ranges: Sequence[float] | NDArray[np.float32]


class Mounting(NamedTuple):
    """Where the scanner is on the robot, in the frame ``base_link``.

    x, y: ahead of the point midway between the wheels and to its left [m]
    yaw: direction of the scanner's own angle 0, to the left from straight ahead [rad]
    upside_down: whether it hangs, so that its angles count to the right
    """

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    upside_down: bool = False

    @classmethod
    def of(cls, given: Any) -> Self:
        """The mounting that these four values say. Raises ValueError if they are none."""
        try:
            x, y, yaw, upside_down = given
            if np.isfinite([x, y, yaw]).all() and upside_down in (False, True):
                return cls(float(x), float(y), float(yaw), bool(upside_down))
        except (TypeError, ValueError):
            pass
        raise ValueError(
            f"mounting must be (x [m], y [m], yaw [rad], upside_down), as in (0.1, 0, 0, False), got {given!r:.200}"
        )


class _Crossing(NamedTuple):
    """How a laser's beam crosses the rays of a scanner that stands elsewhere. Arrays have one number a ray crossed.

    rays: their numbers; each stands for the directions nearer to it than to its neighbours
    enter, leave: between which distances from the laser the beam is in these directions [m]
    along, aside: place of the laser seen from the scanner, in the beam's direction and across it [m]
    """

    rays: NDArray[np.int64]
    enter: NDArray[np.float64]
    leave: NDArray[np.float64]
    along: float
    aside: float


def laser_readings(scan: LaserScan, chassis: Chassis, mounting: Mounting) -> dict[str, float]:
    """The readings [m] of those of the robot's lasers that the scanner can stand for.

    A laser is missing if a part of its beam lies where the scanner does not look: that is not known, while
    `LASER_RANGE` says that nothing is there. A reading is how far the beam gets from the laser's place on the body,
    0 to `LASER_RANGE`, before it leaves the free space that the scan shows.

    Infinity, NaN, 0 and what is above `range_max` mean that a ray met nothing: drivers say it in all these ways, and in
    JSON they look alike. Minus infinity means that something was too near to be measured.

    Raises ValueError for a scan that cannot be: without rays, or whose angles are no numbers.
    """
    angle_min, increment, ranges = measured(scan)
    crossings = _crossings(chassis, mounting, angle_min, increment, len(ranges))
    return {laser: _reach(crossing, ranges[crossing.rays]) for laser, crossing in crossings.items()}


def looking_out(chassis: Chassis, ahead: float) -> Chassis:
    """The same robot with lasers for a scanner that stands away from its middle, and so sees little from elsewhere.

    They are where its rays in their eight directions leave the circle around the robot.

    ahead: how far ahead of the middle of the body the scanner stands [m], less than the circle's radius

    Raises ValueError if it stands outside.
    """
    if not abs(ahead) < chassis.radius:
        raise ValueError(f"a scanner {ahead} m ahead is outside the robot's circle of {chassis.radius:g} m")
    lasers = []
    for _, _, angle in chassis.lasers:
        way = math.sqrt(chassis.radius**2 - (ahead * math.sin(angle)) ** 2) - ahead * math.cos(angle)
        lasers.append((ahead + way * math.cos(angle), way * math.sin(angle), angle))
    return chassis._replace(lasers=tuple(lasers))


def measured(scan: LaserScan) -> tuple[float, float, NDArray[np.float64]]:
    """The first ray's angle and the step to the next [rad], and how far each ray got [m], infinity if it met nothing.

    Raises ValueError for a scan that cannot be: without rays, or whose angles are no numbers.
    """
    try:
        ranges = np.asarray(scan.ranges, dtype=float)
        angle_min, increment, range_max = float(scan.angle_min), float(scan.angle_increment), float(scan.range_max)
    except (AttributeError, TypeError, OverflowError) as error:
        raise ValueError(f"this is no message of type LaserScan: {scan!r:.200}") from error
    if not (
        ranges.ndim == 1 and 0 < len(ranges) <= MOST_RAYS and np.isfinite([angle_min, increment]).all() and increment
    ):
        raise ValueError(f"a laser scan of {ranges.shape} rays from {angle_min} rad in steps of {increment} cannot be")
    nothing = np.isnan(ranges) | (ranges == 0) | (ranges > range_max)
    return angle_min, increment, np.where(nothing, math.inf, np.maximum(ranges, 0.0))


def directions(mounting: Mounting, angle_min: float, increment: float, n: int) -> NDArray[np.float64]:
    """Where the scanner's rays look, to the left from straight ahead of the robot [rad]; array (n,)."""
    sense = -1 if mounting.upside_down else 1
    return mounting.yaw + sense * (angle_min + increment * np.arange(n, dtype=np.float64))


def _reach(crossing: _Crossing, ranges: NDArray[np.float64]) -> float:
    """How far the beam gets: until it is as far from the scanner as the ray in whose direction it is then."""
    _, enter, leave, along, aside = crossing
    is_behind = np.hypot(along + enter, aside) >= ranges  # it comes from nearer walls into these directions
    there = np.where(is_behind, enter, np.sqrt(np.maximum(ranges**2 - aside**2, 0.0)) - along)
    return float(min(max(there[there <= leave].min(initial=LASER_RANGE), 0.0), LASER_RANGE))


@lru_cache(maxsize=64)  # a scanner looks the same way in every scan
def _crossings(
    chassis: Chassis, mounting: Mounting, angle_min: float, increment: float, n: int
) -> dict[str, _Crossing]:
    """How the beams of the lasers cross the scanner's rays, without the beams that are not all in its view."""
    rays = directions(mounting, angle_min, increment, n)
    crossings = {}
    for laser, (x, y, angle) in zip(LASERS, chassis.lasers, strict=True):
        place = (x - chassis.axle - mounting.x, y - mounting.y)
        crossing = _crossing(place, angle, rays, abs(increment) / 2)
        if crossing is not None:
            crossings[laser] = crossing
    return crossings


def _crossing(place: tuple[float, float], angle: float, rays: NDArray[np.float64], half: float) -> _Crossing | None:
    """How a beam from `place` in direction `angle` crosses `rays`, `half` as wide to each side; None if unseen."""
    x, y = place
    ahead, left = math.cos(angle), math.sin(angle)
    along, aside = x * ahead + y * left, y * ahead - x * left
    if abs(aside) < EPSILON:  # it comes straight from the scanner
        off = np.abs(_turned(rays - angle, 0.0))
        i = int(np.argmin(off))
        return _Crossing(np.array([i]), np.zeros(1), np.full(1, LASER_RANGE), along, 0.0) if off[i] <= half else None
    first = math.atan2(y, x)
    turn = math.remainder(math.atan2(y + LASER_RANGE * left, x + LASER_RANGE * ahead) - first, 2 * math.pi)
    sense, turn = math.copysign(1.0, turn), abs(turn)  # from now on angles count from its start towards its end
    off = _turned(sense * (rays - first), turn / 2)
    crossed = np.flatnonzero((off + half >= 0) & (off - half <= turn))
    crossed = crossed[np.argsort(off[crossed], kind="stable")]
    edges = np.concatenate([[-half], off[crossed], [turn + half]])
    if not len(crossed) or (np.diff(edges) > 2 * half + EPSILON).any():
        return None
    enter, leave = (
        _distance(place, (ahead, left), first + sense * np.clip(off[crossed] + side, 0.0, turn))
        for side in (-half, half)
    )
    return _Crossing(crossed, enter, leave + EPSILON, along, aside)


def _distance(
    place: tuple[float, float], way: tuple[float, float], bearing: NDArray[np.float64]
) -> NDArray[np.float64]:
    """How far from `place` a beam of direction `way` is seen at `bearing` from the scanner [m]."""
    cos, sin = np.cos(bearing), np.sin(bearing)
    distance: NDArray[np.float64] = (place[1] * cos - place[0] * sin) / (way[0] * sin - way[1] * cos)
    return distance


def _turned(angles: NDArray[np.float64], middle: float) -> NDArray[np.float64]:
    """The same directions as angles at most π away from `middle`."""
    turned: NDArray[np.float64] = (angles - middle + math.pi) % (2 * math.pi) - math.pi + middle
    return turned
