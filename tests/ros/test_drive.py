"""What was received in a drive becomes steps, whenever it came. Nothing here needs rosbags."""

from collections import Counter

from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_ros.drive import SECOND, Drive, _holds, _spans, transitions_of
from rlrobot_ros.motions import Motions

TASK = rl.load_task("giraff_wander_simple")
MOTIONS = Motions(TASK, 0.1)
TWISTS = [
    (0.0, 0.0, 0.0),
    (0.0375, 0.0, 0.0),
    (0.0, 0.0, 0.163),
    (0.3, 0.0, 0.0),
]  # the last is no action
pauses = st.integers(0, 2 * SECOND)
TOLD = st.lists(st.tuples(pauses, st.sampled_from(TWISTS)), min_size=1, max_size=30)
SEEN = st.lists(st.tuples(pauses, st.floats(0.1, 5.0)), min_size=1, max_size=30)


def received(told, poses, scans) -> Drive:
    drive = Drive()
    values = (
        (drive.twists, told, lambda twist: twist),
        (drive.poses, poses, lambda x: {"x": x, "y": 0.0, "theta": 0.0}),
        (drive.scans, scans, lambda x: dict.fromkeys(LASERS, x)),
    )
    for track, messages, value in values:
        time = 0
        for pause, content in messages:
            time += pause
            track.add(time, value(content))
    return drive


@settings(max_examples=150, deadline=None)
@given(TOLD, SEEN, SEEN)
def test_steps_last_as_long_as_the_tasks_do_not_overlap_and_are_filled_by_their_action(
    told, poses, scans
):
    drive = received(told, poses, scans)
    actions = [
        MOTIONS.action(v, omega, aside) for v, aside, omega in drive.twists.values
    ]
    age, counts, before = round(1.5 * SECOND), Counter(), -1
    for begin, end, a in _spans(TASK, _holds(drive, actions, age), counts):
        assert 0.9 * SECOND <= end - begin <= 1.1 * SECOND and begin >= before
        before = end
        in_force = [
            b
            for time, b in zip(drive.twists.times, actions, strict=True)
            if begin < time < end
        ]
        latest = max(i for i, time in enumerate(drive.twists.times) if time <= begin)
        assert set(in_force) <= {a} and actions[latest] == a


@settings(max_examples=150, deadline=None)
@given(TOLD, SEEN, SEEN)
def test_whenever_messages_come_there_are_steps_or_one_sentence_and_all_is_counted(
    told, poses, scans
):
    drive = received(told, poses, scans)
    try:
        transitions, report = transitions_of(
            TASK, drive, MOTIONS, ("odom", "scan", "cmd_vel")
        )
    except ValueError as error:
        assert "holds no step" in str(error)
        return
    assert report.steps == len(transitions.s) >= report.stretches >= 1
    assert report.stretches == 1 + transitions.truncated.sum()
    assert report.dropped == sum(twist == TWISTS[-1] for _, twist in told)
    assert report.steps <= report.duration / 0.9
    joined = ~transitions.truncated[:-1]
    assert (transitions.s_next[:-1] == transitions.s[1:])[joined].all()


SLOW = 0.019  # [m/s]; half of what is commanded, so that a reward for a whole step is a false one
# how often a message comes in a second: (odometry, scan, command)
RATES = st.sampled_from([(20, 5, 10), (20, 20, 1), (5, 5, 10), (10, 7, 3)])


def slow_drive(rates, received, sent) -> Drive:
    """Forty seconds in which a robot gets half as far as it is told to.

    received, sent: what the clocks of the recorder and of the sender say at a time [ns]
    """
    drive = Drive()
    messages = []
    for kind, rate in enumerate(rates):
        for i in range(40 * rate):
            messages.append((50 * SECOND + i * SECOND // rate + kind, kind))
    messages.sort(key=lambda message: received(message[0]))  # as a bag is read
    for time, kind in messages:
        x = SLOW * time / SECOND
        track, value = (
            (drive.poses, {"x": x, "y": 0.0, "theta": 0.0}),
            (drive.scans, dict.fromkeys(LASERS, 1.5)),
            (drive.twists, TWISTS[1]),
        )[kind]
        track.add(received(time), value, sent(time) if kind < 2 else 0)
    return drive


def rewards_of(drive: Drive) -> set[float]:
    transitions, _ = transitions_of(TASK, drive, MOTIONS, ("odom", "scan", "cmd_vel"))
    return set(transitions.r.tolist())


@settings(max_examples=150, deadline=None)
@given(RATES, st.floats(-15, 15), st.integers(55 * SECOND, 80 * SECOND), st.booleans())
def test_a_clock_that_is_set_makes_no_reward_that_never_was(
    rates, seconds, moment, is_recorders
):
    def right(time):
        return time

    def was_set(time):
        return time + round(seconds * SECOND) if time >= moment else time

    true = rewards_of(slow_drive(rates, right, right))
    clocks = (was_set, right) if is_recorders else (right, was_set)
    drive = slow_drive(rates, *clocks)
    assert rewards_of(drive) == true
    _, report = transitions_of(TASK, drive, MOTIONS, ("odom", "scan", "cmd_vel"))
    if seconds < -1:
        assert report.disordered and "steps whose times contradict" in str(report)
    if not is_recorders:
        assert len(transitions_of(TASK, drive, MOTIONS, ("o", "s", "c"))[0].s) >= 36


@settings(max_examples=100, deadline=None)
@given(st.floats(1.5, 15), st.integers(60 * SECOND, 75 * SECOND))
def test_if_all_clocks_are_set_back_odometry_betrays_it(seconds, moment):
    def was_set(time):
        return time - round(seconds * SECOND) if time >= moment else time

    def right(time):
        return time

    rates = (20, 5, 10)
    true = rewards_of(slow_drive(rates, right, right))
    assert rewards_of(slow_drive(rates, was_set, was_set)) == true


def test_clocks_that_differ_or_say_nothing_cost_no_step():
    def right(time):
        return time

    def early(time):
        return time - 40 * SECOND

    def drifting(time):
        return round(1.01 * time)

    def silent(time):
        return 0

    for sent in (right, early, drifting, silent):
        drive = slow_drive((20, 5, 10), right, sent)
        _, report = transitions_of(TASK, drive, MOTIONS, ("odom", "scan", "cmd_vel"))
        assert report.steps >= 39 and report.disordered == 0
