"""A robot behind a link: it is the robot itself, and no message is so wrong that it does harm."""

import json
import math
import re
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import fake_robot
import pytest
from fake_robot import AHEAD, LEFT, V
from hypothesis import given
from hypothesis import strategies as st
from waiting import eventually

import rlrobot_edu as rl
from rlrobot_edu.robots.chassis import GIRAFF
from rlrobot_ros import RobotLink
from rlrobot_ros.live import controller
from rlrobot_ros.live.latest_message import LatestMessage
from rlrobot_ros.live.sensors import Sensors
from rlrobot_ros.messages import (
    LASER_SCAN,
    ODOMETRY,
    make_laser_scan,
    make_odometry,
)
from rlrobot_ros.scan import Mounting

robot, env = fake_robot.robot, fake_robot.env  # fixtures

COMPARE = """
    import sys
    import numpy as np
    import rlrobot_edu as rl
    from rlrobot_ros import RobotLink
    from ticking import Ticking

    # its own safety stop, of three lasers, is the only one: that of the link looks at more
    link = RobotLink(sys.argv[1], safety_distance=0.001, confirmed=True, simulated_time=True)
    histories, agents, last = [], [], []
    for robot in (link, Ticking()):
        env = rl.make_env("giraff_wander_simple", link=robot)
        agents.append(rl.Agent("giraff_wander_simple", seed=5))
        histories.append(rl.learn(agents[-1], env, steps=200, keep=True, progress=False))
        last.append(robot.readings)
        env.close()
    behind, direct = histories
    for name in ("s", "a", "rewards", "s_next"):
        np.testing.assert_array_equal(getattr(behind, name), getattr(direct, name))
    np.testing.assert_array_equal(agents[0].q, agents[1].q)
    assert len(set(behind.s)) > 1 and len(set(behind.a)) == 4 and len(set(behind.rewards)) > 1, "nothing happened"
    for name, reading in last[1].items():
        assert abs(reading - last[0][name]) < 1e-5, name  # a scan is in single precision
    print("They are alike.")
"""


# It says what becomes of its steps, and begins again when it is told to.
DRIVE = """
    import sys
    import rlrobot_edu as rl
    from rlrobot_ros import RobotLink
    from rlrobot_ros.live import controller

    env = rl.make_env("giraff_wander_simple", link=RobotLink(sys.argv[1], confirmed=True))
    while True:
        try:
            controller.PATIENCE = 30.0  # until they have found each other, on a busy machine
            env.reset()
            env.step(1)
            controller.PATIENCE = 3.0
            print("it moves", flush=True)
            while True:
                env.step(1)
        except OSError as error:
            print(type(error).__name__, error, flush=True)
        if not input():
            break
    env.close()
"""


class Served:
    """A robot that is served in a process of its own, as a learner would start it, and scripts that use it."""

    def __init__(self):
        self._port, self._processes = 0, []

    def start(self, *options):
        """Start the robot, again where it was before; returns its process."""
        port = ["--port", str(self._port)]
        command = [sys.executable, "-m", "rlrobot_edu", "serve-robot", *port, *options]
        process = self._open(command)
        said = process.stdout.readline()
        assert "is on" in said, said + process.stdout.read()
        self._port = int(re.findall(r":(\d+)\.", said)[-1])
        return process

    def run(self, program):
        """Start a script, whose argument is where the robot is; returns its process."""
        address = f"ws://127.0.0.1:{self._port}"
        command = [sys.executable, "-c", textwrap.dedent(program), address]
        return self._open(command, cwd=Path(__file__).parents[1])

    def _open(self, command, **how):
        process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            **how,
        )
        self._processes.append(process)
        return process

    def end(self):
        for process in self._processes:
            process.kill()
            process.communicate()


@pytest.fixture
def served():
    served = Served()
    yield served
    served.end()


def test_a_learner_behind_a_link_learns_what_it_learns_on_the_robot_itself(served):
    served.start("--simulated-time")
    assert served.run(COMPARE).communicate(timeout=500)[0] == "They are alike.\n"


def test_a_robot_that_dies_and_comes_back_is_driven_again(served):
    robot = served.start()
    driver = served.run(DRIVE)
    assert driver.stdout.readline() == "it moves\n"
    robot.kill()
    said = driver.stdout.readline()
    assert said.startswith(("ConnectionError", "TimeoutError")), said
    served.start()
    for _ in range(5):  # until its nodes have found each other again
        print("again", file=driver.stdin, flush=True)
        said = driver.stdout.readline()
        if said == "it moves\n":
            break
    assert said == "it moves\n"


def test_what_comes_twice_or_out_of_order_changes_nothing(env, robot, monkeypatch):
    env.reset()
    env.step(LEFT)
    robot.fall_silent()
    now = time.monotonic() + 1000.0
    for stamp, x in ((now, 1.0), (now, 2.0), (now - 0.3, 3.0), (now - 100.0, 4.0)):
        robot.say(ODOMETRY, robot.pose(stamp, (x, 0.0, 0.0)))
        robot.say(LASER_SCAN, robot.scan(stamp))
    link = env.unwrapped.robot
    assert link.readings["x"] == 1.0 and link.report.not_new == 6


