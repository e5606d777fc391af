"""Any laser scan as the readings of the robot's eight lasers: how far each would see from its place on the body."""

import math
from functools import lru_cache
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS

EPSILON = 1e-6  # what rounding makes of angles [rad] and lengths [m] that were single precision
MOST_RAYS = 100_000
# Neighbours stand in for rays that measured nothing, in gaps no wider than this [rad]. A tenth of the robot's width is
# as wide as that at twice its radius from its middle: nothing wider hides there once the robot is half its width away.
GAP = 0.1

# A message with the fields of ROS's sensor_msgs/LaserScan, from any source
LaserScan = Any
Floats = NDArray[np.float64]


class Mounting(NamedTuple):
    """Where the scanner is on the robot, in the frame ``base_link``.

    x, y: ahead of the point midway between the wheels and to its left [m]
    yaw: direction of the scanner's own angle 0, to the left from straight ahead [rad]
    upside_down: whether it hangs, so that its angles count to the right
    far: its value where nothing is within its range: infinity, as ROS wants it (REP 117), 0, NaN, or any number above
        its range_max
    """

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    upside_down: bool = False
    far: float = math.inf

    @classmethod
    def of(cls, given: Any) -> Self:
        """The mounting of these four or five values. Raises ValueError if they do not make one."""
        try:
            x, y, yaw, upside_down, *rest = given
            far = float(rest[0]) if rest else math.inf
            mounting = cls(float(x), float(y), float(yaw), bool(upside_down), far)
            is_known = np.isfinite(mounting[:3]).all() and upside_down in (False, True)
            is_possible = is_known and not far < 0 and len(rest) <= 1
        except (TypeError, ValueError):
            is_possible = False
        if not is_possible:
            raise ValueError(
                "mounting must be (x [m], y [m], yaw [rad], upside_down), as in (0.1, 0, 0, False), and may end with "
                f"what the scanner says for far, got {given!r:.200}"
            )
        return mounting


class Rays(NamedTuple):
    """The rays of a scan. Arrays have one number for each ray.

    angle_min, increment: angle of the first ray, and the step to the next [rad]
    ranges: how far each ray got [m]: 0 if something was too near to be measured, infinity if nothing is within range.
        A ray that measured nothing has the range of its nearer neighbour, or NaN if the gap is wider than `GAP`
    farthest: the same, but such a ray has the range of its farther neighbour
    known: whether the ray itself measured something
    """

    angle_min: float
    increment: float
    ranges: Floats
    farthest: Floats
    known: NDArray[np.bool_]


class _Crossing(NamedTuple):
    """How a laser's beam crosses the rays of a scanner in another place. Arrays have one number for each ray crossed.

    rays: their numbers; each stands for the directions nearer to it than to its neighbours
    enter, leave: between which distances from the laser the beam is in these directions [m]
    along, aside: place of the laser seen from the scanner, in the beam's direction and across it [m]
    """

    rays: NDArray[np.int64]
    enter: Floats
    leave: Floats
    along: float
    aside: float


def laser_readings(
    scan: LaserScan, chassis: Chassis, mounting: Mounting
) -> dict[str, float]:
    """The readings [m] of those of the robot's lasers that the scanner can stand for.

    A reading is how far the beam gets from the laser's place on the body, 0 to `LASER_RANGE`, before it leaves the free
    space that the scan shows. A laser is missing if a part of its beam lies where the scanner does not look, or where
    its rays measured nothing (see `measured`): that is not known, while `LASER_RANGE` says that nothing is there.

    Raises ValueError for a scan that cannot be: see `measured`.
    """
    rays = measured(scan, mounting.far)
    readings = beams_end(rays, rays.ranges, chassis, mounting)
    return {laser: x for laser, x in readings.items() if not math.isnan(x)}


def beams_end(
    rays: Rays, ranges: Floats, chassis: Chassis, mounting: Mounting
) -> dict[str, float]:
    """How far each laser in the scanner's view sees where its rays got as far as `ranges` [m]; NaN if not known."""
    crossings = _crossings(
        chassis, mounting, rays.angle_min, rays.increment, len(ranges)
    )
    readings = {}
    for laser, crossing in crossings.items():
        readings[laser] = _reach(crossing, ranges[crossing.rays])
    return readings


