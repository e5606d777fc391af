"""The chassis of each robot on wheels."""

from rlrobot_edu.robots.giraff import GIRAFF
from rlrobot_edu.robots.mobile_base import PIONEER

CHASSIS = {"mobile_base": PIONEER, "mobile_manipulator": PIONEER, "giraff": GIRAFF}
