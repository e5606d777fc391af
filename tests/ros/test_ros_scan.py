"""Any laser scan as eight readings: however the scanner turns and hangs, it is the same world that it sees."""

import math
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from bags import scan
from hypothesis import given, settings
from hypothesis import strategies as st

from rlrobot_edu import load_task
from rlrobot_edu.robots.chassis import CHASSIS, GIRAFF, PIONEER
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS
from rlrobot_ros.live.safety import room_ahead
from rlrobot_ros.live.sensors import Sensors
from rlrobot_ros.odometry import heading, pose_readings
from rlrobot_ros.scan import (
    GAP,
    Mounting,
    beams_end,
    laser_readings,
    looking_out,
    measured,
)

CENTRE, TURN = Mounting(), 2 * math.pi
PAGE = (Path(__file__).parents[2] / "docs/real_robot.md").read_text(encoding="utf-8")
angles = st.floats(-math.pi, math.pi)
some = settings(max_examples=60, deadline=None)


def to_wall(x: float, y: float, angle: float, half: float) -> float:
    """How far it is from x, y to the walls of a square room of sides 2 · `half`."""
    ways = [
        (math.copysign(half, d) - p) / d
        for p, d in ((x, math.cos(angle)), (y, math.sin(angle)))
        if abs(d) > 1e-12
    ]
    return min(ways)


def room_scan(rays: int, place: tuple[float, float, float], sense: int = 1) -> object:
    x, y, yaw = place
    return scan(
        [to_wall(x, y, yaw + sense * TURN / rays * i, 2.0) for i in range(rays)],
        0.0,
        TURN / rays,
    )


@some
@given(
    st.lists(st.floats(0.125, 9.0, width=32), min_size=64, max_size=64), st.integers(0, 63), st.sampled_from([1, -1]),
    st.booleans(), st.sampled_from([GIRAFF, PIONEER]),
)  # fmt: skip
def test_a_scanner_that_begins_elsewhere_turns_the_other_way_or_hangs_sees_the_same(
    ranges, first, sense, hangs, chassis
):
    expected = laser_readings(scan(ranges, 0.0, TURN / 64), chassis, CENTRE)
    seen = sense * (
        -1 if hangs else 1
    )  # the way in which its rays follow each other, seen from above
    turned = [ranges[(first + seen * i) % 64] for i in range(64)]
    mounting = Mounting(yaw=first * TURN / 64 - seen * 5.0, upside_down=hangs)
    given = laser_readings(
        scan(turned, sense * 5.0, sense * TURN / 64), chassis, mounting
    )
    assert list(given) == list(LASERS)
    assert given == pytest.approx(expected, abs=1e-4)


@some
@given(
    st.floats(-0.25, 0.25),
    st.floats(-0.25, 0.25),
    angles,
    st.booleans(),
    st.sampled_from([GIRAFF, PIONEER]),
)
def test_wherever_the_scanner_stands_the_readings_are_those_of_the_lasers_places(
    x, y, yaw, hangs, chassis
):
    mounting, sense = Mounting(x, y, yaw, hangs), -1 if hangs else 1
    readings = laser_readings(room_scan(3600, (x, y, yaw), sense), chassis, mounting)
    for laser, (ahead, aside, angle) in zip(LASERS, chassis.lasers, strict=True):
        assert readings[laser] == pytest.approx(
            to_wall(ahead - chassis.axle, aside, angle, 2.0), abs=0.01
        )


@some
@given(
    st.lists(st.floats(width=32), min_size=1, max_size=40),
    angles,
    angles.filter(bool),
    angles,
)
def test_whatever_a_driver_writes_readings_are_within_the_lasers_range(
    ranges, angle_min, increment, yaw
):
    for chassis in (GIRAFF, PIONEER):
        readings = laser_readings(
            scan(ranges, angle_min, increment), chassis, Mounting(0.1, 0.0, yaw)
        )
        assert all(0 <= reading <= LASER_RANGE for reading in readings.values())


@pytest.mark.parametrize("too_near", [-math.inf, -1.0, 0.04])
def test_a_ray_that_met_nothing_reads_the_lasers_range_and_one_too_near_reads_zero(
    too_near,
):
    ranges = np.full(8, 1.0)
    ranges[1], ranges[2] = math.inf, too_near
    readings = laser_readings(scan(ranges), GIRAFF, CENTRE)
    assert readings["laser_front_left"] == LASER_RANGE and readings["laser_left"] == 0
    assert readings["laser_front"] == pytest.approx(1 - GIRAFF.radius)


