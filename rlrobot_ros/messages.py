"""ROS's messages and what they say in numbers.

A message is any object with ROS's fields, from any source: bag, ROS 1, DDS, JSON. To make one, `make(kind, **fields)`
is handed in: each way to a robot has messages of its own. A kind is named by package and type, as in ROS 1:
"nav_msgs/Odometry"; header and time have the fields that they have in ROS 2.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

from rlrobot_ros.odometry import heading

Make = Callable[..., Any]

ODOMETRY, LASER_SCAN = "nav_msgs/Odometry", "sensor_msgs/LaserScan"
TWIST, TWIST_STAMPED = "geometry_msgs/Twist", "geometry_msgs/TwistStamped"
BASE_FRAME = "base_link"


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


def make_odometry(make: Make, stamp: float, x: float, y: float, theta: float) -> Any:
    """A message that ``base_link`` is at x, y [m] and looks in direction theta [rad]."""
    q = make(
        "geometry_msgs/Quaternion",
        x=0.0,
        y=0.0,
        z=math.sin(theta / 2),
        w=math.cos(theta / 2),
    )
    pose = make(
        "geometry_msgs/Pose",
        position=make("geometry_msgs/Point", x=x, y=y, z=0.0),
        orientation=q,
    )
    unknown = [0.0] * 36
    return make(
        ODOMETRY,
        header=_header(make, stamp, "odom"),
        child_frame_id=BASE_FRAME,
        pose=make("geometry_msgs/PoseWithCovariance", pose=pose, covariance=unknown),
        twist=make(
            "geometry_msgs/TwistWithCovariance",
            twist=make_twist(make, 0.0, 0.0),
            covariance=unknown,
        ),
    )


def make_laser_scan(
    make: Make, stamp: float, ranges: Sequence[float], range_max: float
) -> Any:
    """A message of what a scanner on ``base_link`` sees all round [m], the first ray straight ahead."""
    increment = 2 * math.pi / len(ranges)
    return make(
        LASER_SCAN, header=_header(make, stamp, BASE_FRAME), angle_min=0.0, angle_max=increment * (len(ranges) - 1),
        angle_increment=increment, time_increment=0.0, scan_time=0.0, range_min=0.0, range_max=range_max,
        ranges=list(ranges), intensities=[],
    )  # fmt: skip


def make_twist(make: Make, v: float, omega: float) -> Any:
    """A message that tells a robot to drive at v [m/s] and to turn to the left at omega [rad/s]."""
    vector = "geometry_msgs/Vector3"
    return make(
        TWIST,
        linear=make(vector, x=v, y=0.0, z=0.0),
        angular=make(vector, x=0.0, y=0.0, z=omega),
    )


def make_twist_stamped(make: Make, stamp: float, v: float, omega: float) -> Any:
    """The same with the time [s] from which it holds."""
    return make(
        TWIST_STAMPED,
        header=_header(make, stamp, BASE_FRAME),
        twist=make_twist(make, v, omega),
    )


def _header(make: Make, stamp: float, frame: str) -> Any:
    seconds, rest = divmod(round(stamp * 1e9), 10**9)
    time = make("builtin_interfaces/Time", sec=seconds, nanosec=rest)
    return make("std_msgs/Header", stamp=time, frame_id=frame)
