"""The mobile base against geometry: closed-form arcs, exact rays, and walls that hold."""

import hashlib
import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rlrobot_edu.robots.arenas import ARENAS, Arena
from rlrobot_edu.robots.giraff import Giraff
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.robot_cards import LASER_RANGE, LASERS, ROBOTS

speeds = st.one_of(st.sampled_from([-2.0, -1.0, 0.0, 1.0, 2.0]), st.floats(-2, 2))
ROBOT_OF = {"square_2x2": MobileBase, "maze_6x6": MobileBase, "maze_4x4_goal": MobileBase, "hexagon_giraff": Giraff}
SCENES = list(ROBOT_OF)


def test_every_arena_of_these_robots_is_tested_here():
    assert set(SCENES) == {*ROBOTS["mobile_base"].scenes, *ROBOTS["giraff"].scenes}


def wheels(left, right):
    return {"left_wheel": float(left), "right_wheel": float(right)}


def in_frame_of(wall, points):
    """`points` (n, 2) as seen from the centre of `wall`, along its length and across it [m]; array (n, 2)."""
    c, s = math.cos(wall.angle), math.sin(wall.angle)
    return (np.asarray(points) - (wall.x, wall.y)) @ np.array([[c, -s], [s, c]])


def distances_to_walls(arena, points):
    """Distance of each of `points` (n, 2) to the nearest wall, 0 inside one [m]; array (n,)."""
    outside = [
        np.maximum(np.abs(in_frame_of(wall, points)) - (wall.length / 2, wall.thickness / 2), 0) for wall in arena.walls
    ]
    return np.min([np.hypot(*o.T) for o in outside], axis=0)


def exact_ray(arena, x, y, angle):
    """Length of the ray from (x, y) to the first wall [m], by the slab method."""
    nearest = math.inf
    for wall in arena.walls:
        start, ahead = in_frame_of(wall, [(x, y), (x + math.cos(angle), y + math.sin(angle))])
        half = np.array([wall.length, wall.thickness]) / 2
        with np.errstate(divide="ignore"):
            near, far = np.sort([(-half - start) / (ahead - start), (half - start) / (ahead - start)], axis=0)
        if max(near) <= min(far) and max(near) >= 0:
            nearest = min(nearest, max(near))
    return nearest


@pytest.fixture
def free_space(monkeypatch):
    monkeypatch.setitem(ARENAS, "free_space", Arena((), (-5, -5, 5, 5), (0.0, 0.0, 0.0)))


@pytest.mark.parametrize("kind", [MobileBase, Giraff])
def test_in_free_space_the_robot_follows_the_closed_form_arc(free_space, kind):
    rng = np.random.default_rng(7)
    wheel_radius, separation = kind.chassis.wheel_radius, kind.chassis.wheel_separation
    for commands in [*rng.uniform(-2, 2, (10, 20, 2)), *rng.choice([-2, -1, 0, 1, 2], (10, 20, 2))]:
        robot = kind("free_space", 1.0)
        x = y = theta = 0.0
        for left, right in commands:
            readings = robot.act(wheels(left, right))
            v, turn = wheel_radius * (left + right) / 2, wheel_radius * (right - left) / separation
            if turn:
                x += v / turn * (math.sin(theta + turn) - math.sin(theta))
                y -= v / turn * (math.cos(theta + turn) - math.cos(theta))
            else:
                x, y = x + v * math.cos(theta), y + v * math.sin(theta)
            theta += turn
            assert math.hypot(readings["x"] - x, readings["y"] - y) < 1e-9
            assert abs(math.remainder(readings["theta"] - theta, 2 * math.pi)) < 1e-9
            assert -math.pi < readings["theta"] <= math.pi


@pytest.mark.parametrize("step_time", [0.1, 0.32, 2.0])
def test_a_step_of_any_duration_covers_the_same_ground_a_second(free_space, step_time):
    reading = MobileBase("free_space", step_time).act(wheels(1, 1))
    assert reading["x"] == pytest.approx(MobileBase.chassis.wheel_radius * step_time)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(SCENES), st.lists(st.tuples(speeds, speeds), max_size=12))
def test_the_lasers_measure_exactly_to_the_walls(scene, commands):
    robot = ROBOT_OF[scene](scene, 1.0)
    readings = robot.readings
    for left, right in commands:
        readings = robot.act(wheels(left, right))
    for i, laser in enumerate(LASERS):
        ray = exact_ray(ARENAS[scene], readings["x"], readings["y"], readings["theta"] + i * math.pi / 4)
        assert readings[laser] == pytest.approx(min(max(ray - robot.chassis.radius, 0.0), LASER_RANGE), abs=1e-9)


def test_the_lasers_see_no_further_than_their_range(free_space):
    assert all(MobileBase("free_space", 1.0).readings[laser] == LASER_RANGE for laser in LASERS)


