"""Lesson 10's worlds."""

from rlrobot_course.lesson_10.worlds import Dice, Ring
from rlrobot_course.worlds.tapes import RobotWorld


def test_a_ring_ends_its_episodes_in_both_ways_and_its_dice_know_the_moment_alone():
    ring = Ring(12, ((2, True), (3, False)))
    dice = Dice(ring)
    assert ring.reset() == 0 and ring.step(1)[0] == 1
    assert dice.random() == dice.random()
    assert ring.step(0)[2:] == (True, False)
    assert ring.reset() == 7
    assert [ring.step(2)[2:] for _ in range(3)] == [(False, False)] * 2 + [
        (False, True)
    ]


def test_a_watched_robot_writes_down_its_rewards():
    robot = RobotWorld("worked_example", seed=0)
    robot.reset()
    assert (
        robot.rewards == [] and [robot.step(a)[1] for a in (0, 1, 2)] == robot.rewards
    )
