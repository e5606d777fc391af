"""The way to a robot over ROS 1, with a real master and nodes that speak rospy directly on the other side."""

import signal
import sys
from xmlrpc.client import ServerProxy

import psutil
import pytest
import ros1
from ros1 import DRIVER, OURS, until

from rlrobot_edu.ros.live.connection import connect

path, ros = ros1.path, ros1.ros  # fixtures


def test_a_robot_hears_a_twist_and_is_heard(ros):
    robot = ros.robot()
    told = ros.run(
        DRIVER
        + """
from rlrobot_edu.robots.mobile_base import PIONEER
from rlrobot_edu.ros.scan import Mounting, laser_readings

pose, scan = poses[-1], scans[-1]
lasers = laser_readings(scan, PIONEER, Mounting())
tell(
    stamp=messages.stamp_of(pose), pose=messages.pose_of(pose), ranges=scan.ranges, lasers=sorted(lasers.values()),
    velocity=messages.velocity_of(messages.make_twist_stamped(node.make, 3.5, 0.25, -0.5)),
)
"""
    )
    assert told["stamp"] == 7.5
    assert told["pose"] == pytest.approx([0.25, -0.5, 1.5707963])
    assert told["ranges"] == [1.5] * 359 + [float("inf")]
    assert told["lasers"] and all(0 < reading < 1.5 for reading in told["lasers"])
    assert told["velocity"] == [0.25, 0.0, -0.5]
    assert ros.said(robot, "heard")[-1] == "heard 0.25"


def test_a_twist_with_a_time_arrives_with_it(ros):
    ros.robot()
    told = ros.run(
        OURS
        + """
node, poses = RospyNode(), []
node.hear("odom", messages.ODOMETRY, poses.append)
send = node.speak("stamped", messages.TWIST_STAMPED)
until(lambda: poses, lambda: send(messages.make_twist_stamped(node.make, 1234567890.25, 0.5, 0.125)))
tell(stamp=messages.stamp_of(poses[-1]), pose=messages.pose_of(poses[-1]))
"""
    )
    assert told["stamp"] == pytest.approx(1234567890.25, abs=1e-6)
    assert told["pose"][:2] == [0.5, 0.125]


def test_every_message_that_the_library_makes_is_one_of_ros_1(ros):
    listener = ros.theirs(
        """
import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

rospy.init_node("listener")
show = lambda *what: print("heard", *what, flush=True)
place = lambda m: (m.pose.pose.position.x, m.pose.pose.position.y, round(m.pose.pose.orientation.z, 3))
rospy.Subscriber("odom", Odometry, lambda m: show(m.header.stamp.to_nsec(), m.header.frame_id, *place(m)))
rospy.Subscriber("scan", LaserScan, lambda m: show(m.header.stamp.to_nsec(), m.header.frame_id, *m.ranges))
print("ready", flush=True)
rospy.spin()
"""
    )
    ros.said(listener, "ready")
    ours = ros.start(
        OURS
        + """
node = RospyNode()
odom, scan = node.speak("odom", messages.ODOMETRY), node.speak("scan", messages.LASER_SCAN)
while True:
    odom(messages.make_odometry(node.make, 2.5, 1.0, 2.0, 0.5))
    scan(messages.make_laser_scan(node.make, 3.5, [1.0, 2.0, float("inf")], 4.0))
    time.sleep(0.02)
"""
    )
    expected = {"heard 2500000000 odom 1.0 2.0 0.247", "heard 3500000000 base_link 1.0 2.0 inf"}
    until(lambda: set(ros.said(listener, "heard")) == expected or ours.poll(), ours.out.read_text)
    assert ours.poll() is None, ours.out.read_text()


def test_without_a_master_it_is_said_what_to_do(ros):
    ros.master.kill()
    ros.master.wait()
    told = ros.run(
        OURS
        + """
import socket

began = time.monotonic()
silent = socket.create_server(("127.0.0.1", 0))
uri = f"http://127.0.0.1:{silent.getsockname()[1]}"
tell(nobody=refusal(RospyNode), silent=refusal(RospyNode, uri), nonsense=refusal(RospyNode, "robot"), uri=uri,
     seconds=time.monotonic() - began)
"""
    )
    uri = ros.env["ROS_MASTER_URI"]
    assert told["nobody"].startswith(f"ConnectionError: no ROS master answers at {uri} (ConnectionRefusedError")
    assert "start roscore there, or set ROS_MASTER_URI" in told["nobody"]
    assert told["silent"].startswith(f"ConnectionError: no ROS master answers at {told['uri']} (TimeoutError")
    assert told["nonsense"].startswith("ConnectionError: no ROS master answers at robot ")
    assert told["seconds"] < 30


def test_ctrl_c_is_pythons(ros):
    ours = ros.start(
        OURS
        + """
import signal

signal.signal(signal.SIGINT, signal.default_int_handler)  # also where the tests run in the background
node = RospyNode()
node.hear("odom", messages.ODOMETRY, print)
try:
    tell(ready=True)
    time.sleep(60)
except KeyboardInterrupt:
    tell(lost=node.lost)
"""
    )
    ros.said(ours, "{")
    ours.send_signal(signal.SIGINT)
    assert ros.told(ours) == {"lost": None}


