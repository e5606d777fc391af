"""The messages of ROS, and what they say in numbers.

A message that was received is any object with ROS's fields: from a bag, or over rosbridge from ROS 1 or ROS 2. One that
is sent is a dictionary of these fields, for rosbridge; those of which nothing is known are left out.
"""

import math
from collections.abc import Sequence
from typing import Any

from rlrobot_ros.odometry import heading

ODOMETRY, LASER_SCAN = "nav_msgs/Odometry", "sensor_msgs/LaserScan"
TWIST, TWIST_STAMPED = "geometry_msgs/Twist", "geometry_msgs/TwistStamped"
BASE_FRAME = "base_link"

Message = dict[str, Any]


def stamp_of(message: Any) -> float:
    """When what the message tells was so, by its sender's clock [s]; 0 if the sender does not say.

    Raises ValueError for a time that cannot be.
    """
    try:
        stamp = message.header.stamp
        seconds, nanoseconds = (
            (stamp.sec, stamp.nanosec)
            if hasattr(stamp, "sec")
            else (stamp.secs, stamp.nsecs)
        )
        time = float(seconds + 1e-9 * nanoseconds)
    except (AttributeError, TypeError, OverflowError) as error:
        raise ValueError(
            f"a message without a readable time: {message!r:.200}"
        ) from error
    if not 0 <= time < math.inf:
        raise ValueError(f"a message has the impossible time {time} s")
    return time


def pose_of(odometry: Any) -> tuple[float, float, float]:
    """Where ``base_link`` is: x, y [m], and theta in (−π, π], to the left from the x axis [rad].

    Raises ValueError if the message does not say.
    """
    try:
        place, q = odometry.pose.pose.position, odometry.pose.pose.orientation
        return float(place.x), float(place.y), heading(q.x, q.y, q.z, q.w)
    except (AttributeError, TypeError, OverflowError) as error:
        raise ValueError(
            f"this is no message of type Odometry: {odometry!r:.200}"
        ) from error


def velocity_of(twist: Any) -> tuple[float, float, float]:
    """Speed ahead and to the left [m/s], turning to the left [rad/s] of a Twist or TwistStamped.

    Raises ValueError if the message does not say.
    """
    try:
        twist = getattr(twist, "twist", twist)
        return float(twist.linear.x), float(twist.linear.y), float(twist.angular.z)
    except (AttributeError, TypeError, OverflowError) as error:
        raise ValueError(f"this is no message of type Twist: {twist!r:.200}") from error


def make_odometry(stamp: float, x: float, y: float, theta: float) -> Message:
    """A message that at time `stamp` [s] ``base_link`` is at x, y [m] and looks in direction theta [rad]."""
    position = {"x": x, "y": y, "z": 0.0}
    orientation = {
        "x": 0.0,
        "y": 0.0,
        "z": math.sin(theta / 2),
        "w": math.cos(theta / 2),
    }
    pose = {"position": position, "orientation": orientation}
    return {
        "header": _header(stamp, "odom"),
        "child_frame_id": BASE_FRAME,
        "pose": {"pose": pose},
    }


def make_laser_scan(stamp: float, ranges: Sequence[float], range_max: float) -> Message:
    """A message of what a scanner on ``base_link`` sees all round [m], the first ray straight ahead."""
    increment = 2 * math.pi / len(ranges)
    return {
        "header": _header(stamp, BASE_FRAME),
        "angle_min": 0.0,
        "angle_max": increment * (len(ranges) - 1),
        "angle_increment": increment,
        "range_min": 0.0,
        "range_max": range_max,
        "ranges": list(ranges),
    }


def make_twist(v: float, omega: float) -> Message:
    """A message that tells a robot to drive at v [m/s] and to turn to the left at omega [rad/s]."""
    return {
        "linear": {"x": v, "y": 0.0, "z": 0.0},
        "angular": {"x": 0.0, "y": 0.0, "z": omega},
    }


def make_twist_stamped(v: float, omega: float) -> Message:
    """The same as a TwistStamped.

    It has no time: rosbridge then puts in the robot's own. That is better, since many robots take a command for
    outdated whose sender's clock is late.
    """
    return {"header": {"frame_id": BASE_FRAME}, "twist": make_twist(v, omega)}


def _header(stamp: float, frame: str) -> Message:
    seconds, nanoseconds = divmod(round(stamp * 1e9), 10**9)
    return {"stamp": {"sec": seconds, "nanosec": nanoseconds}, "frame_id": frame}
