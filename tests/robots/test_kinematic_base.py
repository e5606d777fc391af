"""The mobile base without a physics engine: closed-form arcs, walls that are never entered, exact rays, and pymunk."""

import os
import subprocess
import sys
import warnings
from unittest.mock import patch

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import given, settings
from hypothesis import strategies as st
from test_base_tasks import STEPS, assert_learned
from test_mobile_base import (
    arc,
    deepest,
    exact_lasers,
    fingerprint_of_a_run,
    outline,
    speeds,
    wheels,
)

import rlrobot_edu as rl
from rlrobot_edu.robots import mobile_base
from rlrobot_edu.robots.arenas import ARENAS, Arena, Wall
from rlrobot_edu.robots.chassis import GIRAFF, PIONEER
from rlrobot_edu.robots.engines.kinematic.base import Body, KinematicBase, walls_of
from rlrobot_edu.robots.engines.kinematic.motion import (
    gap_to_wall,
    look,
    push_out,
    ray_to_wall,
)
from rlrobot_edu.robots.engines.kinematic.trigonometry import cosine, sine
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.robot_cards import LASERS, ROBOTS
from rlrobot_edu.task.task_file import available_tasks

SCENES = ROBOTS["mobile_base"].scenes
TASKS = [
    name for name in available_tasks() if rl.load_task(name).robot == "mobile_base"
]


def in_an_arena(monkeypatch, *walls, start=(0.0, 0.0, 0.0), kind=KinematicBase):
    """A robot between these walls."""
    monkeypatch.setitem(ARENAS, "some", Arena(walls, (-5, -5, 5, 5), start))
    return kind("some", 1.0)


def test_in_free_space_the_axle_follows_the_closed_form_arc(monkeypatch):
    rng, ahead = np.random.default_rng(7), PIONEER.axle
    for commands in [
        *rng.uniform(-2, 2, (10, 20, 2)),
        *rng.choice([-2, -1, 0, 1, 2], (10, 20, 2)),
    ]:
        robot, axle = in_an_arena(monkeypatch), (ahead, 0.0, 0.0)
        for left, right in commands:
            readings, axle = (
                robot.act(wheels(left, right)),
                arc(axle, left, right, 1.0, PIONEER),
            )
            there = [
                axle[0] - ahead * np.cos(axle[2]),
                axle[1] - ahead * np.sin(axle[2]),
            ]
            assert [readings["x"], readings["y"]] == pytest.approx(there, abs=1e-9)
            assert abs(np.angle(np.exp(1j * (readings["theta"] - axle[2])))) < 1e-9
            assert -np.pi < readings["theta"] <= np.pi


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(SCENES), st.lists(st.tuples(speeds, speeds), max_size=30))
def test_the_hull_is_never_inside_a_wall_and_the_lasers_measure_exactly(
    scene, commands
):
    robot = KinematicBase(scene, 1.0)
    for left, right in commands:
        readings = robot.act(wheels(left, right))
        assert deepest(ARENAS[scene], PIONEER, readings) < 1e-9
    exact = exact_lasers(ARENAS[scene], PIONEER, robot.readings)
    assert [robot.readings[laser] for laser in LASERS] == pytest.approx(exact, abs=1e-9)


places = st.floats(-0.8, 0.8)
boxes = st.builds(
    Wall, places, places, st.floats(0.1, 1.5), st.floats(0.02, 0.3), st.floats(0, 3.2)
)


@settings(max_examples=150, deadline=None)
@given(
    st.lists(boxes, min_size=1, max_size=6),
    st.lists(st.tuples(speeds, speeds), min_size=5, max_size=20),
)
def test_between_any_walls_even_where_it_gets_wedged_the_hull_is_never_inside_one(
    walls, commands
):
    bounds, start = (-2, -2, 2, 2), (0.0, 0.0, 0.0)
    here = dict(zip(("x", "y", "theta"), start, strict=True))
    clear = tuple(
        wall
        for wall in walls
        if deepest(Arena((wall,), bounds, start), PIONEER, here) < -1e-6
    )
    arena = Arena(clear, bounds, start)
    with patch.dict(ARENAS, {"some": arena}):
        robot = KinematicBase("some", 1.0)
    for left, right in commands:
        readings = robot.act(wheels(left, right))
        assert deepest(arena, PIONEER, readings) < 1e-9


@pytest.mark.parametrize("scene", SCENES)
def test_a_thousand_steps_at_double_speed_enter_no_wall_and_leave_no_room(scene):
    robot, (x_min, y_min, x_max, y_max) = (
        KinematicBase(scene, 1.0),
        ARENAS[scene].bounds,
    )
    for command in (
        np.random.default_rng(3).choice([-2.0, 2.0, 2.0], (1000, 2)).tolist()
    ):
        readings = robot.act(wheels(*command))
        assert deepest(ARENAS[scene], PIONEER, readings) < 1e-9
        assert x_min < readings["x"] < x_max and y_min < readings["y"] < y_max