NOTHING_SAID = [
    (math.nan, math.nan),
    (0.0, 0.0),
    (10.1, 11.0),
    (1000.0, 11.0),
]  # with what may be told of the scanner


@pytest.mark.parametrize(("nothing", "far"), NOTHING_SAID)
def test_a_ray_that_says_nothing_leaves_its_laser_unknown_unless_one_is_told_that_it_means_far(
    nothing, far
):
    ranges = np.full(8, 1.0)
    ranges[1] = nothing
    assert "laser_front_left" not in laser_readings(scan(ranges), GIRAFF, CENTRE)
    assert len(laser_readings(scan(ranges), GIRAFF, CENTRE)) == 7
    assert (
        laser_readings(scan(ranges), GIRAFF, Mounting(far=far))["laser_front_left"]
        == LASER_RANGE
    )
    others = {told for _, told in NOTHING_SAID if str(told) != str(far)}
    for other in others:  # what another scanner means says nothing of this one
        assert "laser_front_left" not in laser_readings(
            scan(ranges), GIRAFF, Mounting(far=other)
        )


def test_null_of_rosbridge_is_a_ray_that_says_nothing():
    message = scan([1.0] * 8)
    message.ranges = [1.0, None, *[1.0] * 6]
    assert "laser_front_left" not in laser_readings(message, GIRAFF, CENTRE)


@pytest.mark.parametrize("far", [math.inf, 0.0])
@pytest.mark.parametrize("chassis", [GIRAFF, PIONEER])
def test_in_a_narrow_gap_a_ray_that_says_nothing_is_as_far_as_its_nearer_neighbour(
    chassis, far
):
    walls = np.full(360, 0.7)
    expected = laser_readings(scan(walls, 0.0, TURN / 360), chassis, Mounting(far=far))
    lost, rays = np.random.default_rng(0).random(360) < 0.25, int(GAP / (TURN / 360))
    lost[::rays] = False  # no gap is wider
    assert (
        laser_readings(
            scan(np.where(lost, 0.0, walls), 0.0, TURN / 360),
            chassis,
            Mounting(far=far),
        )
        == expected
    )
    walls[350:] = 0.5
    walls[358:], walls[:3] = 0.0, 0.0  # at its right it is 0.5 m, at its left 0.7 m
    front = laser_readings(scan(walls, 0.0, TURN / 360), GIRAFF, Mounting(far=far))[
        "laser_front"
    ]
    assert front == pytest.approx(0.5 - GIRAFF.radius)
    walls[:] = 0.7
    walls[: rays + 2] = 0.0
    wide = laser_readings(scan(walls, 0.0, TURN / 360), GIRAFF, Mounting(far=far))
    assert wide.get("laser_front") == (LASER_RANGE if far == 0 else None)


def test_a_lost_ray_counts_only_as_far_as_a_beam_gets():
    ranges = np.full(720, 0.9)
    ahead = laser_readings(scan(ranges, 0.0, TURN / 720), PIONEER, CENTRE)[
        "laser_front_left"
    ]
    ranges[100:300] = (
        math.nan
    )  # the beam to the front left comes from rays nearer to straight ahead, or ends before
    readings = laser_readings(scan(ranges, 0.0, TURN / 720), PIONEER, CENTRE)
    assert {
        "laser_front",
        "laser_right",
        "laser_rear",
    } <= readings.keys() and "laser_left" not in readings
    assert readings.get("laser_front_left", ahead) == ahead


@some
@given(
    st.lists(st.floats(0.0, 0.02), min_size=360, max_size=360),
    st.data(),
    st.sampled_from([GIRAFF, PIONEER]),
)
def test_a_laser_sees_no_nearer_and_no_further_than_the_bounds_of_a_scan_with_lost_rays(
    steps, data, chassis
):
    walls = 0.3 + np.cumsum(
        steps
    )  # what a lost ray would have met is between its neighbours
    lost = data.draw(st.sets(st.integers(20, 340)))
    damaged = walls.copy()
    damaged[list(lost)] = data.draw(st.sampled_from([math.nan, 0.0, 99.0]))
    whole = laser_readings(scan(walls, 0.0, TURN / 360), chassis, CENTRE)
    rays = measured(scan(damaged, 0.0, TURN / 360))
    near, far = (
        beams_end(rays, ranges, chassis, CENTRE)
        for ranges in (rays.ranges, rays.farthest)
    )
    for laser, reading in whole.items():
        assert (
            math.isnan(far[laser]) or near[laser] - 1e-6 <= reading <= far[laser] + 1e-6
        )