def test_what_was_sent_before_the_end_arrives_and_nothing_is_heard_after_it(ros):
    robot = ros.robot()
    told = ros.run(
        DRIVER
        + """
import rosgraph
from rospy.impl.tcpros_base import TCPROSTransport

write = TCPROSTransport.write_data
TCPROSTransport.write_data = lambda *args: (time.sleep(0.05), write(*args))[1]  # a slow network
for v in range(1, 10):
    send(messages.make_twist(node.make, float(v), 0.0))
node.close()
n = len(poses)

other, heard = RospyNode(), []  # rospy's one node, again
other.hear("odom", messages.ODOMETRY, heard.append)
second = other.speak("cmd_vel", messages.TWIST)
until(lambda: heard, lambda: second(messages.make_twist(node.make, 99.0, 0.0)))
other.close()
other.close()
ends = rosgraph.Master("/test").getSystemState()[:2]
left = [topic for kind in ends for topic, nodes in kind if any("rlrobot" in name for name in nodes)]
tell(more=len(poses) - n, left=left, lost=node.lost, refusal=refusal(drive),
     hear=refusal(node.hear, "odom", messages.ODOMETRY, print),
     elsewhere=refusal(RospyNode, "http://127.0.0.1:9"))
"""
    )
    assert told["more"] == 0
    assert told["left"] == ["/rosout"]
    assert told["lost"] == "this connection was closed"
    assert told["refusal"] == told["hear"] == "ConnectionError: this connection was closed"
    assert "allows it no second one at http://127.0.0.1:9" in told["elsewhere"]
    assert "rlrobot" not in str(ServerProxy(ros.env["ROS_MASTER_URI"]).getSystemState("/test"))  # its process has ended
    heard = ros.said(robot, "heard")
    assert [f"heard {v:.1f}" for v in range(1, 10)] == [
        line for line in heard if line not in ("heard 0.25", "heard 99.0")
    ]


def test_nothing_is_left_in_the_home_and_logging_is_as_it_was(ros):
    ros.robot()
    told = ros.run(
        """
import logging
before = (logging.getLogger().handlers[:], logging.getLogger().level, logging.getLoggerClass())
"""
        + DRIVER
        + """
node.close()
after = (logging.getLogger().handlers[:], logging.getLogger().level, logging.getLoggerClass())
tell(same=before == after)
"""
    )
    assert told["same"]
    assert list(ros.home.iterdir()) == []
    assert ros.processes[-1].out.read_text().count("\n") == 1  # rospy prints nothing either


def test_all_of_it_listens_on_this_machine_alone(ros):
    robot = ros.robot()
    ours = ros.start(DRIVER + "tell(ready=True)\ntime.sleep(60)")
    ros.said(ours, "{")
    for process in (ros.master, robot, ours):
        sockets = psutil.Process(process.pid).net_connections("inet")
        listening = {each.laddr.ip for each in sockets if each.status == psutil.CONN_LISTEN}
        assert listening == {"127.0.0.1"}


def test_a_robot_that_dies_and_comes_back_is_heard_again(ros):
    robot = ros.robot()
    ours = ros.start(
        DRIVER
        + """
tell(ready=True)
until(Path("go").exists)
time.sleep(0.1)
poses.clear(), scans.clear()
until(lambda: poses and scans, drive)
tell(pose=messages.pose_of(poses[-1]), lost=node.lost)
"""
    )
    ros.said(ours, "{")
    robot.kill()
    robot.wait()
    ros.robot()
    ros.go()
    told = ros.told(ours)
    assert told["pose"][:2] == [0.25, -0.5] and told["lost"] is None


def test_messages_flow_without_the_master_but_nothing_new_is_heard_or_said(ros):
    ros.robot()
    ours = ros.start(
        DRIVER
        + """
tell(ready=True)
until(Path("go").exists)
hear = refusal(node.hear, "more", messages.ODOMETRY, print)
speak = refusal(node.speak, "more", messages.TWIST)
poses.clear(), scans.clear()
until(lambda: poses and scans, drive)
lost, began = node.lost, time.monotonic()
node.close()
tell(hear=hear, speak=speak, again=refusal(RospyNode), lost=lost, seconds=time.monotonic() - began)
"""
    )
    ros.said(ours, "{")
    ros.master.kill()
    ros.master.wait()
    ros.go()
    told = ros.told(ours)
    for refused in ("hear", "speak", "again"):
        assert told[refused].startswith("ConnectionError: no ROS master answers")
    assert told["lost"] is None and told["seconds"] < 20


def test_a_node_that_was_shut_down_says_so(ros):
    ros.robot()
    told = ros.run(
        DRIVER
        + """
import rospy, xmlrpc.client

xmlrpc.client.ServerProxy(rospy.get_node_uri()).shutdown("/test", "as rosnode kill does")
until(lambda: node.lost)
tell(lost=node.lost, send=refusal(drive), hear=refusal(node.hear, "odom", messages.ODOMETRY, print),
     again=refusal(RospyNode))
node.close()
"""
    )
    assert told["lost"].startswith("the ROS node of this process was shut down from outside")
    assert told["send"] == told["hear"] == told["again"] == f"ConnectionError: {told['lost']}"


def test_a_callback_that_fails_is_seen_and_the_next_message_comes(ros):
    ros.robot()
    told = ros.run(
        DRIVER
        + """
calls = []
node.hear("odom", messages.ODOMETRY, lambda message: calls.append(0) or 1 / 0)
until(lambda: len(calls) > 2, drive)
tell(lost=node.lost, kind=refusal(node.make, "no_such/Thing"))
"""
    )
    assert told["lost"] is None
    assert "ZeroDivisionError" in ros.processes[-1].out.read_text()
    assert told["kind"].startswith("ImportError: there are no ROS messages of the kind 'no_such/Thing'")
    assert "python3-no-such" in told["kind"]


def test_without_rospy_it_is_said_where_it_comes_from(monkeypatch):
    monkeypatch.setitem(sys.modules, "rospy", None)
    with pytest.raises(ImportError, match=r"rospy cannot be imported .*python3-rospy, not from PyPI.*'rosbridge'"):
        connect("rospy")
