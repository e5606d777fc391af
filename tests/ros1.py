"""A world of ROS 1: a real master, a robot that speaks rospy directly, and scripts that use the library.

rospy allows a process one node, once: so each node runs in a process of its own.
"""

import importlib.util
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

FOLDER = os.environ.get("RLROBOT_EDU_ROSPY")
HOW = "run tests/unpack_rospy.sh FOLDER, and the tests with RLROBOT_EDU_ROSPY=FOLDER"
PATIENCE = 60  # [s] on a busy machine

MASTER = """
import time
from rosmaster.master import Master

master = Master(port=0)  # any that is free
master.start()
print(master.uri, flush=True)
while master.ok():
    time.sleep(0.1)
"""

# It answers a Twist with where it says that it is, x = speed and y = turning, and with what its scanner sees.
ROBOT = """
import rospy
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

rospy.init_node("robot")
odom = rospy.Publisher("odom", Odometry, queue_size=10, tcp_nodelay=True)
scan = rospy.Publisher("scan", LaserScan, queue_size=10, tcp_nodelay=True)

def answer(stamp, twist):
    print("heard", twist.linear.x, flush=True)
    message = Odometry()
    message.header.stamp = stamp
    message.pose.pose.position.x, message.pose.pose.position.y = twist.linear.x, twist.angular.z
    message.pose.pose.orientation.z = message.pose.pose.orientation.w = 0.5**0.5
    odom.publish(message)
    message = LaserScan(angle_increment=0.0175, range_max=4.0, ranges=[1.5] * 359 + [float("inf")])
    message.header.stamp = stamp
    scan.publish(message)

rospy.Subscriber("cmd_vel", Twist, lambda m: answer(rospy.Time(7, 500_000_000), m), tcp_nodelay=True)
rospy.Subscriber("stamped", TwistStamped, lambda m: answer(m.header.stamp, m.twist), tcp_nodelay=True)
print("ready", flush=True)
rospy.spin()
"""

OURS = """
import json, time
from pathlib import Path
from rlrobot_edu.ros import messages
from rlrobot_edu.ros.live.rospy_node import RospyNode

def until(condition, act=lambda: None):
    deadline = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < deadline, "it did not happen"
        act()
        time.sleep(0.02)

def tell(**what):
    print(json.dumps(what), flush=True)

def refusal(call, *args):
    try:
        call(*args)
    except (ConnectionError, ImportError) as error:
        return f"{type(error).__name__}: {error}"
"""

DRIVER = (
    OURS
    + """
node = RospyNode()
poses, scans = [], []
node.hear("odom", messages.ODOMETRY, poses.append)
node.hear("scan", messages.LASER_SCAN, scans.append)
send = node.speak("cmd_vel", messages.TWIST)
drive = lambda: send(messages.make_twist(node.make, 0.25, -0.5))
until(lambda: poses and scans, drive)
"""
)


def until(condition, what):
    """Wait until something is so, and return what it is."""
    deadline = time.monotonic() + PATIENCE
    while not (found := condition()):
        assert time.monotonic() < deadline, what()
        time.sleep(0.02)
    return found


class Ros:
    """A world of ROS 1: a master, and processes that run scripts. Only `home` is the home of a script of ours."""

    def __init__(self, path, folder):
        self.folder, self.home, self.processes = folder, folder / "home", []
        self.home.mkdir()
        self.env = {name: value for name, value in os.environ.items() if not name.startswith("ROS_")}
        self.env |= {"HOME": str(self.home), "PYTHONPATH": os.pathsep.join([*sys.path, *path])}
        self.master = self.theirs(MASTER)
        self.env["ROS_MASTER_URI"] = self.said(self.master, "http")[0]

    def theirs(self, script):
        """Start a script that does not use the library. It may log, but not into `home`."""
        return self.start(script, ROS_IP="127.0.0.1", ROS_LOG_DIR=str(self.folder / "log"))

    def start(self, script, **env):
        out = self.folder / f"{len(self.processes)}.txt"
        with out.open("wb") as file:
            process = subprocess.Popen(
                [sys.executable, "-c", script], env=self.env | env, stdout=file, stderr=file, cwd=self.folder
            )
        process.out = out
        self.processes.append(process)
        return process

    def robot(self):
        robot = self.theirs(ROBOT)
        self.said(robot, "ready")
        return robot

    def said(self, process, beginning):
        """Lines of the process that begin so, as soon as there are any."""

        def lines():
            return [line for line in process.out.read_text().splitlines(True) if line[-1] == "\n"]

        def found():
            assert process.poll() in (None, 0), process.out.read_text()
            return [line.strip() for line in lines() if line.startswith(beginning)]

        return until(found, process.out.read_text)

    def run(self, script):
        """What a script of ours tells in the end."""
        return self.told(self.start(script))

    def told(self, process):
        assert process.wait(PATIENCE) == 0, process.out.read_text()
        return json.loads(self.said(process, "{")[-1])

    def go(self):
        """Create the file for which a script waits by `until(Path("go").exists)`."""
        (self.folder / "go").touch()

    def end(self):
        for process in self.processes:
            process.kill()
            process.wait()


@pytest.fixture(scope="module")
def path():
    """What must be on the path of a process that shall import rospy."""
    if not FOLDER and importlib.util.find_spec("rospy") is None:
        pytest.skip(f"rospy is not here: {HOW}")
    path = [str(Path(FOLDER, "usr/lib/python3/dist-packages").resolve())] if FOLDER else []
    trial = subprocess.run(
        [sys.executable, "-c", "import rospy, rosmaster, nav_msgs.msg, sensor_msgs.msg"],
        env=os.environ | {"PYTHONPATH": os.pathsep.join([*sys.path, *path])},
        capture_output=True,
        text=True,
    )
    if trial.returncode:
        pytest.skip(f"rospy does not import here ({trial.stderr.splitlines()[-1]}): {HOW}")
    return path


@pytest.fixture
def ros(path, tmp_path):
    ros = Ros(path, tmp_path)
    yield ros
    ros.end()
