"""Driving a robot for some time: its command is repeated, and it is stopped as soon as too little is known of it."""

import math
import time
from typing import NamedTuple

from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.safety import MAX_AGE, stopping_distance, within
from rlrobot_ros.live.sensors import Sensors
from rlrobot_ros.live.velocity_publisher import VelocityPublisher

PERIOD = 0.1  # a command is repeated after so long [s]
PATIENCE = 10.0  # how long we wait for a silent robot [s]
JUMP = 0.5  # [m]; a robot that stood still and is then as far away was carried, or started anew
INSTANT = 1e-3  # [s]


class Limits(NamedTuple):
    """Limits of every motion: speed [m/s], turning [rad/s]; and the least room ahead for forward motion [m]."""

    max_speed: float
    max_turn: float
    safety_distance: float


class Controller:
    """Moves one robot.

    simulated_time: whether time passes only with the robot's commands, and is that of its messages
    held_back: commands without their forward motion, because something was near
    pauses: how often the robot had to wait; why: the reason of the last pause, in words
    """

    def __init__(
        self,
        connection: Rosbridge,
        sensors: Sensors,
        velocity: VelocityPublisher,
        limits: Limits,
        simulated_time: bool,
    ) -> None:
        self._connection = connection
        self._sensors = sensors
        self._velocity = velocity
        self._limits = limits
        self._simulated_time = simulated_time
        self.held_back = 0
        self.pauses = 0
        self.why = ""

    def drive(self, v: float, omega: float, seconds: float) -> None:
        """Drive at v [m/s] and turn at omega [rad/s] for some time; waiting time does not count.

        Raises ConnectionError or TimeoutError as `wait` does; then no stop has been sent.
        """
        limits = self._limits
        v, omega = within(v, omega, limits.max_speed, limits.max_turn)
        needed = max(limits.safety_distance, stopping_distance(max(v, 0.0)))
        left = seconds
        while left > INSTANT:
            if not self._can_go():
                self.pauses += 1
                self.why = self._what_is_wrong()
            self.wait()
            begin = time.monotonic()
            stamp = self._sensors.pose.stamp
            # true for NaN, too
            is_near = not self._sensors.room >= needed
            if v > 0 and is_near:
                self.held_back += 1
                self._velocity.publish(0.0, omega)
            else:
                self._velocity.publish(v, omega)
            if self._simulated_time:
                left -= self._wait_for_answer(stamp)
            else:
                known_for = MAX_AGE - self._sensors.age()
                time.sleep(max(min(left, PERIOD, known_for), INSTANT))
                left -= time.monotonic() - begin

    def wait(self) -> None:
        """Return when messages of the robot arrive and its scanner measures something; stop it until then.

        Raises ConnectionError if the connection is lost, or if the robot is in another place then; TimeoutError if it
        takes too long.
        """
        if self._can_go():
            return
        before = self._sensors.pose.value
        self._velocity.stop()
        with self._sensors.changed:
            in_time = self._sensors.changed.wait_for(self._can_go, PATIENCE)
        if not in_time:
            raise TimeoutError(f"the robot was stopped, since {self._what_is_wrong()}")
        after = self._sensors.pose.value
        if before is None or after is None:
            return
        if math.hypot(after["x"] - before["x"], after["y"] - before["y"]) > JUMP:
            raise ConnectionError(
                "the robot was silent, and its odometry then reported another place: it was carried or restarted; "
                "begin again with env.reset()"
            )

    def _can_go(self) -> bool:
        """Whether enough is known of the robot. Raises ConnectionError if the connection is lost."""
        self._check_connection()
        if math.isnan(self._sensors.room):
            return False
        if self._simulated_time:
            return self._sensors.pose.value is not None
        return self._sensors.age() <= MAX_AGE

    def _wait_for_answer(self, before: float) -> float:
        """Wait until odometry and scan are newer than `before`; returns how much [s]."""
        sensors = self._sensors

        def is_newer() -> bool:
            self._check_connection()
            return min(sensors.pose.stamp, sensors.sight.stamp) > before

        with sensors.changed:
            in_time = sensors.changed.wait_for(is_newer, PATIENCE)
        if not in_time:
            raise TimeoutError(
                f"simulated time stood still; --simulated-time left out? {self._what_is_wrong()}"
            )
        return sensors.pose.stamp - before

    def _check_connection(self) -> None:
        if self._connection.lost is not None:
            raise ConnectionError(
                f"{self._connection.lost}; env.reset() connects again"
            )

    def _what_is_wrong(self) -> str:
        problems = [*self._sensors.problems(MAX_AGE), *self._connection.errors]
        return "; ".join(problems) or "it was heard only now and then"