def single(angle: float) -> float:
    """The angle as a message holds it, in single precision."""
    return float(np.float32(angle))


def known_live(message: object, mounting: Mounting) -> set[str]:
    """The lasers that a link to a Giraff knows after this scan."""
    sensors = Sensors(GIRAFF, mounting, "odom", "scan")
    message.header = SimpleNamespace(stamp=SimpleNamespace(sec=1, nanosec=0))
    sensors.receive_scan(message)
    lasers = sensors.sight.value.lasers
    return {name for name in lasers if lasers[name] >= 0}


@pytest.mark.parametrize("side", [-1, 1])
def test_a_laser_midway_between_two_rays_is_seen_in_bags_and_live(side):
    for rays in range(8, 1200, 5):
        step = single(TURN / rays)
        first = single(-math.pi + side * step / 2)
        round_about = scan([1.0] * rays, first, step)
        assert laser_readings(round_about, GIRAFF, CENTRE).keys() == set(LASERS), rays
        assert known_live(round_about, CENTRE) == set(LASERS), rays


@some
@given(st.integers(8, 1200), angles, angles, st.booleans())
def test_a_scanner_that_looks_all_round_sees_every_laser(rays, first, yaw, hangs):
    mounting = Mounting(yaw=yaw, upside_down=hangs)
    round_about = scan([1.0] * rays, single(first), single(TURN / rays))
    assert laser_readings(round_about, GIRAFF, mounting).keys() == set(LASERS)
    assert known_live(round_about, mounting) == set(LASERS)


