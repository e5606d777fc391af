"""One of the toolkit's own robots behind ROS: it moves as it is told, stops by itself, and tells what it sees."""

import math
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from waiting import eventually

import rlrobot_edu as rl
from rlrobot_edu.robots.giraff import Giraff
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_ros import ServedRobot
from rlrobot_ros.messages import (
    LASER_SCAN,
    ODOMETRY,
    TWIST,
    make_twist,
    pose_of,
    stamp_of,
)
from rlrobot_ros.scan import Mounting, laser_readings

pytest.importorskip("websockets", reason="rosbridge needs pip install websockets")
from rlrobot_ros.live.rosbridge import Rosbridge


class Listener:
    """Somebody who hears a served robot and can tell it what to do."""

    def __init__(self, robot):
        self.connection = Rosbridge(robot.address)
        self.poses, self.scans = [], []
        self.connection.subscribe("odom", ODOMETRY, self.poses.append)
        self.connection.subscribe("laser_scan", LASER_SCAN, self.scans.append)
        self._say = self.connection.advertise("cmd_vel", TWIST)
        eventually(lambda: self.poses and self.scans)

    def tell(self, v, omega):
        self._say(make_twist(v, omega))

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.connection.close()


def test_in_simulated_time_each_command_takes_the_robot_a_tenth_of_a_second_on():
    with (
        ServedRobot("wander_1k", port=0, simulated_time=True) as robot,
        Listener(robot) as listener,
    ):
        begin, (x, y, theta) = stamp_of(listener.poses[-1]), pose_of(listener.poses[-1])
        there = (x + 0.1 * math.cos(theta), y + 0.1 * math.sin(theta), theta)
        for i in range(1, 11):
            listener.tell(0.1, 0.0)
            eventually(
                lambda i=i: stamp_of(listener.poses[-1]) > begin + 0.1 * i - 0.01
            )
        assert stamp_of(listener.poses[-1]) == pytest.approx(begin + 1.0)
        assert pose_of(listener.poses[-1]) == pytest.approx(there)


def test_it_stops_by_itself_when_it_is_told_nothing_more():
    with ServedRobot("wander_1k", port=0) as robot, Listener(robot) as listener:
        x = pose_of(listener.poses[-1])[0]
        eventually(
            lambda: pose_of(listener.poses[-1])[0] != x, lambda: listener.tell(0.1, 0.0)
        )
        eventually(lambda: len(set(map(pose_of, listener.poses[-5:]))) == 1)


def test_a_twist_that_says_nothing_that_can_be_is_not_obeyed():
    with (
        ServedRobot("wander_1k", port=0, simulated_time=True) as robot,
        Listener(robot) as listener,
    ):
        begin = stamp_of(listener.poses[-1])
        send = listener.connection.advertise("cmd_vel", TWIST)
        for wrong in (
            {},
            {"linear": {"x": "fast"}},
            {"linear": {"x": None}, "angular": {"z": 0.0}},
        ):
            send(wrong)
        listener.tell(1e300, -1e300)  # more than its wheels can do is cut off
        eventually(lambda: stamp_of(listener.poses[-1]) > begin)
        assert stamp_of(listener.poses[-1]) == pytest.approx(begin + 0.1)


def test_its_scan_shows_what_its_lasers_see():
    for task, base, tolerance in (
        (
            "giraff_wander_1k",
            Giraff("hexagon_giraff", 0.1),
            1e-6,
        ),  # its lasers look straight away from its scanner
        (
            "wander_1k",
            MobileBase("maze_6x6", 0.1),
            0.05,
        ),  # here a wall's end may hide what a laser sees
    ):
        with (
            ServedRobot(task, port=0, simulated_time=True) as robot,
            Listener(robot) as listener,
        ):
            scan = listener.scans[-1]
        assert len(scan.ranges) == 360
        misses = [
            r - base.readings[laser]
            for laser, r in laser_readings(scan, base.chassis, Mounting()).items()
        ]
        assert len(misses) == 8 and max(misses) <= tolerance
        assert sum(abs(miss) <= tolerance for miss in misses) >= (
            8 if task.startswith("giraff") else 6
        )


def test_realism_shows_in_its_scans_and_in_its_motion():
    noisy = rl.Realism(laser_noise=0.05, wheel_slip=0.2)
    ends = []
    for realism in (None, noisy):
        robot = ServedRobot(
            "wander_1k", realism=realism, seed=1, port=0, simulated_time=True
        )
        with robot, Listener(robot) as listener:
            begin = stamp_of(listener.poses[-1])
            listener.tell(0.1, 0.0)
            eventually(
                lambda begin=begin, listener=listener: (
                    stamp_of(listener.scans[-1]) > begin
                )
            )
            ends.append(
                (
                    np.array(listener.scans[-1].ranges, float),
                    pose_of(listener.poses[-1]),
                )
            )
    (ideal, straight), (real, crooked) = ends
    assert 0.02 < np.std(real - ideal) < 0.1 and straight != crooked


def test_with_a_seed_and_in_simulated_time_noise_is_the_same_however_long_one_waits():
    ends = []
    for pause in (0.0, 0.6):  # meanwhile, it says again and again what is so
        robot = ServedRobot(
            "wander_1k",
            realism=rl.Realism(laser_noise=0.05),
            seed=1,
            port=0,
            simulated_time=True,
        )
        with robot, Listener(robot) as listener:
            time.sleep(pause)
            begin = stamp_of(listener.poses[-1])
            listener.tell(0.1, 0.0)
            eventually(
                lambda begin=begin, listener=listener: (
                    stamp_of(listener.scans[-1]) > begin
                )
            )
            ends.append(list(listener.scans[-1].ranges))
    assert ends[0] == ends[1]


def test_only_a_robot_on_wheels_that_pymunk_simulates_can_be_served():
    with pytest.raises(ValueError, match="cmd_vel commands wheels alone"):
        ServedRobot("arm_1k", port=0)
    with pytest.raises(ValueError, match=r"lag must be below .*, a control step"):
        ServedRobot("wander_1k", port=0, realism=rl.Realism.vrep())


@pytest.mark.skipif(
    sys.platform == "win32", reason="Windows has no SIGINT for one process alone"
)
def test_the_command_serves_until_ctrl_c_and_leaves_without_a_trace():
    command = [sys.executable, "-m", "rlrobot_edu", "serve-robot", "--port", "0"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        assert (
            "odom, laser_scan and cmd_vel over rosbridge at ws://127.0.0.1:"
            in process.stdout.readline()
        )
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 0 and process.stdout.read() == ""
    finally:
        process.kill()
        process.stdout.close()
        process.wait()


def test_the_command_says_in_one_sentence_what_is_wrong():
    command = [sys.executable, "-m", "rlrobot_edu", "serve-robot", "--port", "-1"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    said = "a port is a whole number from 0 to 65535"
    assert done.returncode == 1 and said in done.stderr and done.stderr.count("\n") == 1
