"""A robot that is on now: heard, driven, and kept from harm.

robot_link.py          `RobotLink`: what an environment needs of a robot
session.py             an open connection, with all of the following
link_report.py         what was received and sent, in a table

rosbridge.py           the connection to ROS 1 or ROS 2, by JSON over a websocket
sensors.py             odometry and scan as readings
latest_message.py      the newest message of a topic, and its age though the clocks do not agree

safety.py              room ahead, limits, a person's yes
controller.py          a motion for a while, and a stop as soon as too little is known
velocity_publisher.py  commands, of which the last is stop
guardian.py            a second process that stops the robot when this one dies

To rehearse without a robot:

served_robot.py        `ServedRobot`: one of ours behind rosbridge
simulated_body.py      its body, without ROS
rosbridge_server.py    what passes its messages on
"""