def test_messages_that_are_lost_are_not_missed_while_others_come(
    env, robot, monkeypatch
):
    env.reset()
    whole, scans = robot.scan, iter(range(10**6))
    monkeypatch.setattr(
        robot, "scan", lambda stamp: whole(stamp) if next(scans) % 4 == 0 else None
    )  # 5 a second
    link = env.unwrapped.robot
    for _ in range(30):
        if link.report.unreadable <= 5:  # as a rule, 15 are lost in one step
            env.step(AHEAD)
    assert (
        link.report.unreadable > 5
        and link.report.pauses == 0
        and (V, 0.0) in robot.motions()
    )


@pytest.mark.parametrize(
    "spoil",
    [
        lambda odom, scan: setattr(scan, "ranges", "abc"),
        lambda odom, scan: setattr(scan, "ranges", []),
        lambda odom, scan: setattr(scan, "ranges", [[1.0]]),
        lambda odom, scan: setattr(scan, "angle_increment", 0.0),
        lambda odom, scan: setattr(scan, "angle_min", None),
        lambda odom, scan: setattr(scan, "header", None),
        lambda odom, scan: setattr(scan.header.stamp, "sec", -5),
        lambda odom, scan: setattr(odom.pose.pose.position, "x", math.nan),
        lambda odom, scan: setattr(odom.pose.pose.position, "x", "1 m"),
        lambda odom, scan: setattr(odom.pose.pose.orientation, "w", math.inf),
        lambda odom, scan: setattr(odom.pose, "pose", None),
        lambda odom, scan: setattr(odom.header.stamp, "nanosec", "soon"),
        lambda odom, scan: vars(odom).clear(),
    ],
)
def test_a_malformed_message_is_counted_named_and_not_used(env, robot, spoil):
    before = env.reset()[1]["readings"]
    now = time.monotonic() + 1000.0
    odom, scan = robot.pose(now, (3.0, 0.0, 0.0)), robot.scan(now)
    spoil(odom, scan)
    robot.say(ODOMETRY, odom)
    robot.say(LASER_SCAN, scan)
    report = env.unwrapped.robot.report
    assert report.unreadable == 1 and report.complaint
    assert {"x", "laser_front"} <= before.keys()


anything = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.just(10**400)
    | st.floats()
    | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["x", "sec", "pose"]), inner, max_size=2)
    ),
    max_leaves=4,
)


def namespaces(value):
    """What JSON becomes on its way from rosbridge."""
    return json.loads(
        json.dumps(value), object_hook=lambda fields: SimpleNamespace(**fields)
    )


@given(st.data())
def test_whatever_a_message_holds_it_is_taken_or_counted_as_unreadable(data):
    for make, hear in (
        (make_odometry, "receive_odometry"),
        (make_laser_scan, "receive_scan"),
    ):
        said = (
            (0.1, 0.2, 0.3) if hear == "receive_odometry" else ([1.0, 2.0, 3.0], 10.0)
        )
        message = make(5.0, *said)
        here = message
        while True:  # down to some part of it, which becomes anything
            name = data.draw(st.sampled_from(sorted(here)))
            if not isinstance(here[name], dict) or data.draw(st.booleans()):
                break
            here = here[name]
        here[name] = data.draw(anything)
        sensors = Sensors(GIRAFF, Mounting(), "odom", "scan")
        getattr(sensors, hear)(namespaces(message))
        latest = sensors.pose if hear == "receive_odometry" else sensors.sight
        assert latest.received + sensors.unreadable == 1
        if latest.value is not None and hear == "receive_odometry":
            assert all(map(math.isfinite, latest.value.values()))


def test_a_robot_that_is_elsewhere_after_a_silence_ends_the_step(
    env, robot, monkeypatch
):
    monkeypatch.setattr(controller, "MAX_AGE", fake_robot.MAX_AGE)
    env.reset()
    robot.is_silent = True
    seen = []

    def step():
        with pytest.raises(ConnectionError, match="carried or restarted") as error:
            env.step(AHEAD)
        seen.append(error)

    thread = threading.Thread(target=step)
    thread.start()
    eventually(lambda: env.unwrapped.robot.report.pauses)
    time.sleep(0.5)  # it has also looked where it is
    robot.here, robot.is_silent = (2.0, 0.0, 0.0), False
    thread.join(60)
    assert seen and robot.motions()[-1] == (0.0, 0.0)
    assert env.reset()[1]["readings"]["x"] == 2.0  # and from there it goes on
    env.step(LEFT)