@pytest.mark.parametrize("scene", SCENES)
def test_no_wall_is_crossed_or_entered_by_a_centimetre_in_25000_steps_at_double_speed(scene):
    robot = ROBOT_OF[scene](scene, 1.0)
    radius = robot.chassis.bumper
    commands = np.random.default_rng(3).choice([-2.0, 2.0], (25_000, 2)).tolist()
    path = np.array([[r["x"], r["y"]] for r in (robot.act(wheels(*command)) for command in commands)])
    assert distances_to_walls(ARENAS[scene], path).min() > radius - 0.01
    for part in np.linspace(0, 1, 12)[1:-1]:  # between two steps it took no short cut through a panel either
        assert distances_to_walls(ARENAS[scene], path[:-1] * (1 - part) + path[1:] * part).min() > radius - 0.05


def test_a_robot_that_pushes_a_wall_stands_still_and_one_that_grazes_it_slides_along():
    robot = MobileBase("square_2x2", 1.0)
    for _ in range(10):
        pushing = robot.act(wheels(2, 2))
    again = robot.act(wheels(2, 2))
    assert again["x"] == pytest.approx(pushing["x"], abs=1e-4) == pytest.approx(1 - robot.chassis.bumper, abs=0.002)
    assert again["laser_front"] == pytest.approx(robot.chassis.bumper - robot.chassis.radius, abs=0.002)
    turned = robot.act(wheels(-1, 1))
    slid = robot.act(wheels(1, 1))
    assert slid["y"] - turned["y"] == pytest.approx(robot.chassis.wheel_radius * math.sin(turned["theta"]), abs=1e-6)


@pytest.mark.parametrize("scene", SCENES)
def test_the_robot_starts_clear_of_all_walls(scene):
    start = ROBOT_OF[scene](scene, 1.0).readings
    lasers = ["laser_front", "laser_front_left", "laser_left", "laser_right", "laser_front_right"]
    clear = {"square_2x2": 0.5, "maze_6x6": 0.8, "maze_4x4_goal": 0.35, "hexagon_giraff": 0.25}
    assert min(start[laser] for laser in lasers) > clear[scene]


def fingerprint_of_a_run(robot):
    """All the bits of all readings of 300 random steps after a reset."""
    commands = np.random.default_rng(5).uniform(-2, 2, (300, 2))
    runs = [robot.reset(), *(robot.act(wheels(*command)) for command in commands)]
    return hashlib.sha256(np.array([list(readings.values()) for readings in runs]).tobytes()).hexdigest()


def test_a_run_repeats_bit_for_bit_after_a_reset_and_in_another_process():
    robot = MobileBase("maze_6x6", 1.0)
    first = fingerprint_of_a_run(robot)
    assert fingerprint_of_a_run(robot) == first
    code = (
        "import runpy; there = runpy.run_path(__import__('sys').argv[1]);"
        "print(there['fingerprint_of_a_run'](there['MobileBase']('maze_6x6', 1.0)))"
    )
    elsewhere = subprocess.run([sys.executable, "-c", code, __file__], capture_output=True, text=True, check=True)
    assert elsewhere.stdout.strip() == first


@pytest.mark.parametrize(
    "command",
    [
        {"left_wheel": 1.0, "right_weel": 1.0},
        {"left_wheel": 1.0},
        {"left_wheel": 1.0, "right_wheel": 1.0, "gripper": 0.0},
        {"left_wheel": math.nan, "right_wheel": 1.0},
        {"left_wheel": 1.0, "right_wheel": 4.1},
        {"left_wheel": -math.inf, "right_wheel": 0.0},
    ],
)
def test_a_command_that_cannot_be_carried_out_is_refused_and_moves_nothing(command):
    robot = MobileBase("square_2x2", 1.0)
    before = robot.readings
    with pytest.raises(ValueError, match="command"):
        robot.act(command)
    assert robot.readings == before


@pytest.mark.parametrize("scene", SCENES)
def test_the_scene_shows_the_robot_where_its_readings_say_and_beams_as_long_as_they_measure(scene):
    robot = ROBOT_OF[scene](scene, 1.0)
    robot.act(wheels(1, -1))
    readings = robot.act(wheels(2, 1))
    assert set(readings) == set(ROBOTS["mobile_base"].sensors)
    picture = robot.scene()
    names = [solid.name for solid in picture.solids]
    assert len(set(names)) == len(names)
    body, nose = (picture.solids[names.index(name)].pose for name in ("robot/body", "robot/nose"))
    assert body[:2, 3] == pytest.approx([readings["x"], readings["y"]])
    ahead = nose[:2, 3] - body[:2, 3]
    assert math.atan2(ahead[1], ahead[0]) == pytest.approx(readings["theta"])
    lengths = np.linalg.norm(picture.beams[:, 1] - picture.beams[:, 0], axis=1)
    assert lengths == pytest.approx([readings[laser] for laser in LASERS])