def looking_out(chassis: Chassis, ahead: float) -> Chassis:
    """The same robot with lasers for a scanner that stands away from its middle, and so sees little from elsewhere.

    They are where its rays in their eight directions leave the circle around the robot.

    ahead: how far ahead of the middle of the body the scanner stands [m], less than the circle's radius

    Raises ValueError if it stands outside.
    """
    if not abs(ahead) < chassis.radius:
        raise ValueError(
            f"a scanner {ahead} m ahead is outside the robot's circle of {chassis.radius:g} m"
        )
    lasers = []
    for _, _, angle in chassis.lasers:
        aside = ahead * math.sin(angle)
        way = math.sqrt(chassis.radius**2 - aside**2) - ahead * math.cos(angle)
        x = ahead + way * math.cos(angle)
        y = way * math.sin(angle)
        lasers.append((x, y, angle))
    return chassis._replace(lasers=tuple(lasers))


def measured(scan: LaserScan, far: float = math.inf) -> Rays:
    """The rays of a scan.

    Infinity means that nothing is within range. A value below `range_min`, or minus infinity, means that something is
    too near. NaN (over rosbridge also null), 0 and values above `range_max` mean nothing, because drivers write them
    for things that are too near, too far or too dark. If `far` is one of them, it means that nothing is within range;
    but in a gap of at most `GAP` the nearer neighbour counts even then.

    Raises ValueError for an impossible scan: without rays, with more rays than its angles allow, or without numbers.
    """
    try:
        ranges = np.asarray(scan.ranges, dtype=float)
        angle_min = float(scan.angle_min)
        increment = float(scan.angle_increment)
        nearest = float(scan.range_min)
        most = float(scan.range_max)
        # Many drivers leave it at 0.
        angle_max = float(getattr(scan, "angle_max", None) or math.nan)
    except (AttributeError, TypeError, OverflowError) as error:
        raise ValueError(
            f"this is no message of type LaserScan: {scan!r:.200}"
        ) from error
    has_rays = ranges.ndim == 1 and 0 < len(ranges) <= MOST_RAYS
    has_angles = math.isfinite(angle_min + increment) and increment != 0
    is_possible = has_rays and has_angles and nearest < most
    if is_possible:
        # false for NaN
        has_too_many = 0 < (angle_max - angle_min) / increment < len(ranges) - 2.5
        is_possible = not has_too_many
    if not is_possible:
        raise ValueError(
            f"an impossible laser scan of {ranges.shape} rays from {angle_min} to {angle_max} rad in steps of "
            f"{increment}, which measures from {nearest} to {most} m"
        )
    known = np.where(ranges < nearest, 0.0, ranges)
    is_beyond = ranges > most
    known[(ranges == 0) | (is_beyond & np.isfinite(ranges))] = math.nan
    near, farthest = _between(known, abs(increment))
    is_far = (ranges == far) | (is_beyond & (most < far < math.inf))
    if math.isnan(far):
        is_far = np.isnan(ranges)
    near[np.isnan(near) & is_far] = math.inf
    farthest[np.isnan(farthest) & is_far] = math.inf
    return Rays(angle_min, increment, near, farthest, is_far | ~np.isnan(known))


def _between(ranges: Floats, increment: float) -> tuple[Floats, Floats]:
    """How near and how far each ray may have got [m], where NaN is between neighbours that are not NaN."""
    known = np.flatnonzero(~np.isnan(ranges))
    rays = np.arange(len(ranges))
    turn = 2 * math.pi / increment
    all_turns = [known - turn, known, known + turn]
    places = np.concatenate([[-math.inf], *all_turns, [math.inf]])
    values = np.concatenate([[math.nan], np.tile(ranges[known], 3), [math.nan]])
    order = np.argsort(places, kind="stable")  # a scan may be of more than a turn
    left = order[np.searchsorted(places[order], rays, "right") - 1]
    right = order[np.searchsorted(places[order], rays, "left")]
    width = (places[right] - places[left]) * increment
    is_narrow = width <= GAP + increment + EPSILON
    sides = np.where(is_narrow, [values[left], values[right]], math.nan)
    is_lost = np.isnan(ranges)
    near = np.where(is_lost, sides.min(axis=0), ranges)
    far = np.where(is_lost, sides.max(axis=0), ranges)
    return near, far


