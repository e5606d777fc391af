"""The situations on which a designed reward is tried hold all that a robot reads, for a reward may read all of it."""

import pytest
from test_checks import EVERY, exercises

import rlrobot_edu as rl
from rlrobot_course.exercises.design import Design

DESIGNS = [
    (lesson, name)
    for lesson, name in EVERY
    if isinstance(exercises(lesson)[name], Design)
]


@pytest.mark.parametrize(("lesson", "name"), DESIGNS)
def test_a_situation_holds_all_that_the_robot_reads(lesson, name):
    readings = rl.make_env("wander_1k").unwrapped.robot.reset()
    for case in exercises(lesson)[name].cases:
        for _, before, after in case.values():
            assert before.keys() == after.keys() == readings.keys()


def turning(before, after) -> float:
    """How much a step has turned the robot [rad]."""
    return abs(after["theta"] - before["theta"])


@pytest.mark.parametrize(("lesson", "name"), DESIGNS)
def test_a_reward_may_read_whatever_the_robot_reads(lesson, name):
    exercise = exercises(lesson)[name]

    def reads_more(before, after):
        behind = min(after["laser_rear"], after["laser_rear_left"])
        return exercise.right(before, after) - 1e-6 * (turning(before, after) + behind)

    assert exercise.judge(reads_more)
