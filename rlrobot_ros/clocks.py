"""Whether the times of a drive's messages can be trusted: a clock may have been set while they were recorded."""

import math
from bisect import bisect_left, bisect_right
from itertools import chain, pairwise

from rlrobot_edu.task.task import Task
from rlrobot_ros.received import SECOND, Drive

# [steps]; where the clocks disagree by more about a step's time, one of them was set. Messages are delayed by less.
CLOCK_ERROR = 0.5
# Within three steps, the noise of odometry adds less to its way [m], if we leave out so many parts of it as wrong
NOISE = 0.5
WRONG = 4


class Clocks:
    """The clocks of the recorder and of those that sent its messages.

    max_speed: the largest speed of the task [m/s]
    """

    def __init__(self, drive: Drive, task: Task, max_speed: float) -> None:
        self._drive = drive
        self._step = round(task.step_time * SECOND)
        # three steps at twice the largest speed
        self._longest_detour = NOISE + 6 * max_speed * task.step_time
        # Spans in which messages were not received in the order in which they were sent: apart, in order of time.
        self._begins: list[int] = []
        self._ends: list[int] = []
        tracks = (drive.poses, drive.scans, drive.twists)
        for begin, end in sorted(chain.from_iterable(t.disorder() for t in tracks)):
            if self._ends and begin <= self._ends[-1]:
                self._ends[-1] = max(self._ends[-1], end)
            else:
                self._begins.append(begin)
                self._ends.append(end)

    def agree(self, begin: int, end: int) -> bool:
        """Whether the latest readings at `begin` and `end` [ns] are a step apart. There must be such readings."""
        received = []
        for track in (self._drive.poses, self._drive.scans):
            first = track.latest(begin)
            last = track.latest(end)
            received.append(track.times[first])
            if track.stamps[first] and track.stamps[last]:
                sent = track.stamps[last] - track.stamps[first]
                error = track.times[last] - track.times[first] - sent
                if abs(error) > CLOCK_ERROR * self._step:
                    return False
        if self._is_disordered(min(received), end):
            return False
        # If all clocks were set back, two stretches of time were received as one, and odometry goes to and fro.
        detour = self._detour(begin - self._step, end + self._step)
        return detour <= self._longest_detour

    def _is_disordered(self, begin: int, end: int) -> bool:
        """Whether a span of disorder has a moment in common with this one."""
        i = bisect_right(self._begins, end) - 1
        return i >= 0 and self._ends[i] >= begin

    def _detour(self, begin: int, end: int) -> float:
        """By how much odometry's way in a span of time, without its longest parts, exceeds the straight line [m]."""
        poses = self._drive.poses
        places = []
        first = bisect_left(poses.times, begin)
        last = bisect_right(poses.times, end)
        for pose in poses.values[first:last]:
            if pose:  # readable
                places.append((pose["x"], pose["y"]))
        if not places:
            return 0.0
        parts = [math.dist(here, there) for here, there in pairwise(places)]
        return sum(sorted(parts)[:-WRONG]) - math.dist(places[0], places[-1])