def test_a_lost_connection_ends_the_step_and_reset_connects_again(env, robot):
    env.reset()
    env.step(LEFT)
    robot.lost = "the connection to the fake robot is lost"
    with pytest.raises(
        ConnectionError, match=r"fake robot is lost; env\.reset\(\) connects again"
    ):
        env.step(AHEAD)
    robot.is_closed = False
    robot.lost = None
    link = env.unwrapped.robot
    robot.lost = "again"
    with pytest.raises(ConnectionError, match="again"):
        env.reset()
    assert robot.is_closed  # the old connection is ended
    robot.lost = None
    env.reset()
    env.step(LEFT)
    assert link.report.commands


def test_a_robot_that_is_not_there_is_said_to_be_so(robot, monkeypatch):
    monkeypatch.setattr(controller, "PATIENCE", 0.3)
    robot.is_silent = True
    env = rl.make_env("giraff_wander_simple", link=RobotLink(odom="odometry"))
    with pytest.raises(
        TimeoutError,
        match=r"nothing readable comes from the topic 'odometry' \(0 messages so far\)",
    ):
        env.reset()
    assert not robot.told
    env.close()


def narrow_scan(robot, stamp):
    """A scan of 60 degrees to the front."""
    scan = fake_robot.received(fake_robot.make_laser_scan(stamp, [1.0] * 61, 10.0))
    scan.angle_min, scan.angle_increment = math.radians(-30), math.radians(1)
    return scan


def test_a_task_whose_lasers_the_scanner_cannot_stand_for_is_refused_at_reset(robot):
    robot.scan = lambda stamp: narrow_scan(robot, stamp)
    env = rl.make_env("giraff_wander_simple", link=RobotLink())
    with pytest.raises(
        ValueError,
        match="giraff_wander_simple needs laser_front_left, laser_front_right, where",
    ):
        env.reset()
    env.close()


def test_a_link_needs_an_environment_and_an_environment_no_engine():
    link = RobotLink()
    with pytest.raises(ValueError, match=r"rl\.make_env\(task, link=…\)"):
        link.reset()
    with pytest.raises(ConnectionError, match=r"env\.reset\(\) first"):
        link.act({"left_wheel": 0.0, "right_wheel": 0.0})
    for name, value in {
        "engine": "pymunk",
        "realism": rl.Realism(laser_noise=0.1),
        "lag": 0.1,
        "chassis": 0,
        "colour": "",
    }.items():
        with pytest.raises(ValueError, match=f"takes no {name}: leave it out"):
            rl.make_env("giraff_wander_simple", link=link, **{name: value})
    with pytest.raises(ValueError, match=r"only a task has a robot: .* link"):
        rl.make_env(
            rl.SampleModel.from_recording(rl.read_recording("wander_simple")), link=link
        )
    with pytest.raises(ValueError, match="cmd_vel commands wheels alone"):
        rl.make_env("arm_1k", link=link)
    with pytest.raises(ValueError, match="dry_run or simulated_time"):
        RobotLink(dry_run=True, simulated_time=True)
    with pytest.raises(ValueError, match="the address of rosbridge must be ws://"):
        rl.make_env("giraff_wander_simple", link=RobotLink("rosbridge")).reset()


def test_what_is_seen_of_a_robot_behind_a_link_is_itself_and_its_beams(env, robot):
    robot.here = (1.0, 2.0, 0.5)
    env.reset()
    scene = env.unwrapped.robot.scene()
    body = next(solid for solid in scene.solids if solid.name == "robot/body")
    assert body.pose[:2, 3] == pytest.approx([1.0, 2.0]) and scene.beams.shape == (
        8,
        2,
        3,
    )
    rl.plot_scene(scene)


# (how long after the one before it is here, by how much its clock went on)
messages = st.lists(
    st.tuples(st.floats(0.0, 2.0), st.floats(-1.0, 2.0)), min_size=1, max_size=30
)


@given(messages, st.floats(0, 1e6))
def test_no_message_is_younger_than_it_is_here_and_none_is_used_after_a_newer_one(
    steps, clock
):
    latest, now, stamp, newest = LatestMessage(), 0.0, clock + 1.0, -1.0
    for wait, ahead in steps:
        now, stamp = now + wait, max(stamp + ahead, 1e-3)
        latest.take(stamp, stamp, now)
        is_new = stamp > newest
        newest = max(newest, stamp)
        assert latest.value == newest
        assert (
            latest.age(now) >= (-1e-9 if is_new else 0)
            and latest.age(now + 1.0) >= 1.0 - 1e-9
        )


def test_a_message_without_a_time_is_as_old_as_it_is_here():
    latest = LatestMessage()
    assert latest.age(5.0) == math.inf
    for now in (1.0, 2.0):
        latest.take(0.0, "it", now)
    assert latest.received == 2 and latest.dropped == 0 and latest.age(2.5) == 0.5


def test_clocks_that_drift_apart_make_no_message_old():
    latest = LatestMessage()
    for i in range(
        36_000
    ):  # an hour, ten a second; the sender's clock is slow by 100 ppm
        latest.take(5.0 + 0.1 * i * 0.9999, i, 0.1 * i)
    assert latest.age(0.1 * i) < 0.01
