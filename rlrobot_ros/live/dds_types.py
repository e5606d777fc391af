"""ROS 2's messages as types of Cyclone DDS: the fields of ROS's own definitions, in their order.

They are written as ROS 2 writes them, so that the bytes are the same (CDR).
"""

from typing import Any

from cyclonedds.idl import IdlStruct, make_idl_struct, types
from cyclonedds.idl.types import float32, float64, int32, uint32

_idl: Any = types  # whose brackets mypy does not understand
_FLOATS, _COVARIANCE = _idl.sequence[float32], _idl.array[float64, 36]

TYPES: dict[str, type[IdlStruct]] = {}  # by kind, as in "nav_msgs/Odometry"


def _define(kind: str, **fields: Any) -> type[IdlStruct]:
    """Add the type of a kind of message; ROS 2 calls "nav_msgs/Odometry" nav_msgs::msg::dds_::Odometry_ in DDS."""
    package, name = kind.split("/")
    TYPES[kind] = make_idl_struct(name, f"{package}::msg::dds_::{name}_", fields)
    return TYPES[kind]


Time = _define("builtin_interfaces/Time", sec=int32, nanosec=uint32)
Header = _define("std_msgs/Header", stamp=Time, frame_id=str)
Vector3 = _define("geometry_msgs/Vector3", x=float64, y=float64, z=float64)
Point = _define("geometry_msgs/Point", x=float64, y=float64, z=float64)
Quaternion = _define(
    "geometry_msgs/Quaternion", x=float64, y=float64, z=float64, w=float64
)
Pose = _define("geometry_msgs/Pose", position=Point, orientation=Quaternion)
Twist = _define("geometry_msgs/Twist", linear=Vector3, angular=Vector3)
_define("geometry_msgs/TwistStamped", header=Header, twist=Twist)
PoseWithCovariance = _define(
    "geometry_msgs/PoseWithCovariance", pose=Pose, covariance=_COVARIANCE
)
TwistWithCovariance = _define(
    "geometry_msgs/TwistWithCovariance", twist=Twist, covariance=_COVARIANCE
)
_define(
    "nav_msgs/Odometry",
    header=Header,
    child_frame_id=str,
    pose=PoseWithCovariance,
    twist=TwistWithCovariance,
)
_numbers = (
    "angle_min",
    "angle_max",
    "angle_increment",
    "time_increment",
    "scan_time",
    "range_min",
    "range_max",
)
_define(
    "sensor_msgs/LaserScan",
    header=Header,
    **dict.fromkeys(_numbers, float32),
    ranges=_FLOATS,
    intensities=_FLOATS,
)
