"""Real robots that use ROS: their measurements and commands, in the words of a task.

    from rlrobot_ros import RobotLink, ServedRobot, recording_from_bag

messages.py      the messages of ROS, and the numbers in them
scan.py          any laser scan as the readings of the robot's eight lasers
odometry.py      a pose from odometry as x, y and theta
motions.py       the action of a task that a velocity command means
drive.py         the messages of a drive, step by step as transitions
drive_report.py  how much of a drive could not be used, and why
bag.py           drives in bags of ROS 1 and ROS 2: `recording_from_bag`
live/            a real robot that is switched on: `RobotLink`; and a simulated one: `ServedRobot`
commands.py      the command ``rlrobot-edu serve-robot``

Bags and rosbridge need the extra "ros". Lengths are in metres, angles in radians, to the left from straight ahead. A
robot's ``base_link`` is, as usual in ROS, the point midway between its wheels.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