@settings(max_examples=200, deadline=None)
@given(
    st.floats(-0.6, 0.6),
    st.floats(-0.6, 0.6),
    st.floats(-4, 4),
    st.floats(0, 3.2),
    st.floats(0.1, 0.8),
)
def test_the_gap_is_a_lower_bound_of_the_distance_and_the_depth_where_they_overlap(
    x, y, theta, angle, length
):
    wall, body = Wall(0.0, 0.0, length, 0.1, angle), Body.of(PIONEER)
    walls = np.array([[0, 0, length / 2, 0.05, np.cos(angle), np.sin(angle)]])
    touch, axle = np.empty(7), np.array([x, y, theta])
    gap = gap_to_wall(
        axle, np.cos(theta), np.sin(theta), body.hull, walls, 0, np.inf, touch
    )
    ahead = PIONEER.axle
    readings = {
        "x": x - ahead * np.cos(theta),
        "y": y - ahead * np.sin(theta),
        "theta": theta,
    }
    depth = deepest(Arena((wall,), (-1, -1, 1, 1), (0, 0, 0)), PIONEER, readings)
    if depth > 0 or gap < 0:
        assert gap == pytest.approx(-depth, abs=1e-9)
    hull, corners = (sampled(outline(PIONEER, readings)), sampled(wall.corners()))
    apart = np.linalg.norm(hull[:, None] - corners[None], axis=2).min()
    assert gap <= apart + 1e-9
    if (
        -0.05 < gap < 0.0
        and push_out(
            axle, body.hull, body.radius, body.moment, walls, np.zeros(1, int), 1, touch
        )
        < 8
    ):
        assert (
            gap_to_wall(
                axle,
                np.cos(axle[2]),
                np.sin(axle[2]),
                body.hull,
                walls,
                0,
                np.inf,
                touch,
            )
            >= 0.0
        )


@settings(max_examples=200, deadline=None)
@given(st.lists(boxes, min_size=1, max_size=8), places, places, st.floats(-3.1, 3.1))
def test_a_ray_that_skips_what_it_cannot_meet_is_as_long_as_one_that_asks_every_wall(
    boxes, x, y, theta
):
    walls, place = (
        walls_of(Arena(tuple(boxes), (-2, -2, 2, 2), (0, 0, 0))),
        np.array([x, y, theta]),
    )
    rays = np.array(
        [[0.0, 0.0, np.cos(angle), np.sin(angle)] for angle in np.linspace(0, 6, 40)]
    )
    lengths, cos, sin = np.empty(40), cosine(theta), sine(theta)
    look(place, rays, 1.5, walls, lengths)
    for (_, _, ahead, aside), length in zip(rays, lengths, strict=True):
        way = ahead * cos - aside * sin, ahead * sin + aside * cos
        assert length == min(
            1.5, *(ray_to_wall(x, y, *way, walls, i) for i in range(len(walls)))
        )


@settings(max_examples=200, deadline=None)
@given(boxes, places, places, st.floats(-3.1, 3.1), st.floats(-0.1, 0.5))
def test_a_search_for_the_gap_that_ends_with_what_is_enough_tells_the_same_as_a_whole_one(
    box, x, y, theta, enough
):
    walls, hull = (
        walls_of(Arena((box,), (-2, -2, 2, 2), (0, 0, 0))),
        Body.of(PIONEER).hull,
    )
    heading, whole, short = (np.cos(theta), np.sin(theta)), np.zeros(7), np.zeros(7)
    gap = gap_to_wall(np.array([x, y, theta]), *heading, hull, walls, 0, np.inf, whole)
    found = gap_to_wall(
        np.array([x, y, theta]), *heading, hull, walls, 0, enough, short
    )
    assert (found >= enough) == (gap >= enough)
    if gap < enough:
        assert found == gap and short.tolist() == whole.tolist()


def sampled(corners):
    """Points along the outline of a polygon (n, 2)."""
    return np.concatenate(
        [
            np.linspace(one, other, 40)
            for one, other in zip(corners, np.roll(corners, -1, axis=0), strict=True)
        ]
    )


