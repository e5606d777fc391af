"""A robot that is on now: heard, told what to do, and kept from harm.

What is heard, and when it is too old to be trusted:
latest.py        the newest message of a topic, and its age though the clocks do not agree
senses.py        odometry and scan as readings

What is said:
voice.py         a Twist, and that the last word is stop
safety.py        room ahead, limits, a person's yes
steering.py      a motion for a while, and a stop as soon as too little is known
guardian.py      a second process that stops the robot when this one dies

A robot of the toolkit:
line.py          all this together, while a connection is open
link.py          `RobotLink`: what an environment needs of a robot
link_report.py   what was heard and said, in a table

Ways to a robot, of which each is a `Connection`:
connection.py    what they all can do, and their names
rosbridge.py     JSON over a websocket, to ROS 1 and ROS 2; needs the extra "ros"
dds.py           straight to ROS 2; needs the extra "ros"
dds_types.py     the messages of ROS 2 as DDS knows them

To rehearse without a robot:
served_robot.py     `ServedRobot`: one of ours that speaks ROS
served_body.py      its body, without ROS
rosbridge_router.py what passes its messages on
"""
