"""The messages of ROS, and the numbers in them.

A message that was received is any object with ROS's fields: from a bag, or over rosbridge from ROS 1 or ROS 2. A
message to be sent is a dictionary of these fields, for rosbridge; unknown fields are left out.
"""

import math
from collections.abc import Sequence
from typing import Any

from rlrobot_ros.odometry import heading

ODOMETRY = "nav_msgs/Odometry"
LASER_SCAN = "sensor_msgs/LaserScan"
TWIST = "geometry_msgs/Twist"
TWIST_STAMPED = "geometry_msgs/TwistStamped"
BASE_FRAME = "base_link"

Message = dict[str, Any]


def stamp_of(message: Any) -> float:
    """The time of the message's content, by its sender's clock [s]; 0 if the sender gives none.

    Raises ValueError for an impossible time.
    """
    try:
        stamp = message.header.stamp
        if hasattr(stamp, "sec"):
            time = float(stamp.sec + 1e-9 * stamp.nanosec)
        else:
            time = float(stamp.secs + 1e-9 * stamp.nsecs)
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
        place = odometry.pose.pose.position
        q = odometry.pose.pose.orientation
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
    """The message that ``base_link`` was at x, y [m] with heading theta [rad] at the time `stamp` [s]."""
    position = {"x": x, "y": y, "z": 0.0}
    z = math.sin(theta / 2)
    w = math.cos(theta / 2)
    orientation = {"x": 0.0, "y": 0.0, "z": z, "w": w}
    pose = {"position": position, "orientation": orientation}
    return {
        "header": _header(stamp, "odom"),
        "child_frame_id": BASE_FRAME,
        "pose": {"pose": pose},
    }


def make_laser_scan(stamp: float, ranges: Sequence[float], range_max: float) -> Message:
    """The message of a scanner on ``base_link`` that looks all round, the first ray straight ahead; ranges in m."""
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
    linear = {"x": v, "y": 0.0, "z": 0.0}
    angular = {"x": 0.0, "y": 0.0, "z": omega}
    return {"linear": linear, "angular": angular}


def make_twist_stamped(v: float, omega: float) -> Message:
    """The same as a TwistStamped.

    It has no time: rosbridge then puts in the robot's own. That is better, because many robots ignore a command as
    outdated if its sender's clock is late.
    """
    return {"header": {"frame_id": BASE_FRAME}, "twist": make_twist(v, omega)}


def _header(stamp: float, frame: str) -> Message:
    seconds, nanoseconds = divmod(round(stamp * 1e9), 10**9)
    return {"stamp": {"sec": seconds, "nanosec": nanoseconds}, "frame_id": frame}