@pytest.mark.parametrize("heading", [0.0, 0.1, -0.3, 0.6, -1.0, 1.4])
def test_at_a_wall_it_goes_where_pymunks_goes_once_its_sub_steps_are_short(
    monkeypatch, heading
):
    monkeypatch.setattr(
        mobile_base, "SUBSTEP", 0.002
    )  # at 0.05 s pymunk's is some 5 mm and 3 degrees off from this
    ways = []
    for kind in (MobileBase, KinematicBase):
        robot = in_an_arena(
            monkeypatch,
            Wall(1.0, 0.0, 9.0, angle=np.pi / 2),
            start=(0.4, 0.0, heading),
            kind=kind,
        )
        ways.append(
            [
                robot.act(wheels(*command))
                for command in [(1, 1)] * 12 + [(0, 1)] * 2 + [(1, 1)] * 3
            ]
        )
    for one, other in zip(*ways, strict=True):
        assert [one["x"], one["y"]] == pytest.approx(
            [other["x"], other["y"]], abs=0.003
        )
        assert one["theta"] == pytest.approx(other["theta"], abs=np.radians(1))


def test_a_robot_that_pushes_straight_against_a_wall_stands_still_with_its_front_on_it(
    monkeypatch,
):
    robot = in_an_arena(monkeypatch, Wall(1.0, 0.0, 9.0, angle=np.pi / 2))
    pushing = [robot.act(wheels(2, 2)) for _ in range(8)]
    assert pushing[-1] == pytest.approx(pushing[-2], abs=1e-5)
    assert (
        pushing[-1]["x"] == pytest.approx(0.95 - 0.260, abs=1e-5)
        and abs(pushing[-1]["theta"]) < 1e-5
    )
    assert pushing[-1]["laser_front"] == pytest.approx(0.260 - 0.220, abs=1e-5)


def test_what_is_mirrored_moves_as_its_mirror_image():
    left, right = KinematicBase("square_2x2", 1.0), KinematicBase("square_2x2", 1.0)
    for one, other in np.random.default_rng(0).choice([-1.0, 1.0, 1.0, 2.0], (60, 2)):
        here, there = left.act(wheels(one, other)), right.act(wheels(other, one))
        mirrored = [there["x"], -there["y"], -there["theta"]]
        assert [here["x"], here["y"], here["theta"]] == pytest.approx(
            mirrored, abs=1e-6
        )


PLAIN = """
import sys
sys.path.insert(0, sys.argv[1])
from test_mobile_base import fingerprint_of_a_run
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
print(fingerprint_of_a_run(KinematicBase("maze_6x6", 1.0)))
"""


def test_compiled_or_plain_the_readings_are_the_same_to_the_last_bit():
    run = [sys.executable, "-c", PLAIN, os.path.dirname(__file__)]
    said = subprocess.run(
        run,
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
    )
    assert said.stdout.strip() == fingerprint_of_a_run(
        KinematicBase("maze_6x6", 1.0)
    ), said.stderr


@pytest.mark.parametrize("task", TASKS)
def test_every_task_of_the_base_runs_and_one_seed_gives_one_result(task):
    def run():
        env = rl.make_env(
            task,
            seed=5,
            engine="kinematic",
            realism=rl.Realism(laser_noise=0.01, wheel_slip=0.1, delay=1),
        )
        return rl.learn(
            rl.Agent(task, "TOSL+QBIASSR", seed=1), env, 200, progress=False
        )

    one, other = run(), run()
    assert np.array_equal(one.rewards, other.rewards) and np.array_equal(one.q, other.q)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(f"rlrobot/{task}-v0", engine="kinematic").unwrapped
        check_env(env, skip_render_check=True)
    assert env.engine == "kinematic" and rl.make_env(task).engine == "pymunk"


@pytest.mark.long
@pytest.mark.parametrize(
    "task", ["wander_1k", "navigation_1k"]
)  # one that goes on for ever, one with a goal
def test_a_task_can_be_learned_without_an_engine(task):
    assert_learned(task, STEPS[task], repetitions=10, engine="kinematic")


def test_it_reads_and_is_drawn_as_the_base_in_pymunk():
    one, other = (kind("maze_4x4_goal", 1.0) for kind in (MobileBase, KinematicBase))
    for robot in (one, other):
        robot.act(wheels(0.5, 1))
    assert one.readings == pytest.approx(other.readings, abs=1e-6)
    for its, mine in zip(one.scene().solids, other.scene().solids, strict=True):
        assert (its.name, its.shape, its.size) == (mine.name, mine.shape, mine.size)
        assert its.pose == pytest.approx(mine.pose, abs=1e-6)


def test_a_robot_without_a_hull_is_refused():
    with pytest.raises(ValueError, match="this chassis is a disc"):
        rl.make_env("wander_1k", engine="kinematic", chassis=GIRAFF).reset()
    with pytest.raises(
        ValueError, match=r"has no engine 'kinematic'\. It has: pymunk$"
    ):
        rl.make_env("giraff_wander_1k", engine="kinematic")
