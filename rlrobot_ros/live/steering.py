"""Moving a robot for a while, told again and again how, and stopping it as soon as nothing is known of it."""

import math
import time
from typing import NamedTuple

from rlrobot_ros.live.connection import Connection
from rlrobot_ros.live.safety import within
from rlrobot_ros.live.senses import Senses
from rlrobot_ros.live.voice import Voice

PERIOD = 0.1  # a command is said again after so long [s]
MAX_AGE = 0.5  # of odometry and scan while the robot moves [s]
PATIENCE = 10.0  # how long a robot is waited for that is silent [s]
JUMP = 0.5  # [m]; a robot that stood still and is then as far away was carried, or started anew
INSTANT = 1e-3  # [s]


class Limits(NamedTuple):
    """What no motion exceeds: speed [m/s], turning [rad/s]; and the room ahead that forward motion needs [m]."""

    max_speed: float
    max_turn: float
    safety_distance: float


class Steering:
    """Moves one robot.

    simulated: whether time passes only with the robot's commands, and is what its messages say
    held_back: commands without their forward motion, since something was near
    pauses: how often the robot had to wait; why: the reason of the last time, in words
    """

    def __init__(
        self,
        connection: Connection,
        senses: Senses,
        voice: Voice,
        limits: Limits,
        simulated: bool,
    ) -> None:
        self._connection, self._senses, self._voice = connection, senses, voice
        self._limits, self._is_simulated = limits, simulated
        self.held_back = self.pauses = 0
        self.why = ""

    def drive(self, v: float, omega: float, seconds: float) -> None:
        """Drive at v [m/s] and turn at omega [rad/s] for a while; while the robot must wait, time does not count.

        Raises ConnectionError or TimeoutError as `wait` does; then the link has sent no stop.
        """
        v, omega = within(v, omega, *self._limits[:2])
        left = seconds
        while left > INSTANT:
            if not self._can_go():
                self.pauses += 1
                self.why = self._what_is_wrong()
            self.wait()
            begin, stamp = time.monotonic(), self._senses.pose.stamp
            is_near = (
                v > 0 and not self._senses.ahead >= self._limits.safety_distance
            )  # true for NaN, too
            self.held_back += is_near
            self._voice.say(0.0 if is_near else v, omega)
            if self._is_simulated:
                left -= self._wait_for_answer(stamp)
            else:
                time.sleep(
                    max(min(left, PERIOD, MAX_AGE - self._senses.age()), INSTANT)
                )
                left -= time.monotonic() - begin

    def wait(self) -> None:
        """Come back when the robot is heard and sees something; until then the link commands it to stop.

        Raises ConnectionError if the connection is lost, or if the robot is elsewhere then; TimeoutError if it takes
        too long.
        """
        if self._can_go():
            return
        here = self._senses.pose.value
        self._voice.stop()
        with self._senses.news:
            in_time = self._senses.news.wait_for(self._can_go, PATIENCE)
        if not in_time:
            raise TimeoutError(f"the robot was stopped, since {self._what_is_wrong()}")
        there = self._senses.pose.value
        if (
            here
            and there
            and math.hypot(there["x"] - here["x"], there["y"] - here["y"]) > JUMP
        ):
            raise ConnectionError(
                "the robot was silent, and its odometry then reported another place: it was carried or restarted; "
                "begin again with env.reset()"
            )

    def _can_go(self) -> bool:
        """Whether enough is known of the robot. Raises ConnectionError if the connection is lost."""
        self._check_connection()
        if self._is_simulated:
            return self._senses.pose.value is not None and not math.isnan(
                self._senses.ahead
            )
        return self._senses.age() <= MAX_AGE and not math.isnan(self._senses.ahead)

    def _wait_for_answer(self, before: float) -> float:
        """Wait until odometry and scan are newer than `before`; returns how much [s]."""
        with self._senses.news:
            in_time = self._senses.news.wait_for(
                lambda: self._is_newer(before), PATIENCE
            )
        if not in_time:
            raise TimeoutError(
                f"simulated time stood still; --simulated-time left out? {self._what_is_wrong()}"
            )
        return self._senses.pose.stamp - before

    def _is_newer(self, before: float) -> bool:
        self._check_connection()
        return min(self._senses.pose.stamp, self._senses.sight.stamp) > before

    def _check_connection(self) -> None:
        if self._connection.lost is not None:
            raise ConnectionError(
                f"{self._connection.lost}; env.reset() connects again"
            )

    def _what_is_wrong(self) -> str:
        problems = [*self._senses.problems(MAX_AGE), *self._connection.complaints]
        return "; ".join(problems) or "it was heard only now and then"
