# What `import rlrobot_ros` offers. Editors and mypy read it, and so does the lazy import.
from .bag import recording_from_bag as recording_from_bag
from .live.robot_link import RobotLink as RobotLink
from .live.served_robot import ServedRobot as ServedRobot
