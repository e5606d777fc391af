"""What a robot that is on says of itself: where it is, what its lasers see, how old that is."""

import math
import threading
import time
from typing import Any, NamedTuple

from rlrobot_edu.robots.mobile_base import Chassis
from rlrobot_edu.ros.live.latest import Latest
from rlrobot_edu.ros.live.safety import room_ahead
from rlrobot_edu.ros.messages import pose_of, stamp_of
from rlrobot_edu.ros.odometry import pose_readings
from rlrobot_edu.ros.scan import Mounting, laser_readings


class Sight(NamedTuple):
    """What a scan says: the lasers' readings [m], and how far the nearest thing ahead is [m], NaN if not known."""

    lasers: dict[str, float]
    ahead: float


class Senses:
    """The newest odometry and scan. Messages come in other threads; `news` is told of each.

    chassis, mounting: of the robot, and of the scanner on it; odom, scan: names of the topics
    pose: readings x, y and theta by name; sight: of the lasers
    unreadable: how many messages say nothing that can be; complaint: what is wrong with the last of them
    """

    def __init__(self, chassis: Chassis, mounting: Mounting, odom: str, scan: str) -> None:
        self._chassis, self._mounting, self._names = chassis, mounting, (odom, scan)
        self.pose, self.sight = Latest[dict[str, float]](), Latest[Sight]()
        self.unreadable, self.complaint = 0, ""
        self.news = threading.Condition()

    def hear_odometry(self, message: Any) -> None:
        """Take in a message of type Odometry."""
        self._take(self.pose, lambda: pose_readings(*pose_of(message), self._chassis), message)

    def hear_scan(self, message: Any) -> None:
        """Take in a message of type LaserScan."""
        self._take(
            self.sight,
            lambda: Sight(
                laser_readings(message, self._chassis, self._mounting),
                room_ahead(message, self._chassis, self._mounting),
            ),
            message,
        )

    def _take(self, latest: Latest[Any], read: Any, message: Any) -> None:
        try:
            stamp, value = stamp_of(message), read()
        except ValueError as error:
            with self.news:
                self.unreadable += 1
                self.complaint = str(error)
            return
        with self.news:
            latest.take(stamp, value, time.monotonic())
            self.news.notify_all()

    def age(self) -> float:
        """How old the older of the two is [s]; infinity if one is missing."""
        now = time.monotonic()
        return max(self.pose.age(now), self.sight.age(now))

    def forget(self) -> None:
        """Count nothing that was heard before as new."""
        with self.news:
            self.pose.forget()
            self.sight.forget()

    @property
    def readings(self) -> dict[str, float]:
        """What the robot's sensors say, by name. Both must have been heard."""
        assert self.sight.value is not None and self.pose.value is not None
        return self.sight.value.lasers | self.pose.value

    @property
    def ahead(self) -> float:
        """How far the nearest thing ahead is [m]; NaN if not known."""
        return math.nan if self.sight.value is None else self.sight.value.ahead

    def problems(self, max_age: float) -> list[str]:
        """Why the robot cannot be driven, in words, where messages may be `max_age` old [s]."""
        said = []
        both: tuple[Latest[Any], ...] = (self.pose, self.sight)
        for latest, name in zip(both, self._names, strict=True):
            age = latest.age(time.monotonic())
            if latest.value is None:
                said.append(f"nothing readable comes from the topic {name!r} ({latest.heard} messages so far)")
            elif age > max_age:
                said.append(f"the last message of {name!r} is {age:.1f} s old")
            elif latest is self.sight and math.isnan(self.ahead):
                said.append("the scan shows nothing ahead: is the scanner on, uncovered, and its mounting said right?")
        if self.unreadable:
            said.append(f"the last of {self.unreadable} unreadable messages: {self.complaint}")
        return said