def test_a_laser_between_the_two_middle_rays_of_a_camera_is_seen():
    camera = scan([1.0] * 640, -2.26889, 2 * 2.26889 / 639)
    assert "laser_front" in laser_readings(camera, PIONEER, CENTRE)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_ray_at_the_very_edge_of_ahead_counts_whatever_rounding_makes_of_it(side):
    for rays in range(24, 1200, 6):  # one of them looks 60° to this side
        step = single(side * TURN / rays)
        ranges = np.full(rays, 3.0)
        ranges[rays // 6] = 1.0
        room = room_ahead(scan(ranges, 0.0, step), GIRAFF, CENTRE)
        assert room == pytest.approx(1.0 - GIRAFF.radius), rays


def test_what_the_scanner_does_not_look_at_is_not_known_rather_than_free():
    half_turn = scan([math.inf] * 181, -math.pi / 2, math.pi / 180)
    front = {
        "laser_front",
        "laser_front_left",
        "laser_front_right",
        "laser_left",
        "laser_right",
    }
    assert laser_readings(half_turn, GIRAFF, CENTRE).keys() == front
    assert laser_readings(half_turn, GIRAFF, Mounting(yaw=math.pi / 2)).keys() == {
        "laser_front", "laser_front_left", "laser_left", "laser_rear_left", "laser_rear"
    }  # fmt: skip
    beside = Mounting(x=0.2)  # left and right lie behind it
    assert laser_readings(half_turn, GIRAFF, beside).keys() == front - {
        "laser_left",
        "laser_right",
    } - {
        name
        for name in (
            "laser_front_left",
            "laser_front_right",
        )  # they stand behind it, too
    }


@pytest.mark.parametrize("broken", [
        {"increment": 0.0}, {"increment": math.nan}, {"angle_min": math.inf}, {"range_max": 0.0},
        {"range_max": math.nan}, {"range_min": math.nan}, {"angle_max": 0.1},
    ])  # fmt: skip
def test_a_scan_that_cannot_be_is_refused(broken):
    with pytest.raises(ValueError, match="an impossible laser scan"):
        laser_readings(scan([1.0] * 8, **broken), GIRAFF, CENTRE)
    with pytest.raises(ValueError, match="an impossible laser scan"):
        laser_readings(scan([]), GIRAFF, CENTRE)


@pytest.mark.parametrize("angle_max", [0.0, math.nan, TURN, TURN * 7 / 8, TURN * 6 / 8])
def test_a_driver_that_says_its_last_angle_a_little_wrong_or_not_at_all_is_heard(
    angle_max,
):
    assert (
        len(laser_readings(scan([1.0] * 8, angle_max=angle_max), GIRAFF, CENTRE)) == 8
    )


@pytest.mark.parametrize("given", [
        (0, 0), (0, 0, 0, False, 1, 2), (0, 0, 0, False, "far"), (0, 0, 0, False, -math.inf), (0, 0, 0, 2),
        (0, 0, math.inf, 0),
    ])  # fmt: skip
def test_a_mounting_that_cannot_be_is_refused(given):
    with pytest.raises(ValueError, match="mounting must be"):
        Mounting.of(given)
    assert (
        Mounting.of((0, 0, 0, False)).far == math.inf
        and Mounting.of((0, 0, 0, False, 0)).far == 0
    )


@some
@given(angles, st.floats(0.1, 10))
def test_a_quaternion_of_any_length_turns_by_its_angle(theta, length):
    found = heading(
        0.0, 0.0, length * math.sin(theta / 2), length * math.cos(theta / 2)
    )
    assert math.cos(found - theta) == pytest.approx(1) and -math.pi < found <= math.pi


@pytest.mark.parametrize("q", [(0, 0, 0, 0), (0, 0, math.nan, 1), (0, 0, math.inf, 1)])
def test_what_is_no_orientation_or_no_place_is_refused(q):
    with pytest.raises(ValueError, match="orientation"):
        heading(*q)
    for x in (math.nan, math.inf, 1e300, -1e8):
        with pytest.raises(ValueError, match="place"):
            pose_readings(x, 0.0, 0.0, GIRAFF)


@some
@given(st.floats(-1, 1), st.floats(-3, 3), st.sampled_from([GIRAFF, PIONEER]))
def test_wheels_turn_as_the_motion_says(v, omega, chassis):
    assert chassis.twist(chassis.wheel_speeds(v, omega)) == pytest.approx((v, omega))


@pytest.mark.parametrize("chassis", [GIRAFF, PIONEER])
@given(st.floats(-0.2, 0.2), st.floats(0.5, 4.0))
def test_lasers_that_look_out_from_the_scanner_see_what_it_sees_from_the_circle_on(
    chassis, ahead, room
):
    lasers = looking_out(chassis, ahead)
    mounting = Mounting(x=ahead - chassis.axle)
    readings = laser_readings(scan([room] * 8), lasers, mounting)
    assert len(readings) == 8
    for (x, y, angle), reading in zip(lasers.lasers, readings.values(), strict=True):
        assert math.hypot(x, y) == pytest.approx(chassis.radius)
        assert math.hypot(x - ahead, y) + reading == pytest.approx(room, abs=1e-6)
        assert (
            math.atan2(y, x - ahead)
            == pytest.approx(math.remainder(angle, 2 * math.pi))
            or abs(angle - math.pi) < 1e-9
        )


def test_a_scanner_outside_of_the_robot_has_no_lasers():
    with pytest.raises(
        ValueError, match=r"0\.3 m ahead is outside the robot's circle of 0\.23 m"
    ):
        looking_out(GIRAFF, 0.3)


def test_a_narrow_scanner_leaves_as_many_lasers_as_the_page_of_real_robots_says():
    degree, mounting = math.radians(1), Mounting(x=0.2)
    for half, as_it_is, looking in ((80, 1, 3), (90, 1, 5)):
        seen = scan([2.0] * (2 * half + 1), -half * degree, degree)
        assert len(laser_readings(seen, GIRAFF, mounting)) == as_it_is
        assert len(laser_readings(seen, looking_out(GIRAFF, 0.2), mounting)) == looking


def test_the_page_of_real_robots_says_how_fast_the_tasks_drive():
    rows = re.findall(
        r"^\| (`.*) \| ([\d.]+)(?: and ([\d.]+))? m/s, ([\d.]+) rad/s \|", PAGE, re.M
    )
    assert len(rows) == 4
    for names, slow, fast, turn in rows:
        for name, speed in zip(
            re.findall(r"`(\w+)`", names), (slow, fast or slow), strict=False
        ):
            task = load_task(name)
            motions = [
                CHASSIS[task.robot].twist(task.command_for(a))
                for a in range(task.actions.n)
            ]
            largest = [max(v for v, _ in motions), max(omega for _, omega in motions)]
            assert largest == pytest.approx([float(speed), float(turn)], abs=0.0051), (
                name
            )
