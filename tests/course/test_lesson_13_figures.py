"""Lesson 13: the arm of geometry is the arm."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.arm_world import ArmWorld
from rlrobot_course.lesson_13 import exercises
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
        assert mine["state"] == its["state"] and mine["readings"] == pytest.approx(its["readings"], abs=1e-12)
        (*_, mine), (*_, its) = world.step(a), engine.step(a)
    assert [s.name for s in world.robot.scene().solids] == [s.name for s in engine.robot.scene().solids]


def test_no_step_is_so_close_to_a_limit_that_rounding_decides(world):
    distance, places = world.places.distance, world.places
    change = np.abs(distance[places.next] - distance[:, None])
    assert min(np.abs(change - 0.02).min(), np.abs(distance - 0.05).min()) > 1e-6
