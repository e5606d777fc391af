"""Lesson 13: the arm of geometry is the arm, the best loop is the best, the last episodes are those of the agents."""

from itertools import permutations

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_13 import check, exercises
from rlrobot_course.lesson_13.arm_figure import plot_arm
from rlrobot_course.lesson_13.figures import (
    episode_finding,
    places_finding,
    plot_episode,
    plot_places,
)
from rlrobot_course.lesson_13.loops import best_loop
from rlrobot_course.lesson_13.many import (
    Bounds,
    plot_many,
    stuck_finding,
    stuck_first,
)
from rlrobot_course.lesson_13.runs import last_episodes, last_path
from rlrobot_course.worlds.arm_world import ArmWorld, with_reward
from rlrobot_edu.robots.arm.kinematic_arm import gripper


@pytest.fixture(scope="module")
def world():
    return ArmWorld("arm_1k", exercises.gripper)


def test_the_learners_formula_says_what_the_engine_says_everywhere(world):
    for angles in world.places.angles:
        assert exercises.gripper(*angles) == pytest.approx(gripper(*angles), abs=1e-12)


def test_a_look_into_the_table_of_places_is_a_step_of_the_kinematic_arm(world):
    engine = rl.make_env("arm_1k", seed=0, engine="kinematic")
    mine, its = world.reset()[1], engine.reset()[1]
    for a in np.random.default_rng(0).integers(9, size=300).tolist():
        assert mine["state"] == its["state"] and mine["readings"] == pytest.approx(
            its["readings"], abs=1e-12
        )
        (*_, mine), (*_, its) = world.step(a), engine.step(a)
    assert [s.name for s in world.robot.scene().solids] == [
        s.name for s in engine.robot.scene().solids
    ]


def test_no_step_is_so_close_to_a_limit_that_rounding_decides(world):
    distance, places = world.places.distance, world.places
    change = np.abs(distance[places.next] - distance[:, None])
    assert min(np.abs(change - 0.02).min(), np.abs(distance - 0.05).min()) > 1e-6


def brute_force(following, rewards, allowed):
    """The largest mean over all simple loops of a small graph."""
    best, inside = -np.inf, np.flatnonzero(allowed)
    for n in range(1, len(inside) + 1):
        for way in permutations(inside, n):
            steps = [
                rewards[i, following[i] == j]
                for i, j in zip(way, way[1:] + way[:1], strict=True)
            ]
            if all(len(step) for step in steps):
                best = max(best, np.mean([step.max() for step in steps]))
    return best


@pytest.mark.parametrize("seed", range(6))
def test_the_best_loop_is_the_one_that_trying_all_finds(seed):
    rng = np.random.default_rng(seed)
    following, rewards = rng.integers(6, size=(6, 3)), rng.normal(size=(6, 3))
    allowed = rng.random(6) < 0.9
    following[:, 0] = np.flatnonzero(allowed)[0]  # so that there is a loop
    loop = best_loop(following, rewards, allowed)
    assert loop.pays == pytest.approx(brute_force(following, rewards, allowed))
    assert (
        np.mean(loop.rewards) == pytest.approx(loop.pays) and allowed[loop.places].all()
    )
    for i, j in zip(loop.places, loop.places[1:] + loop.places[:1], strict=True):
        assert j in following[i]


def test_what_the_lesson_says_of_its_loops(world):
    outside, task = world.places.distance > 0.05, world.task
    assert best_loop(world.places.next, world.rewards, outside).pays == pytest.approx(3)
    mended = ArmWorld(with_reward(task, exercises.arm_reward, "mended"))
    assert best_loop(mended.places.next, mended.rewards, outside).pays == pytest.approx(
        0, abs=1e-9
    )


