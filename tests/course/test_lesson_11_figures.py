"""Lesson 11's figures say what the numbers say."""

import math

import numpy as np
import pytest
from matplotlib.patches import Wedge

import rlrobot_edu as rl
from rlrobot_course.lesson_11.exercises import motion
from rlrobot_course.lesson_11.motions import (
    in_words,
    motion_of,
    motions_finding,
    path_of,
)
from rlrobot_course.lesson_11.rings import (
    Moment,
    plot_rings,
    rings_finding,
    rings_of,
    style_of,
)
from rlrobot_course.lesson_11.situations import (
    most_visited,
    one_of_each,
    plot_policy,
    policy_finding,
)
from rlrobot_edu.robots.mobile_base import MobileBase


@pytest.mark.parametrize("name", ["wander_simple", "wander_1k", "wander_4k"])
def test_the_filled_bins_are_those_of_the_state_and_the_reading_lies_in_them(name):
    task, env = rl.load_task(name), rl.make_env(name, seed=0)
    env.reset()
    robot = env.unwrapped.robot
    picture = plot_rings([Moment(robot.scene(), robot.readings)], task)
    bins = task.states.bins(env.unwrapped.state)
    filled = [
        p
        for p in picture.axes[0].patches
        if isinstance(p, Wedge) and p.get_facecolor()[3] > 0
    ]
    for variable, seen, wedge in zip(task.inputs, bins, filled, strict=True):
        low, high = rings_of(variable)[seen]
        assert (wedge.r - wedge.width, wedge.r) == pytest.approx((low, high))
        assert low < robot.readings[variable.name] and (
            robot.readings[variable.name] <= high or seen == len(variable.cuts)
        )
    wedges = [p for p in picture.axes[0].patches if isinstance(p, Wedge)]
    assert len(wedges) == sum(v.n_bins for v in task.inputs)


def test_bins_differ_by_colour_and_by_hatching():
    styles = [style_of(i, 5) for i in range(5)]
    assert (
        len({colour for colour, _ in styles})
        == len({hatch for _, hatch in styles})
        == 5
    )


@pytest.mark.parametrize("name", ["wander_simple", "wander_1k", "wander_4k"])
def test_every_action_moves_the_robot_as_its_arrow_says(name):
    task, env = rl.load_task(name), rl.make_env(name, seed=0)
    for a in range(task.actions.n):
        env.reset()
        before = env.unwrapped.robot.readings
        env.step(a)
        after, (v, turn) = env.unwrapped.robot.readings, motion_of(task, a, motion)
        turned = math.degrees(
            math.remainder(after["theta"] - before["theta"], 2 * math.pi)
        )
        assert turned == pytest.approx(turn, abs=1e-6)
        axle = [np.array([r["x"], r["y"]]) + 0.045 * np.array([math.cos(r["theta"]), math.sin(r["theta"])])
                for r in (before, after)]  # fmt: skip
        assert axle[1] - axle[0] == pytest.approx(
            path_of(v, turn, task.step_time)[-1], abs=1e-6
        )


def test_motions_have_names():
    names = {(0.0, 0.0): "stands still", (0.1, 0.0): "forward", (-0.1, 0.0): "backward", (0.0, 34.0): "spins left",
             (0.0, -34.0): "spins right", (0.05, 17.0): "curves left", (0.05, -17.0): "curves right"}  # fmt: skip
    assert {speeds: in_words(*speeds) for speeds in names} == names


def test_the_policy_shows_visited_states_only_the_most_frequent_first():
    task, rng = rl.load_task("wander_simple"), np.random.default_rng(0)
    visits, q = np.zeros((4, 4), dtype=int), rng.normal(size=(4, 4))
    visits[[3, 1, 1, 2], [0, 1, 2, 3]] = 70, 5, 15, 10
    assert most_visited(visits, 12) == [3, 1, 2] and most_visited(visits, 2) == [3, 1]
    found = one_of_each(task, q, visits, motion)
    picture = plot_policy(task, q, visits, motion)
    shown = [ax for ax in picture.axes if ax.get_visible()]
    assert len(shown) == len(found) == len(set(found.values()))
    assert next(iter(found)) == 3 and "state 3 (70.0% of steps)" in picture.alt


def test_the_title_of_a_policy_says_what_is_near_and_what_is_done():
    task = rl.load_task("wander_1k")
    assert policy_finding(task, 15, "forward, slow") == (
        "A wall at its front, front left and left, and yet it drives on: its most frequent situation"
    )
    assert "front, front left and left" in policy_finding(task, 15, "stands still")
    assert "yet" not in policy_finding(task, 15, "stands still")
    assert policy_finding(task, 1023, "stands still").startswith(
        "Most often nothing is near"
    )


def test_the_titles_of_motions_and_rings_are_counted():
    task, env = rl.load_task("wander_1k"), rl.make_env("wander_1k", seed=0)
    said = motions_finding(task, motion)
    assert said == "9 actions make 7 different motions; 3 of them stand still"
    assert "9 actions make 1 different" in motions_finding(task, lambda *_: (0.0, 0.0))
    robot, moments = env.unwrapped.robot, []
    env.reset()
    for a in (8, 8):
        moments.append(Moment(robot.scene(), robot.readings))
        env.step(a)
    assert rings_finding(moments, task).startswith("It has moved 10 cm")
    s = task.states.encode(moments[0].readings)
    assert rings_finding(moments[:1], task).endswith(f"one number, state {s}")


@pytest.mark.parametrize("angle", [20, 30, 40, 50, 60, 70])
@pytest.mark.parametrize("holds", [False, True])
def test_friction_turns_a_robot_to_the_wall_at_which_it_is_driven(angle, holds):
    robot = MobileBase(
        "maze_4x4_goal", 1.0, realism=rl.Realism.vrep() if holds else None
    )
    robot.arena = robot.arena._replace(start=(-1.2, -1.4, math.radians(-angle)))
    robot.reset()
    way = [robot.act({"left_wheel": 2.0, "right_wheel": 2.0}) for _ in range(13)]
    slid = math.hypot(way[-1]["x"] - way[-2]["x"], way[-1]["y"] - way[-2]["y"])
    faces = math.degrees(way[-1]["theta"]) == pytest.approx(-90, abs=1)
    assert (slid < 0.005 and faces) if holds else (slid > 0.06 and not faces)
