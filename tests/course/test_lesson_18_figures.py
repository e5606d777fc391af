"""Lesson 18's scan and figures say what they should, and its solutions what the library says."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from rlrobot_course.lesson_18 import exercises
from rlrobot_course.lesson_18.scans import plot_scan, scan_finding
from rlrobot_edu.robots.chassis import GIRAFF, PIONEER, Chassis
from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_ros import RobotLink, ServedRobot
from rlrobot_ros.live.controller import MAX_AGE
from rlrobot_ros.live.safety import AHEAD, room_ahead
from rlrobot_ros.scan import Mounting

POINT = Chassis(
    0.1, wheel_separation=0.1, axle=0.0, lasers=(), inset=0.0, hull=(), radius=0.0
)


def scan_of(ranges, angle_min=0.0, range_max=10.0):
    increment = 2 * math.pi / len(ranges)
    return SimpleNamespace(
        angle_min=angle_min,
        angle_increment=increment,
        range_min=0.0,
        range_max=range_max,
        ranges=ranges,
    )


@pytest.mark.parametrize("chassis", [PIONEER, GIRAFF])
def test_wheel_speeds_are_those_of_the_library(chassis):
    for v, omega in ((0.15, 0.5), (-0.1, 0.2), (0.0, -1.0)):
        mine = exercises.wheels(
            v, omega, chassis.wheel_radius, chassis.wheel_separation
        )
        assert mine == pytest.approx(
            [chassis.wheel_speeds(v, omega)[wheel] for wheel in WHEELS]
        )


def test_the_numbers_of_the_giraff_in_the_text_are_right():
    left, _ = exercises.wheels(0.15, 0.5, GIRAFF.wheel_radius, GIRAFF.wheel_separation)
    assert (GIRAFF.wheel_radius, GIRAFF.wheel_separation) == (
        0.075,
        0.46,
    ) and left == pytest.approx(0.47, abs=0.005)


@pytest.mark.parametrize("nothing", [0.0, math.inf, math.nan])
@pytest.mark.parametrize("angle_min", [0.0, -math.pi])
def test_the_nearest_ahead_is_what_the_link_finds_for_a_robot_without_a_body(
    nothing, angle_min
):
    rng = np.random.default_rng(0)
    assert math.cos(AHEAD) == pytest.approx(0.5)
    for share in (0.0, 0.5, 0.97, 1.0):
        ranges = rng.uniform(0.1, 5.0, size=77)
        ranges[rng.random(77) < share] = nothing
        scan = scan_of(ranges.tolist(), angle_min)
        mine = exercises.nearest_ahead(scan.ranges, angle_min, scan.angle_increment)
        room = room_ahead(scan, POINT, Mounting())
        if share in (0.0, 1.0) or nothing == math.inf or not math.isnan(room):
            assert mine == pytest.approx(
                room, nan_ok=True
            )  # where much says 0 or NaN ahead, the link is more careful


def test_the_rules_of_the_exercise_are_those_of_the_link():
    assert MAX_AGE == 0.5
    assert RobotLink()._settings.limits.safety_distance == 0.18
    assert exercises.allowed(0.2, 0.3, 0.18, 0.5) == (0.2, 0.3)
    assert exercises.allowed(0.2, 0.3, 0.17, 0.5) == (0.0, 0.3)
    assert (
        exercises.allowed(0.2, 0.3, math.nan, 0.0)
        == exercises.allowed(0.2, 0.3, 9.0, 0.6)
        == (0.0, 0.0)
    )


def test_a_scan_that_sees_nothing_can_be_drawn_too():
    assert plot_scan(scan_of([math.inf] * 360), GIRAFF).png()


def test_one_message_of_each_topic_comes_from_a_served_robot(nothing_is_left_running):
    pytest.importorskip(
        "websockets", reason="websockets is missing: pip install websockets"
    )
    from rlrobot_course.lesson_18.scans import listen

    with ServedRobot("wander_1k", port=0, simulated_time=True) as robot:
        odom, scan = listen(robot.address)
    assert (
        odom.pose.pose.position.x == pytest.approx(PIONEER.axle)
        and len(scan.ranges) == 360
    )


def test_the_guardian_speaks_when_a_driver_is_killed(nothing_is_left_running):
    pytest.importorskip(
        "websockets", reason="websockets is missing: pip install websockets"
    )
    from rlrobot_course.lesson_18.killed import kill_a_driver

    with ServedRobot("wander_1k", port=0) as robot:
        assert kill_a_driver(robot.address) == pytest.approx((0.0975, 0.0))


def test_a_laser_that_ends_before_the_ray_beside_it_is_named():
    scan = scan_of([2.0] * 360)
    met = {"laser_front": (2.0, 0.0), "laser_left": (0.0, 2.0)}
    assert scan_finding(met, scan) == "Each of the lasers ends at what the scanner met"
    met["laser_front_right"] = (0.7, -0.7)
    said = scan_finding(met, scan)
    assert said.startswith("1 of 3 lasers ends") and said.endswith("front right")
