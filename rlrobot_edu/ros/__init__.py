"""Real robots that speak ROS: what they measured and were told, in the words of a task.

scan.py      any laser scan as the readings of the robot's eight lasers
odometry.py  a pose from odometry as x, y and theta
motions.py   which action of a task a velocity command is
drive.py     what was received in a drive, step by step as transitions
report.py    what of a drive could not be used, and why
bag.py       drives in bags of ROS 1 and ROS 2: `recording_from_bag`; the only file that needs the extra "ros"

Lengths are in metres, angles in radians, to the left from straight ahead. A robot's ``base_link`` is, as usual in ROS,
the point midway between its wheels.
"""
