"""What turning wheels make of a robot: its speed and its turning, and back."""

from collections.abc import Mapping

from rlrobot_edu.robots.giraff import GIRAFF
from rlrobot_edu.robots.mobile_base import PIONEER, Chassis
from rlrobot_edu.task.robot_cards import WHEELS

CHASSIS = {"mobile_base": PIONEER, "mobile_manipulator": PIONEER, "giraff": GIRAFF}


def twist(wheels: Mapping[str, float], chassis: Chassis) -> tuple[float, float]:
    """Speed ahead v [m/s] and turning to the left ω [rad/s] of wheels that turn at these speeds [rad/s]."""
    left, right = (wheels[wheel] for wheel in WHEELS)
    return chassis.wheel_radius * (left + right) / 2, chassis.wheel_radius * (right - left) / chassis.wheel_separation


def wheel_speeds(v: float, omega: float, chassis: Chassis) -> dict[str, float]:
    """Speeds of the wheels [rad/s] with which the robot drives at v [m/s] and turns at ω [rad/s]."""
    aside = omega * chassis.wheel_separation / 2
    return dict(zip(WHEELS, ((v - aside) / chassis.wheel_radius, (v + aside) / chassis.wheel_radius), strict=True))
