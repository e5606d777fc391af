"""A real robot that is switched on: its messages, its motion, and its safety.

robot_link.py          `RobotLink`: the robot of an environment
session.py             an open connection, with all of the following
link_report.py         a table of what was received and sent

rosbridge.py           the connection to ROS 1 or ROS 2, by JSON over a websocket
sensors.py             odometry and scan as readings
latest_message.py      the newest message of a topic, and its age, even if the clocks disagree

safety.py              room ahead, limits, a person's yes
controller.py          a motion for some time, and a stop as soon as too little is known
velocity_publisher.py  commands, of which the last is stop
guardian.py            a second process that stops the robot when this one dies

To rehearse without a robot:

served_robot.py        `ServedRobot`: one of ours behind rosbridge
simulated_body.py      its body, without ROS
rosbridge_server.py    a small rosbridge, which passes its messages on
"""
