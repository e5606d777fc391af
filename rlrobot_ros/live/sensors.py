"""The sensors of a real robot: where it is, what its lasers see, and how old that is."""

import threading
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.task import Task
from rlrobot_ros.drive import check_view
from rlrobot_ros.live.latest_message import LatestMessage
from rlrobot_ros.live.safety import look_ahead
from rlrobot_ros.messages import pose_of, stamp_of
from rlrobot_ros.odometry import pose_readings
from rlrobot_ros.scan import Mounting, beams_end, measured


class Sight(NamedTuple):
    """The content of a scan.

    lasers: readings of those in view [m], NaN for one that is not known
    room: how far the nearest thing ahead is [m], NaN if that is not known; blind: why not, in words
    """

    lasers: dict[str, float]
    room: float
    blind: str


class Sensors:
    """The newest odometry and scan. Messages come in other threads; `changed` is notified of each.

    chassis, mounting: of the robot, and of the scanner on it; odom, scan: names of the topics
    pose: readings x, y and theta by name; sight: of the lasers
    unreadable: how many messages are impossible or incomplete; complaint: what is wrong with the last of them
    """

    def __init__(
        self, chassis: Chassis, mounting: Mounting, odom: str, scan: str
    ) -> None:
        self._chassis = chassis
        self._mounting = mounting
        self.pose = LatestMessage[dict[str, float]]()
        self.sight = LatestMessage[Sight]()
        self._topics: dict[str, LatestMessage[Any]] = {
            odom: self.pose,
            scan: self.sight,
        }
        self.unreadable = 0
        self.complaint = ""
        self._needed: set[str] = set()  # lasers
        self.changed = threading.Condition()

    def receive_odometry(self, message: Any) -> None:
        """Take in a message of type Odometry."""
        self._receive(self.pose, self._locate, message)

    def receive_scan(self, message: Any) -> None:
        """Take in a message of type LaserScan."""
        self._receive(self.sight, self._look, message)

    def _receive(
        self, latest: LatestMessage[Any], read: Callable[[Any], Any], message: Any
    ) -> None:
        try:
            stamp = stamp_of(message)
            value = read(message)
        except ValueError as error:
            with self.changed:
                self.unreadable += 1
                self.complaint = str(error)
            return
        with self.changed:
            latest.take(stamp, value, time.monotonic())
            self.changed.notify_all()

    def _locate(self, odometry: Any) -> dict[str, float]:
        return pose_readings(*pose_of(odometry), self._chassis)

    def _look(self, scan: Any) -> Sight:
        """The content of a scan. Raises ValueError if a laser is missing; but what it shows ahead counts even then."""
        rays = measured(scan, self._mounting.far)
        lasers = beams_end(rays, rays.ranges, self._chassis, self._mounting)
        room, blind = look_ahead(rays, self._chassis, self._mounting)
        unknown = [
            laser for laser in self._needed if not lasers.get(laser, np.nan) >= 0
        ]
        if unknown:
            before = self.sight.value
            if before is not None:
                nearest = float(np.minimum(room, before.room))
                self.sight.value = Sight(before.lasers, nearest, blind or before.blind)
            raise ValueError(
                f"a scan of {len(rays.ranges)} rays in which nothing is known of {', '.join(sorted(unknown))}"
            )
        return Sight(lasers, room, blind)

    def age(self) -> float:
        """How old the older of the two is [s]; infinity if one is missing."""
        now = time.monotonic()
        return max(self.pose.age(now), self.sight.age(now))

    def forget(self) -> None:
        """Count nothing that was received before as new."""
        with self.changed:
            self.pose.forget()
            self.sight.forget()
            self._needed = set()

    def expect(self, task: Task) -> None:
        """From now on take in no scan in which one of the task's lasers is unknown, or one that is known now.

        Raises ValueError if the task needs a laser that the scanner cannot stand for.
        """
        assert self.sight.value is not None
        lasers = self.sight.value.lasers
        check_view(task, lasers)
        inputs = [variable.name for variable in task.inputs]
        self._needed = {name for name in lasers if lasers[name] >= 0 or name in inputs}
        if np.isnan([lasers[name] for name in self._needed]).any():
            self.sight.forget()

    @property
    def readings(self) -> dict[str, float]:
        """The robot's readings, by name. Odometry and a scan must have been received."""
        assert self.sight.value is not None and self.pose.value is not None
        lasers = self.sight.value.lasers
        seen = {name: lasers[name] for name in lasers if name in self._needed}
        return seen | self.pose.value

    @property
    def room(self) -> float:
        """How far the nearest thing ahead is [m]; NaN if not known."""
        return np.nan if self.sight.value is None else self.sight.value.room

    def problems(self, max_age: float) -> list[str]:
        """Why the robot cannot be driven, in words, if messages may be `max_age` old [s]."""
        problems = []
        for topic, latest in self._topics.items():
            age = latest.age(time.monotonic())
            if latest.value is None:
                problems.append(
                    f"nothing readable comes from the topic {topic!r} ({latest.received} messages so far)"
                )
            elif age > max_age:
                late = f"the last message of {topic!r} is {age:.1f} s old"
                if latest.in_a_row > 1:
                    late += (
                        f", and by their times the {latest.in_a_row} after it are older: was the robot's clock set "
                        "back? Then begin again with env.reset()"
                    )
                problems.append(late)
        if self.sight.value is not None and self.sight.value.blind:
            problems.append(
                f"{self.sight.value.blind}: is the scanner on, uncovered, and its mounting said right?"
            )
        if self.unreadable:
            problems.append(
                f"the last of {self.unreadable} unreadable messages: {self.complaint}"
            )
        return problems