def directions(
    mounting: Mounting, angle_min: float, increment: float, n: int
) -> Floats:
    """Where the scanner's rays look, to the left from straight ahead of the robot [rad]; array (n,)."""
    angles = angle_min + increment * np.arange(n, dtype=np.float64)
    sense = -1 if mounting.upside_down else 1
    return mounting.yaw + sense * angles


def _reach(crossing: _Crossing, ranges: Floats) -> float:
    """How far the beam gets: until it is as far from the scanner as the ray in whose direction it is then.

    NaN if on its way there it comes into the direction of a ray of which nothing is known.
    """
    _, enter, leave, along, aside = crossing
    # It comes from nearer walls into these directions.
    is_behind = np.hypot(along + enter, aside) >= ranges
    at_range = np.sqrt(np.maximum(ranges**2 - aside**2, 0.0)) - along
    there = np.where(is_behind, enter, at_range)
    first = there[there <= leave].min(initial=LASER_RANGE)
    reach = float(min(max(first, 0.0), LASER_RANGE))
    if np.isnan(ranges[enter < reach]).any():
        return math.nan
    return reach


@lru_cache(maxsize=64)  # a scanner looks the same way in every scan
def _crossings(
    chassis: Chassis, mounting: Mounting, first: float, step: float, n: int
) -> dict[str, _Crossing]:
    """How the beams of the lasers cross the scanner's rays, without the beams that are not all in its view."""
    rays = directions(mounting, first, step, n)
    crossings = {}
    for laser, (x, y, angle) in zip(LASERS, chassis.lasers, strict=True):
        place = (x - chassis.axle - mounting.x, y - mounting.y)
        crossing = _crossing(place, angle, rays, abs(step) / 2)
        if crossing is not None:
            crossings[laser] = crossing
    return crossings


def _crossing(
    place: tuple[float, float], angle: float, rays: Floats, half: float
) -> _Crossing | None:
    """How a beam from `place` in direction `angle` crosses `rays`, `half` as wide to each side; None if unseen."""
    x, y = place
    ahead, left = math.cos(angle), math.sin(angle)
    along, aside = x * ahead + y * left, y * ahead - x * left
    if abs(aside) < EPSILON:  # it comes straight from the scanner
        off = np.abs(turned(rays - angle, 0.0))
        i = int(np.argmin(off))
        # It may be midway between two rays, and then rounding decides.
        if off[i] > half + EPSILON:
            return None
        whole = np.full(1, LASER_RANGE)
        return _Crossing(np.array([i]), np.zeros(1), whole, along, 0.0)
    first = math.atan2(y, x)
    last = math.atan2(y + LASER_RANGE * left, x + LASER_RANGE * ahead)
    turn = math.remainder(last - first, 2 * math.pi)
    # from now on angles count from its start towards its end
    sense = math.copysign(1.0, turn)
    turn = abs(turn)
    off = turned(sense * (rays - first), turn / 2)
    crossed = np.flatnonzero((off + half >= 0) & (off - half <= turn))
    crossed = crossed[np.argsort(off[crossed], kind="stable")]
    edges = np.concatenate([[-half], off[crossed], [turn + half]])
    if not len(crossed) or (np.diff(edges) > 2 * half + EPSILON).any():
        return None
    way = (ahead, left)
    begin = first + sense * np.clip(off[crossed] - half, 0.0, turn)
    end = first + sense * np.clip(off[crossed] + half, 0.0, turn)
    enter = _distance(place, way, begin)
    leave = _distance(place, way, end)
    return _Crossing(crossed, enter, leave + EPSILON, along, aside)


def _distance(
    place: tuple[float, float], way: tuple[float, float], bearing: Floats
) -> Floats:
    """How far from `place` a beam of direction `way` is seen at `bearing` from the scanner [m]."""
    cos = np.cos(bearing)
    sin = np.sin(bearing)
    distance: Floats = (place[1] * cos - place[0] * sin) / (way[0] * sin - way[1] * cos)
    return distance


def turned(angles: Floats, middle: float) -> Floats:
    """The same directions as angles at most π away from `middle`."""
    turned: Floats = (angles - middle + math.pi) % (2 * math.pi) - math.pi + middle
    return turned
