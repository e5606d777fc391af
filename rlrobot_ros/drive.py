"""The messages of a drive as transitions of a task. No ROS is needed: here messages are numbers already."""

import math
from bisect import bisect_left
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from itertools import chain

from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task
from rlrobot_ros.clocks import Clocks
from rlrobot_ros.drive_report import DriveReport
from rlrobot_ros.motions import Motions
from rlrobot_ros.received import FARTHEST, SECOND, Drive, Track

SLACK = 0.1  # by which a step may be longer or shorter than the task's, as part of it
JUMP = 0.5  # [m]; where odometry is further away than a step can lead by so much, it has jumped
TAP = 0.2  # [s]; nobody presses a key and lets it go again within less
# A message is too old after so long [s], or after so many steps if that is longer
MAX_AGE = 0.5
MAX_STEPS = 1.5

# The readings at a time, as near and as far as they may be: empty if unknown
_Seen = list[dict[str, float]]
# A command in force: its action, or None; the times at which it came; the time at which it ends
_Hold = tuple[int | None, list[int], int]


def check_view(task: Task, seen: Collection[str], note: str = "") -> None:
    """Raises ValueError if `task` needs a laser that is not among those `seen`, which the scanner can replace.

    note: an addition to the message
    """
    inputs = [variable.name for variable in task.inputs if variable.name in LASERS]
    unseen = [laser for laser in inputs if laser not in seen]
    if unseen:
        others = [laser for laser in LASERS if laser in seen]
        raise ValueError(
            f"{task.name} needs {', '.join(unseen)}, where the scanner does not look or never measures anything{note}; "
            f"say how it is mounted, or choose a task that needs only {', '.join(others)}"
        )


def transitions_of(
    task: Task,
    drive: Drive,
    motions: Motions,
    names: Sequence[str],
) -> tuple[Transitions, DriveReport]:
    """The steps of `task` that the drive holds, and a report; names: of the topics of pose, scan and twist.

    A step begins when its command comes, or where the one before has ended while its action is still in force. It ends
    after the task's `step_time`, or within a tenth of that when the next command comes. Its readings are the latest. If
    these are unknown, no older ones take their place: the step is dropped. If rays that measured nothing leave open
    what a laser reads, the step counts only if its states and its reward are the same either way. A step in which a
    clock was set is dropped. A step that does not begin where the one before has ended begins a new episode.

    Raises ValueError if there is no step, or if the task needs a laser that the scanner cannot stand for.
    """
    age = round(max(MAX_AGE, MAX_STEPS * task.step_time) * SECOND)
    times_of = (drive.poses.times, drive.scans.times, drive.twists.times)
    received = dict(zip(names, times_of, strict=True))
    for what, times in received.items():
        unreadable, fault = drive.faults.get(what, (0, "there is none at all"))
        if unreadable == len(times):
            raise ValueError(
                f"there is no readable message of {what} among {len(times)}: {fault}"
            )
    lasers = _lasers_of(task, drive)
    counts: Counter[str] = Counter()
    actions: list[int | None] = []
    unexplained: Counter[tuple[float, float]] = Counter()
    for v, aside, omega in drive.twists.values:
        action = motions.action(v, omega, aside)
        actions.append(action)
        if action is None:
            unexplained[round(v, 2), round(omega, 2)] += 1
    clocks = Clocks(drive, task, motions.max_speed)
    jump = JUMP + 2 * motions.max_speed * task.step_time
    rows: list[list[float]] = []
    since = 0  # steps since the episode began
    at_goal = 0  # steps at the goal without a break
    before_end = -1
    for begin, end, a in _spans(task, _holds(drive, actions, age), counts):
        before = _readings(drive, begin, age, lasers)
        after = _readings(drive, end, age, lasers)
        if before is None or after is None:
            counts["stale"] += 1
            continue
        step = _step(task, before, after, jump)
        if step != "jumps" and not clocks.agree(begin, end):
            step = "disordered"
        if isinstance(step, str):
            counts[step] += 1
            continue
        if begin != before_end:
            if rows:
                rows[-1][-1] = not rows[-1][-2]
            counts["stretches"] += 1
            since = 0
            at_goal = 0
        s, r, s_next, is_there = step
        since += 1
        before_end = end
        at_goal = at_goal + 1 if is_there else 0
        terminated = at_goal >= task.goal_steps
        truncated = not terminated and since == task.episode_steps
        rows.append([s, a, r, s_next, terminated, truncated])
        if terminated or truncated:
            since = 0
            at_goal = 0
    begin_of_drive = min(times[0] for times in received.values())
    end_of_drive = max(times[-1] for times in received.values())
    report = DriveReport(
        task=task.name,
        duration=(end_of_drive - begin_of_drive) / SECOND,
        messages={topic: len(times) for topic, times in received.items()},
        faults=drive.faults,
        steps=len(rows),
        stretches=counts["stretches"],
        unexplained=unexplained,
        motions=motions.distinct,
        to_and_fro=_to_and_fro(drive.twists, min(TAP, task.step_time / 2)),
        cut_short=counts["cut"],
        stale=counts["stale"],
        unknown=counts["unknown"],
        jumps=counts["jumps"],
        disordered=counts["disordered"],
        rays=drive.rays,
        lost=drive.lost,
        partial=sum(not lasers <= scan.keys() for scan in drive.scans.values),
        missing=tuple(laser for laser in LASERS if laser not in lasers),
    )
    if not rows:
        raise ValueError(f"it holds no step of {task.name}: {report.why_empty()}")
    return Transitions.of_rows(rows), report


