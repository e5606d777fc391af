"""A kernel that drives a robot and is killed: which commands the robot gets after that."""

import queue
import subprocess
import sys

from rlrobot_edu import make_env
from rlrobot_ros import RobotLink
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.messages import TWIST, velocity_of

PATIENCE = 60.0  # how long it may take until a second process drives [s]


def kill_a_driver(address: str) -> tuple[float, float]:
    """The speed [m/s] that a process tells the robot until it is killed, and the next different one that is said.

    address: of rosbridge. Raises queue.Empty if nothing is said.
    """
    said: queue.SimpleQueue[float] = queue.SimpleQueue()
    connection = Rosbridge(address)
    try:
        connection.subscribe(
            "cmd_vel", TWIST, lambda message: said.put(velocity_of(message)[0])
        )
        with subprocess.Popen([sys.executable, "-m", __name__, address]) as driver:
            try:
                before = said.get(timeout=PATIENCE)
            finally:
                driver.kill()
        after = before
        while after == before:  # its last words are still on their way
            after = said.get(timeout=PATIENCE)
        return before, after
    finally:
        connection.close()


def drive(address: str) -> None:
    """Drive the robot of wander_1k on and on: this is the process that is killed."""
    link = RobotLink(address, confirmed=True, max_speed=0.2)
    env = make_env("wander_1k", link=link)
    env.reset()
    while True:
        env.step(8)  # both wheels forward


if __name__ == "__main__":
    drive(sys.argv[1])
