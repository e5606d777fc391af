"""Lesson 18a's driver is killed, and somebody else stops the robot."""

import pytest

import rlrobot_edu as rl


def test_the_guardian_speaks_when_a_driver_is_killed(nothing_is_left_running):
    pytest.importorskip("websockets", reason="websockets is missing: pip install 'rlrobot-edu[ros]'")
    from rlrobot_course.lesson_18a.killed import kill_a_driver

    with rl.ServedRobot("wander_1k", port=0) as robot:
        assert kill_a_driver(robot.where) == pytest.approx((0.0975, 0.0))
