"""Walls that hold the kinematic base: it goes where pymunk's goes, and what one contact allows is what Coulomb says."""

import copy
import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest
import walls_that_hold as study
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats
from test_mobile_base import deepest, speeds, wheels

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS, Arena, Wall
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
from rlrobot_edu.robots.engines.kinematic.holding import (
    HELD,
    LEVER,
    NORMAL_X,
    NORMAL_Y,
    PUSHED,
    SIDE_LEVER,
    settle,
)
from rlrobot_edu.robots.mobile_base import MobileBase

VREP = rl.Realism.vrep()
MOTIONS = {tuple(command.values()) for command in rl.load_task("wander_1k").commands}


def at_a_wall(kind, degrees, motion, realism=VREP, steps=12):
    """Where a robot that has met a wall at this angle is after each step, array (steps + 1, 3)."""
    start = (0.6, 0.0, math.radians(degrees))
    wall = Wall(1.0, 0.0, 20.0, angle=math.pi / 2)
    robot = kind("maze_6x6", 1.0, realism=realism)
    robot.arena = Arena((wall,), (-9, -9, 9, 9), start)
    robot.reset()
    places = []
    for command in [(1.0, 1.0)] * 2 + [motion] * steps:
        readings = robot.act(wheels(*command))
        places.append([readings["x"], readings["y"], readings["theta"]])
    return np.array(places[1:])


@pytest.mark.parametrize("motion", sorted(MOTIONS))
@pytest.mark.parametrize("degrees", range(0, 91, 10))
def test_at_a_wall_each_step_moves_and_turns_it_as_in_pymunk(degrees, motion):
    ways = []
    for kind in (MobileBase, KinematicBase):
        places = at_a_wall(kind, degrees, motion)
        places[:, 2] = np.unwrap(places[:, 2])
        ways.append(np.diff(places, axis=0))
    apart = np.abs(ways[0] - ways[1])
    assert apart[:, :2].max() < 0.005
    assert apart[:, 2].max() < 0.03
    assert apart.sum(axis=0).max() < 0.1


@pytest.mark.parametrize("degrees", [20, 40, 60])
def test_it_turns_to_the_wall_and_is_held_where_an_ideal_robot_slides(degrees):
    held = at_a_wall(KinematicBase, degrees, (2.0, 2.0))
    ideal = at_a_wall(KinematicBase, degrees, (2.0, 2.0), rl.Realism())
    last_step = [math.dist(way[-1][:2], way[-2][:2]) for way in (held, ideal)]
    assert last_step[0] < 0.003 and last_step[1] > 0.06
    assert held[-1][2] == pytest.approx(0.0, abs=0.05)
    assert ideal[-1][2] > 0.3  # one of its sides lies on the wall


unit = st.floats(-1, 1)


@settings(max_examples=200, deadline=None)
@given(
    st.floats(-3.2, 3.2),
    st.tuples(unit, unit),
    st.tuples(unit, unit, unit),
    st.floats(0.05, 0.72),
)
def test_one_contact_goes_no_deeper_and_is_held_or_slides_as_coulomb_says(
    angle, point, wanted, friction
):
    nx, ny = math.cos(angle), math.sin(angle)
    px, py = 0.25 * np.array(point)
    moment, contacts = 0.03, np.zeros((1, 7))
    contacts[0, [NORMAL_X, NORMAL_Y]] = nx, ny
    contacts[0, LEVER], contacts[0, SIDE_LEVER] = px * ny - py * nx, px * nx + py * ny
    motion = np.array(wanted) * (0.01, 0.01, 0.03)
    settle(motion, contacts, 1, friction, moment, 0.0)
    push, hold = contacts[0, PUSHED], contacts[0, HELD]
    out = motion @ (nx, ny, contacts[0, LEVER])
    aside = motion @ (-ny, nx, contacts[0, SIDE_LEVER])
    small = 1e-5
    assert push >= 0.0 and abs(hold) <= friction * push + small
    assert out >= -small and (push < small or out < small)  # it leaves, or is pushed
    if (
        abs(aside) > small and push > small
    ):  # it slides: the hold is as strong as can be
        assert hold == pytest.approx(-math.copysign(friction * push, aside), abs=small)