def _to_and_fro(twists: Track[tuple[float, float, float]], shortest: float) -> int:
    """How many commands last less than `shortest` [s] between two others that are alike."""
    changes = [
        i
        for i, twist in enumerate(twists.values)
        if i == 0 or twist != twists.values[i - 1]
    ]
    count = 0
    for before, here, after in zip(changes, changes[1:], changes[2:], strict=False):
        is_between = twists.values[before] == twists.values[after]
        if is_between and twists.times[after] - twists.times[here] < shortest * SECOND:
            count += 1
    return count


def _lasers_of(task: Task, drive: Drive) -> set[str]:
    """The lasers that count: those of the task's inputs, and those that most scans show."""
    known = Counter(chain.from_iterable(drive.scans.values))
    check_view(task, known, f" ({drive.lost} of all its {drive.rays} rays)")
    inputs = [variable.name for variable in task.inputs]
    half = len(drive.scans.values) / 2
    lasers = set()
    for laser in LASERS:
        least = 0 if laser in inputs else half
        if known[laser] > least:
            lasers.add(laser)
    return lasers


def _readings(drive: Drive, time: int, age: int, lasers: set[str]) -> _Seen | None:
    """The latest readings of the robot's sensors; None if they are too old."""
    pose = drive.poses.at(time, age)
    scan = drive.scans.at(time, age)
    if pose is None or scan is None:
        return None
    if not pose or not lasers <= scan.keys():
        return []
    names = [name for name in scan if name in lasers]
    near = {name: scan[name] for name in names}
    far = {name: scan.get(f"{FARTHEST}{name}", scan[name]) for name in names}
    return [near | pose, far | pose]


def _step(
    task: Task, before: _Seen, after: _Seen, jump: float
) -> tuple[int, float, int, bool] | str:
    """State, reward, next state, and whether that is the goal; or the reason why the step does not count.

    before, after: as `_readings` gives them; jump: no step is as long as that [m]
    """
    steps = set()
    for here, there in zip(before, after, strict=False):
        if math.hypot(there["x"] - here["x"], there["y"] - here["y"]) > jump:
            return "jumps"
        s = task.states.encode(here)
        s_next = task.states.encode(there)
        r = task.reward_for(here, there)
        steps.add((s, r, s_next, task.at_goal(there)))
    return steps.pop() if len(steps) == 1 else "unknown"


def _holds(drive: Drive, actions: list[int | None], age: int) -> Iterator[_Hold]:
    """The commands in force, one after the other. A command holds until the next one comes or it is too old."""
    times = drive.twists.times
    end_of_drive = max(drive.poses.times[-1], drive.scans.times[-1])
    held: list[int] = []
    for i, time in enumerate(times):
        held.append(time)
        is_last = i + 1 == len(times)
        following = end_of_drive if is_last else times[i + 1]
        is_repeated = not is_last and actions[i + 1] == actions[i]
        if not is_repeated or following - time > age:
            yield actions[i], held, min(time + age, following)
            held = []


def _nearest(times: list[int], due: int) -> int:
    """The one of `times`, which increase, that is nearest to `due`; the earlier one of two."""
    i = bisect_left(times, due)
    neighbours = times[max(i - 1, 0) : i + 1]
    return min(neighbours, key=lambda time: abs(time - due))


def _spans(
    task: Task, holds: Iterator[_Hold], counts: Counter[str]
) -> Iterator[tuple[int, int, int]]:
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
                nearest = _nearest(times, due)
                if abs(nearest - due) <= slack:
                    due = nearest
            else:
                due = end
            yield begin, due, action
            begin = due
