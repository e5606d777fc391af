"""A robot that is nothing but its messages, for tests of what a link makes of them."""

import json
import math
import threading
import time
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

import rlrobot_edu as rl
from rlrobot_ros import RobotLink
from rlrobot_ros.live import controller, session
from rlrobot_ros.messages import (
    LASER_SCAN,
    ODOMETRY,
    make_laser_scan,
    make_odometry,
    velocity_of,
)


def received(message: dict[str, Any]) -> Any:
    """A message as it arrives over rosbridge."""
    text = json.dumps(message)
    return json.loads(text, object_hook=lambda fields: SimpleNamespace(**fields))


class FakeRobot:
    """A connection whose other side is this object.

    told: (time, v, omega) of each command; said twenty times a second: where it is, and its rays [m]
    delay: how late its messages are [s]; is_silent: whether there are none
    """

    def __init__(self) -> None:
        self.lost, self.errors = None, ()
        self.told: list[tuple[float, float, float]] = []
        self.here, self.rays = (0.0, 0.0, 0.0), [1.0] * 8
        self.delay, self.is_silent, self.is_closed = 0.0, False, False
        self.topics: list[str] = []
        self._callbacks: dict[str, Callable[[Any], None]] = {}
        self._ends, self._speaks = threading.Event(), threading.Lock()
        self._thread = threading.Thread(target=self._live, daemon=True)
        self._thread.start()

    def subscribe(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        self.topics.append(topic)
        self._callbacks[kind] = callback

    def advertise(self, topic: str, kind: str) -> Callable[[Any], None]:
        self.topics.append(topic)

        def say(message: Any) -> None:
            if self.lost:
                raise ConnectionError(self.lost)
            v, _, omega = velocity_of(received(message))
            self.told.append((time.monotonic(), v, omega))

        return say

    def close(self) -> None:
        self.is_closed = True

    def fall_silent(self) -> None:
        """Say nothing more; when this returns, nothing is on its way."""
        self.is_silent = True
        with self._speaks:
            pass

    def show(self, rays: list[float]) -> None:
        """Let its scanner see this from now on; when this returns, it has been heard."""
        with self._speaks:
            self.rays = rays
            self.say(LASER_SCAN, self.scan(time.monotonic() + 1000.0))

    def end(self) -> None:
        self._ends.set()
        self._thread.join()

    def say(self, kind: str, message: Any) -> None:
        """Let the link hear a message, whatever it is."""
        self._callbacks[kind](message)

    def pose(self, stamp: float, here: tuple[float, float, float] | None = None) -> Any:
        return received(make_odometry(stamp, *(here or self.here)))

    def scan(self, stamp: float) -> Any:
        return received(make_laser_scan(stamp, self.rays, 10.0))

    def _live(self) -> None:
        while not self._ends.wait(0.05):
            with self._speaks:
                if not self.is_silent and len(self._callbacks) == 2:
                    stamp = time.monotonic() + 1000.0 - self.delay  # a clock of its own
                    self.say(ODOMETRY, self.pose(stamp))
                    self.say(LASER_SCAN, self.scan(stamp))

    def motions(self) -> list[tuple[float, float]]:
        """What it was told: v and omega, without what rounding left of them."""
        return [(round(v, 9), round(omega, 9)) for _, v, omega in self.told]


class FakeGuardian:
    """Stands in for the second process where there is nothing to connect to."""

    def __init__(self, *settings: Any) -> None:
        self.settings = settings

    def close(self) -> None:
        pass


@pytest.fixture
def robot(monkeypatch):
    """A fake robot to which every link connects.

    It counts as silent after a time in which even a busy machine lets its thread say something; tests of silence set
    `MAX_AGE` back.
    """
    robot = FakeRobot()
    monkeypatch.setattr(controller, "MAX_AGE", 8.0)
    monkeypatch.setattr(session, "Rosbridge", lambda address: robot)
    monkeypatch.setattr(session, "Guardian", FakeGuardian)
    yield robot
    robot.end()


@pytest.fixture
def env(robot):
    """An environment of that robot, in which nobody need say yes; commands of a Giraff are 0.0375 m/s at most."""
    env = rl.make_env("giraff_wander_simple", link=RobotLink(confirmed=True))
    yield env
    env.close()


MAX_AGE = controller.MAX_AGE
LEFT, RIGHT, AHEAD = 1, 2, 3  # actions of giraff_wander_simple; 0 is stop
V, OMEGA = (
    0.0375,
    round(0.075 / 0.46, 9),
)  # of wheels that turn at 0.5 rad/s, alike and against each other
FREE, NEAR = [1.0] * 8, [0.35] * 8  # 0.12 m from the rim of the robot
NOTHING = [math.inf] * 8