@settings(max_examples=40, deadline=None)
@given(
    st.sampled_from(["square_2x2", "maze_6x6", "maze_4x4_goal"]),
    st.lists(st.tuples(speeds, speeds), max_size=30),
)
def test_the_hull_is_never_deeper_in_a_wall_than_it_drives_in_two_pieces(
    scene, commands
):
    robot = KinematicBase(scene, 1.0, realism=VREP)
    for left, right in commands:
        readings = robot.act(wheels(left, right))
        assert deepest(ARENAS[scene], PIONEER, readings) < 0.02
    for _ in range(2):  # at rest, the wall brings it back
        readings = robot.act(wheels(0, 0))
    assert deepest(ARENAS[scene], PIONEER, readings) < 0.0015


PLAIN = """
import sys
sys.path.insert(0, sys.argv[1])
import rlrobot_edu as rl
from test_mobile_base import fingerprint_of_a_run
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
print(fingerprint_of_a_run(KinematicBase("maze_6x6", 1.0, realism=rl.Realism.vrep())))
"""


def test_compiled_or_plain_the_readings_are_the_same_to_the_last_bit():
    run = [sys.executable, "-c", PLAIN, os.path.dirname(__file__)]
    said = []
    for plain in ("0", "1"):
        env = {**os.environ, "NUMBA_DISABLE_JIT": plain}
        said.append(subprocess.run(run, env=env, capture_output=True, text=True))
    assert said[0].stdout == said[1].stdout != "", said[1].stderr


def test_a_copy_goes_on_to_the_last_bit_with_the_command_that_was_late():
    robot = KinematicBase("maze_4x4_goal", 1.0, realism=VREP)
    rng = np.random.default_rng(0)
    for left, right in rng.choice([2.0, 2.0, -1.0], (100, 2)):
        twin = copy.deepcopy(robot)
        assert twin.act(wheels(left, right)) == robot.act(wheels(left, right))


@pytest.mark.parametrize("weakness", ["lag", "wall_friction"])
def test_an_arm_or_a_manipulator_has_neither_lag_nor_walls_that_hold(weakness):
    for task in ("arm_1k", "mobile_arm_2k"):
        with pytest.raises(
            ValueError, match=f"{weakness} has nothing to act on: it needs a base"
        ):
            rl.make_env(task, engine="kinematic", realism=rl.Realism(**{weakness: 0.1}))


PYMUNK = json.loads(study.NUMBERS.read_text(encoding="utf-8"))["pymunk"]


@pytest.fixture(scope="module")
def fresh():
    """Kinematic robots whose seeds neither the kernels nor the page have seen."""
    return study.runs("kinematic", range(9000, 9060))


@pytest.mark.long
def test_the_methods_earn_what_they_earn_in_pymunk(fresh):
    for method, its in PYMUNK.items():
        rewards = fresh[method]["rewards"]
        low, high = study.mean_band(np.array(its["rewards"]))
        assert low <= np.mean(rewards) <= high, method
        p = stats.ttest_ind(rewards, its["rewards"], equal_var=False).pvalue
        assert p > 0.01, method


@pytest.mark.long
def test_methods_that_differ_in_pymunk_differ_in_the_same_direction(fresh):
    pairs = study.significant_pairs({m: its["rewards"] for m, its in PYMUNK.items()})
    assert len(pairs) > 5
    for better, worse in pairs:
        assert np.mean(fresh[better]["rewards"]) > np.mean(fresh[worse]["rewards"])


@pytest.mark.long
def test_walls_are_met_as_often_as_in_pymunk(fresh):
    here, there = [], []
    for method, its in PYMUNK.items():
        here.append(np.mean(fresh[method]["contacts"]))
        there.append(np.mean(its["contacts"]))
        # one method's share scatters by more than a tenth of itself between such groups of robots
        test = stats.ttest_ind(
            fresh[method]["contacts"], its["contacts"], equal_var=False
        )
        assert test.pvalue > 0.01, method
    assert np.mean(here) == pytest.approx(np.mean(there), rel=0.1)


def test_on_the_page_each_method_meets_walls_as_often_as_in_pymunk_within_a_tenth():
    numbers = json.loads(study.NUMBERS.read_text(encoding="utf-8"))
    for method, its in numbers["pymunk"].items():
        here = np.mean(numbers["kinematic"][method]["contacts"])
        assert here == pytest.approx(np.mean(its["contacts"]), rel=0.1), method


def test_the_page_says_what_its_numbers_say():
    numbers = json.loads(study.NUMBERS.read_text(encoding="utf-8"))
    page = study.PAGE.read_text(encoding="utf-8")
    assert study.in_page(page, study.table(numbers)) == page
