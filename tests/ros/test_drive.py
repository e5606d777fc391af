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
