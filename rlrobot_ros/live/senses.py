"""What a robot that is on says of itself: where it is, what its lasers see, how old that is."""

import threading
import time
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task
from rlrobot_ros.drive import check_view
from rlrobot_ros.live.latest import Latest
from rlrobot_ros.live.safety import look_ahead
from rlrobot_ros.messages import pose_of, stamp_of
from rlrobot_ros.odometry import pose_readings
from rlrobot_ros.scan import Mounting, beams_end, measured


class Sight(NamedTuple):
    """What a scan says.

    lasers: readings of those in view [m], NaN for one that is not known
    ahead: how far the nearest thing ahead is [m], NaN if that is not known; blind: why not, in words
    """

    lasers: dict[str, float]
    ahead: float
    blind: str


class Senses:
    """The newest odometry and scan. Messages come in other threads; `news` hears of each.

    chassis, mounting: of the robot, and of the scanner on it; odom, scan: names of the topics
    pose: readings x, y and theta by name; sight: of the lasers
    unreadable: how many messages say what cannot be, or too little; complaint: what is wrong with the last of them
    """

    def __init__(
        self, chassis: Chassis, mounting: Mounting, odom: str, scan: str
    ) -> None:
        self._chassis, self._mounting, self._names = chassis, mounting, (odom, scan)
        self.pose, self.sight = Latest[dict[str, float]](), Latest[Sight]()
        self.unreadable, self.complaint = 0, ""
        self._needed: set[str] = set()  # lasers
        self.news = threading.Condition()

    def hear_odometry(self, message: Any) -> None:
        """Take in a message of type Odometry."""
        self._take(
            self.pose,
            lambda odometry: pose_readings(*pose_of(odometry), self._chassis),
            message,
        )

    def hear_scan(self, message: Any) -> None:
        """Take in a message of type LaserScan."""
        self._take(self.sight, self._look, message)

    def _look(self, scan: Any) -> Sight:
        """What a scan says. Raises ValueError if that is too little; but what it shows ahead counts even so."""
        rays = measured(scan, self._mounting.far)
        lasers = beams_end(rays, rays.ranges, self._chassis, self._mounting)
        ahead, blind = look_ahead(rays, self._chassis, self._mounting)
        if unknown := [
            laser
            for laser in LASERS
            if laser in self._needed and not lasers.get(laser, np.nan) >= 0
        ]:
            if (before := self.sight.value) is not None:
                ahead = float(np.minimum(ahead, before.ahead))
                self.sight.value = Sight(before.lasers, ahead, blind or before.blind)
            raise ValueError(
                f"a scan of {len(rays.ranges)} rays in which nothing is known of {', '.join(unknown)}"
            )
        return Sight(lasers, ahead, blind)

    def _take(self, latest: Latest[Any], read: Any, message: Any) -> None:
        try:
            stamp, value = stamp_of(message), read(message)
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
            self._needed = set()

    def expect(self, task: Task) -> None:
        """From now on take in no scan in which one of the task's lasers is unknown, or one that is known now.

        Raises ValueError if the task needs a laser that the scanner cannot stand for.
        """
        assert self.sight.value is not None
        lasers, inputs = (
            self.sight.value.lasers,
            [variable.name for variable in task.inputs],
        )
        check_view(task, lasers)
        self._needed = {name for name in lasers if lasers[name] >= 0 or name in inputs}
        if np.isnan([lasers[name] for name in self._needed]).any():
            self.sight.forget()

    @property
    def readings(self) -> dict[str, float]:
        """What the robot's sensors say, by name. Both must have been heard."""
        assert self.sight.value is not None and self.pose.value is not None
        lasers = self.sight.value.lasers
        return {
            name: lasers[name] for name in lasers if name in self._needed
        } | self.pose.value

    @property
    def ahead(self) -> float:
        """How far the nearest thing ahead is [m]; NaN if not known."""
        return np.nan if self.sight.value is None else self.sight.value.ahead

    def problems(self, max_age: float) -> list[str]:
        """Why the robot cannot be driven, in words, where messages may be `max_age` old [s]."""
        said = []
        both: tuple[Latest[Any], ...] = (self.pose, self.sight)
        for latest, name in zip(both, self._names, strict=True):
            age = latest.age(time.monotonic())
            if latest.value is None:
                said.append(
                    f"nothing readable comes from the topic {name!r} ({latest.heard} messages so far)"
                )
            elif age > max_age:
                said.append(f"the last message of {name!r} is {age:.1f} s old")
        if self.sight.value is not None and self.sight.value.blind:
            said.append(
                f"{self.sight.value.blind}: is the scanner on, uncovered, and its mounting said right?"
            )
        if self.unreadable:
            said.append(
                f"the last of {self.unreadable} unreadable messages: {self.complaint}"
            )
        return said