def test_a_check_of_rewards_shows_the_loop_that_pays_and_refuses_what_is_no_number():
    verdict = check.arm_reward(
        lambda before, after: (
            10 if after <= 0.05 else 5 if before - after > 0.02 else -1
        )
    )
    assert "This loop pays 3 a step" in repr(verdict).replace("\n", " ")
    assert "Standing still" in repr(
        check.arm_reward(lambda before, after: 10 if after <= 0.05 else 0.1)
    )
    assert not check.arm_reward(lambda before, after: float("nan"))
    assert not check.arm_reward(
        lambda before, after: 10 if after <= 0.05 else 1 / (before - 0.2)
    )


def test_the_last_episodes_are_those_of_the_agents_and_their_path_pays_what_they_got(
    world,
):
    ends = last_episodes("arm_1k", arms=2, episodes=2, seed=4)
    agent = rl.Agent("arm_1k", seed=5)
    history = rl.learn(agent, world, steps=240, progress=False, keep=True)
    assert np.array_equal(ends.rewards[1], history.rewards[-120:])
    path, rewards = last_path(world, history.a[-120:])
    assert np.array_equal(rewards, history.rewards[-120:])
    assert (
        ends.contact[1]
        == np.mean(world.places.distance[path[1:]] <= 0.05)
        == np.mean(rewards == 10)
    )


def test_the_picture_of_the_places_counts_those_in_contact_and_says_where_the_shuttle_is(
    world,
):
    picture = plot_places(world.places, [0, 23, 32], "arm 7")
    assert (
        f"132 places from above, {(world.places.distance <= 0.05).sum()} of them in contact"
        in picture.alt
    )
    ends = [world.places.readings[i] for i in (23, 32)]
    assert all(
        f"x = {seen['gripper_x']:.2f}, y = {seen['gripper_y']:.2f} m" in picture.alt
        for seen in ends
    )


BOUNDS = Bounds(3, "below 3", 8, "above 8")
ARMS = {"good, one": [9.0, 9.5], "bad, one": [2.0, 1.0], "bad, two": [2.0, 9.0]}


def test_arms_are_sorted_by_how_many_are_stuck_and_the_title_counts_them():
    assert stuck_first(ARMS, BOUNDS) == ["bad, one", "bad, two", "good, one"]
    said = stuck_finding(ARMS, BOUNDS)
    assert said == "2 of 2 arms are below 3 with “bad, one”; with “good” none is"
    assert stuck_finding({"a": [4.0]}, BOUNDS) == "No arm is below 3"
    assert "in each row some are" in stuck_finding({"a": [1.0, 9.0]}, BOUNDS)
    picture = plot_many(ARMS, "reward", BOUNDS, {2.0: "two"})
    assert "bad, one: 2 arms from 1.00 to 2.00, 1 near 2" in picture.alt
    dots = sum(len(dots.get_offsets()) for dots in picture.axes[0].collections)
    assert dots == 6


def test_the_title_of_an_episode_says_whether_the_arm_goes_to_and_fro():
    to_and_fro = np.array([0.09, 0.13] * 5 + [0.09])
    paid = np.array([-1.0, 5.0] * 5)
    said = episode_finding("Arm 7", to_and_fro, paid)
    assert said == "Arm 7 goes to and fro between 9 and 13 cm, for 2 points a step"
    assert "stays in contact" in episode_finding("A", to_and_fro / 10, paid)
    assert "comes as near as 9 cm" in episode_finding("A", np.sort(to_and_fro), paid)


def test_an_episode_shows_its_last_ten_rewards(world):
    path = [0, *([23, 32] * 10)]
    picture = plot_episode(world.places, path, np.arange(20.0), "Arm 1")
    numbers = [text.get_text() for text in picture.axes[1].texts]
    assert [f"+{r}" for r in range(10, 20)] == numbers[:10]


def test_the_titles_of_the_places_and_of_the_arm_are_measured(world):
    touching = int(np.flatnonzero(world.places.distance <= 0.05)[0])
    assert places_finding(world.places, [0, 0], "it").endswith(
        "it ends in none of them"
    )
    assert "in and out" in places_finding(world.places, [0, touching], "it")
    finding = plot_arm(rl.load_task("arm_1k")).finding
    assert f"starts {100 * world.places.distance[0]:.0f} cm from" in finding
