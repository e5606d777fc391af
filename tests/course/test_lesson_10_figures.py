"""Lesson 10's figure and worlds say what the numbers say."""

import numpy as np

from rlrobot_course.lesson_10.figures import plot_earnings
from rlrobot_course.lesson_10.worlds import Dice, Ring
from rlrobot_course.tapes import RobotWorld


def test_the_curves_are_the_average_rewards_so_far_and_their_mean():
    rewards = np.random.default_rng(0).normal(size=(3, 80))
    picture = plot_earnings({"one": rewards, "two": rewards + 1}, "a title")
    curves = [line.get_ydata() for line in picture.axes[0].lines]
    assert np.allclose(curves[0], np.cumsum(rewards[0]) / np.arange(1, 81))
    assert np.allclose(curves[3], np.mean(curves[:3], axis=0))


def test_a_ring_ends_its_episodes_in_both_ways_and_its_dice_know_the_moment_alone():
    ring = Ring(12, ((2, True), (3, False)))
    dice = Dice(ring)
    assert ring.reset() == 0 and ring.step(1)[0] == 1
    assert dice.random() == dice.random()
    assert ring.step(0)[2:] == (True, False)
    assert ring.reset() == 7
    assert [ring.step(2)[2:] for _ in range(3)] == [(False, False)] * 2 + [(False, True)]


def test_a_watched_robot_writes_down_its_rewards():
    robot = RobotWorld("worked_example", seed=0)
    robot.reset()
    assert robot.rewards == [] and [robot.step(a)[1] for a in (0, 1, 2)] == robot.rewards
