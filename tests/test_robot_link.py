"""A robot behind a link: over each link it is the robot itself, and no message is so wrong that it does harm."""

import math
import re
import subprocess
import sys
import textwrap
import threading
import time

import fake_robot
import pytest
from fake_robot import AHEAD, LEFT, V
from hypothesis import given
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.ros.live import steering
from rlrobot_edu.ros.live.latest import Latest
from rlrobot_edu.ros.messages import LASER_SCAN, ODOMETRY

robot, env = fake_robot.robot, fake_robot.env  # fixtures

NEEDS = {"rosbridge": "websockets", "dds": "cyclonedds"}
COMPARE = """
    import sys
    import numpy as np
    import rlrobot_edu as rl
    from ticking import Ticking

    where = {"address": sys.argv[2]} if sys.argv[2:] else {}
    link = rl.RobotLink(sys.argv[1], confirmed=True, simulated_time=True, **where)
    histories, agents, last = [], [], []
    for robot in (link, Ticking()):
        env = rl.make_env("giraff_wander_simple", link=robot)
        agents.append(rl.Agent("giraff_wander_simple", seed=5))
        histories.append(rl.learn(agents[-1], env, steps=200, progress=False))
        last.append(robot.readings)
        env.close()
    behind, direct = histories
    for name in ("s", "a", "rewards", "s_next"):
        np.testing.assert_array_equal(getattr(behind, name), getattr(direct, name))
    np.testing.assert_array_equal(agents[0].q, agents[1].q)
    assert len(set(behind.s)) > 2 and len(set(behind.rewards)) > 2, "nothing happened"
    for name, reading in last[1].items():
        assert abs(reading - last[0][name]) < 1e-5, name  # a scan is in single precision
    print("They are alike.")
"""


@pytest.mark.parametrize("link", ["rosbridge", "dds", "rospy"])
def test_a_learner_behind_a_link_learns_what_it_learns_on_the_robot_itself(link, request):
    if link == "rospy":
        env = request.getfixturevalue("ros").env
    else:
        pytest.importorskip(NEEDS[link], reason=f"pip install 'rlrobot-edu[{'ros' if link == 'rosbridge' else 'ros2'}]'")
        env = None
    port = ["--port", "0"] if link == "rosbridge" else []
    serve = [sys.executable, "-m", "rlrobot_edu", "serve-robot", "--simulated-time", "--link", link, *port]
    served = subprocess.Popen(serve, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        said = served.stdout.readline()
        assert "is on" in said, said + served.stdout.read()
        address = re.findall(r"ws://[\d.:]*\d", said)
        compare = [sys.executable, "-c", textwrap.dedent(COMPARE), link, *address]
        told = subprocess.run(compare, env=env, cwd="tests", capture_output=True, text=True, timeout=120)
        assert told.stdout == "They are alike.\n", told.stderr
    finally:
        served.kill()
        served.stdout.close()
        served.wait()
