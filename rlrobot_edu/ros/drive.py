"""What was received in a drive as transitions of a task. No ROS is needed: messages are numbers here already."""

import math
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby, pairwise
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.ros.motions import Motions
from rlrobot_edu.ros.report import DriveReport
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task

SECOND = 10**9  # [ns]
SLACK = 0.1  # by which a step may be longer or shorter than the task's, as part of it
PATIENCE = 0.5, 1.5  # a message is too old after so long [s], or after so many steps if that is longer

T = TypeVar("T")


@dataclass
class Track(Generic[T]):
    """What came over a topic: times [ns], none before the one before, and values."""

    times: list[int] = field(default_factory=list)
    values: list[T] = field(default_factory=list)

    def add(self, time: int, value: T) -> None:
        """Keep one more message."""
        self.times.append(time)
        self.values.append(value)

    def at(self, time: int, max_age: int) -> T | None:
        """The latest value at `time`, None if it was more than `max_age` old [ns]."""
        i = bisect_right(self.times, time) - 1
        return self.values[i] if i >= 0 and time - self.times[i] <= max_age else None


@dataclass
class Drive:
    """A drive as it was received.

    poses, scans: readings by name; twists: speed ahead and aside [m/s], turning to the left [rad/s]
    """

    poses: Track[dict[str, float]] = field(default_factory=Track)
    scans: Track[dict[str, float]] = field(default_factory=Track)
    twists: Track[tuple[float, float, float]] = field(default_factory=Track)
    unreadable: int = 0


class _Hold(NamedTuple):
    """An action in force: since when, until when, and when it was said again meanwhile [ns]; None is no action."""

    action: int | None
    times: list[int]
    end: int


def patience(task: Task) -> float:
    """Age at which a message is too old for `task`, unless one says otherwise [s]."""
    return max(PATIENCE[0], PATIENCE[1] * task.step_time)


def check_view(task: Task, seen: Collection[str]) -> None:
    """Raises ValueError if `task` needs a laser that the scanner, which stands for those `seen`, cannot stand for."""
    if unseen := [v.name for v in task.inputs if v.name in LASERS and v.name not in seen]:
        raise ValueError(
            f"{task.name} needs {', '.join(unseen)}, where the scanner does not look; say how it is mounted, or choose "
            "a task that needs only " + ", ".join(laser for laser in LASERS if laser in seen)
        )


def transitions_of(
    task: Task, drive: Drive, motions: Motions, max_age: float | None, names: Sequence[str]
) -> tuple[Transitions, DriveReport]:
    """The steps of `task` that the drive holds, and a report; names: of the topics of pose, scan and twist.

    A step begins when its command comes, or where the one before has ended while its action is still in force. It ends
    after the task's `step_time`, or within a tenth of that when the next command comes. Its readings are the latest.
    A step that does not begin where the one before has ended begins a new episode.

    Raises ValueError if there is no step, or if the task needs a laser that the scanner cannot stand for.
    """
    given = patience(task) if max_age is None else max_age
    if not 0 < given < math.inf:
        raise ValueError(f"max_age must be a positive number of seconds, got {max_age!r:.200}")
    age, times = round(given * SECOND), (drive.poses.times, drive.scans.times, drive.twists.times)
    for received, what in zip(times, names, strict=True):
        if not received:
            raise ValueError(f"there is no readable message of {what}")
    seen = set.intersection(*map(set, drive.scans.values))
    check_view(task, seen)
    missing = tuple(laser for laser in LASERS if laser not in seen)
    counts: Counter[str] = Counter()
    actions = [motions.action(v, omega, aside) for v, aside, omega in drive.twists.values]
    unexplained = Counter(
        (round(v, 2), round(omega, 2))
        for (v, _, omega), a in zip(drive.twists.values, actions, strict=True)
        if a is None
    )
    rows: list[list[float]] = []
    since, at_goal, before_end = 0, 0, -1
    for begin, end, a in _spans(task, _holds(drive, actions, age, counts), counts):
        before, after = (_readings(drive, time, age) for time in (begin, end))
        if before is None or after is None:
            counts["stale"] += 1
            continue
        if begin != before_end:
            if rows:
                rows[-1][-1] = not rows[-1][-2]
            counts["stretches"] += 1
            since = at_goal = 0
        r, since, before_end = task.reward_for(before, after), since + 1, end
        at_goal = at_goal + 1 if task.at_goal(after) else 0
        terminated = at_goal >= task.goal_steps
        truncated = not terminated and since == task.episode_steps
        rows.append([task.states.encode(before), a, r, task.states.encode(after), terminated, truncated])
        if terminated or truncated:
            since = at_goal = 0
    duration = max(received[-1] for received in times) - min(received[0] for received in times)
    report = DriveReport(
        task.name, duration / SECOND, dict(zip(names, map(len, times), strict=True)), len(rows), counts["stretches"],
        unexplained, counts["cut"], counts["stale"], counts["silences"], drive.unreadable, missing,
    )  # fmt: skip
    if not rows:
        raise ValueError(f"it holds no step of {task.name}: {report.in_short()}")
    return Transitions(*map(np.array, zip(*rows, strict=True))), report


def _readings(drive: Drive, time: int, age: int) -> dict[str, float] | None:
    """What the robot's sensors said last; None if that is too old."""
    pose, scan = drive.poses.at(time, age), drive.scans.at(time, age)
    return None if pose is None or scan is None else scan | pose


def _holds(drive: Drive, actions: list[int | None], age: int, counts: Counter[str]) -> Iterator[_Hold]:
    """Which action was in force when. A command holds until the next one comes or it is too old."""
    times, last = drive.twists.times, max(drive.poses.times[-1], drive.scans.times[-1])
    silent = [after - before > age for before, after in pairwise(times)]
    counts["silences"] = sum(silent)
    piece = np.cumsum([0, *silent]).tolist()
    for _, group in groupby(range(len(times)), key=lambda i: (piece[i], actions[i])):
        held = list(group)
        i, upto = held[-1], times[held[-1]] + age
        end = min(upto, times[i + 1] if i + 1 < len(times) else last)
        yield _Hold(actions[i], [times[j] for j in held], end)


def _spans(task: Task, holds: Iterator[_Hold], counts: Counter[str]) -> Iterator[tuple[int, int, int]]:
    """Beginning and end [ns], and action, of each step that one action fills."""
    step = round(task.step_time * SECOND)
    slack = round(SLACK * step)
    for action, times, end in holds:
        begin = times[0]
        while action is not None and begin < end:
            due = begin + step
            if due > end + slack:
                counts["cut"] += 1
                break
            if due < end - slack:
                i = bisect_left(times, due)
                said = min(times[max(i - 1, 0) : i + 1], key=lambda time: abs(time - due))
                due = said if abs(said - due) <= slack else due
            else:
                due = end
            yield begin, due, action
            begin = due
