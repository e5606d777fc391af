"""What was received in a drive: messages as numbers, in order of time."""

import math
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Generic, TypeVar

from rlrobot_edu.robots.chassis import Chassis
from rlrobot_ros.scan import Mounting, Rays, beams_end

SECOND = 10**9  # [ns]
FARTHEST = "farthest "  # before a laser's name: as far as rays that measured nothing let it see

T = TypeVar("T")
Span = tuple[int, int]  # of time: its beginning and its end [ns], which belong to it


@dataclass
class Track(Generic[T]):
    """The messages of a topic, in the order in which they were received.

    nothing: the value of an impossible message
    times: when they were received, by the recorder's clock [ns]; they never decrease
    values: their contents
    stamps: when they were sent, by the sender's clock [ns]; 0 if they do not say
    set_back: spans of time by the recorder's clock [ns] that it ran through twice, since it was set back
    """

    nothing: T
    times: list[int] = field(default_factory=list)
    values: list[T] = field(default_factory=list)
    stamps: list[int] = field(default_factory=list)
    set_back: list[Span] = field(default_factory=list)

    def add(self, time: int, value: T, stamp: int = 0) -> None:
        """Keep one more message."""
        if self.times and time < self.times[-1]:
            self.set_back.append((time, self.times[-1]))
        place = bisect_right(self.times, time)
        self.times.insert(place, time)
        self.values.insert(place, value)
        self.stamps.insert(place, stamp)

    def latest(self, time: int) -> int:
        """Number of the latest message at `time`, −1 if there is none yet."""
        return bisect_right(self.times, time) - 1

    def at(self, time: int, max_age: int) -> T | None:
        """The latest value at `time`, None if it was more than `max_age` old [ns]."""
        i = self.latest(time)
        if i < 0 or time - self.times[i] > max_age:
            return None
        return self.values[i]

    def disorder(self) -> Iterator[Span]:
        """Spans of time [ns] in which messages were not received in the order in which they were sent."""
        yield from self.set_back
        stamped = [i for i, stamp in enumerate(self.stamps) if stamp]
        for i, j in pairwise(stamped):
            if self.stamps[j] < self.stamps[i]:
                yield self.times[i], self.times[j]


@dataclass
class Drive:
    """A drive as it was received.

    poses, scans: readings by name; "farthest laser_front" besides, where rays that measured nothing leave open how far
        it sees
    twists: speed ahead and aside [m/s], turning to the left [rad/s]
    rays, lost: the rays of all scans, and how many of them measured nothing
    faults: how many messages have impossible values, and what is wrong with the last of them, by topic
    """

    poses: Track[dict[str, float]] = field(default_factory=lambda: Track({}))
    scans: Track[dict[str, float]] = field(default_factory=lambda: Track({}))
    twists: Track[tuple[float, float, float]] = field(
        default_factory=lambda: Track((math.nan,) * 3)
    )
    rays: int = 0
    lost: int = 0
    faults: dict[str, tuple[int, str]] = field(default_factory=dict)

    def add_fault(self, topic: str, fault: str) -> None:
        """Count one more message with impossible values."""
        before, _ = self.faults.get(topic, (0, ""))
        self.faults[topic] = (before + 1, fault)

    def lasers_in(
        self, rays: Rays, chassis: Chassis, mounting: Mounting
    ) -> dict[str, float]:
        """The readings of the lasers that are known in a scan; its rays are counted."""
        self.rays += len(rays.known)
        self.lost += int((~rays.known).sum())
        near = beams_end(rays, rays.ranges, chassis, mounting)
        far = beams_end(rays, rays.farthest, chassis, mounting)
        readings = {}
        for laser in near:
            if near[laser] >= 0 and far[laser] >= 0:  # false for NaN
                readings[laser] = near[laser]
                readings[f"{FARTHEST}{laser}"] = far[laser]
        return readings
