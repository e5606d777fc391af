"""The mobile manipulator: base and arm in one body drive, reach, sense and repeat."""

import math

import numpy as np
import pytest
from test_mobile_base import deepest, exact_lasers

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.task.robot_cards import JOINTS, LASERS, ROBOTS

there = pytest.importorskip(
    "rlrobot_edu.robots.arm.bullet_manipulator",
    reason="PyBullet simulates this robot; it has no wheel for this Python or platform",
    exc_type=ImportError,
)
MobileManipulator, ROOM = there.MobileManipulator, ARENAS["table_room"]
STILL = dict.fromkeys(ROBOTS["mobile_manipulator"].commands, 0.0)


@pytest.fixture(scope="module")
def robot():
    return MobileManipulator("table_room", 1.0)


def distance(readings):
    return math.dist(
        *(
            [readings[f"{part}_{axis}"] for axis in "xyz"]
            for part in ("gripper", "object")
        )
    )


def random_commands(seed, n):
    names = ("left_wheel", "right_wheel", *JOINTS)
    values = np.random.default_rng(seed).uniform(
        (-1, -1, -0.3, 0, -0.2), (2, 2, 0.3, 0, 0.2), (n, 5)
    )
    return [dict(zip(names, row, strict=True)) for row in values]


def test_it_senses_with_all_the_sensors_of_base_and_arm(robot):
    assert set(robot.reset()) == set(ROBOTS["mobile_manipulator"].sensors)


def test_the_gripper_is_where_base_and_joints_say_in_the_frame_of_the_world(robot):
    for readings in [
        robot.reset(),
        *(robot.act(command) for command in random_commands(0, 40)),
    ]:
        arm, lean, forearm = (readings[joint] for joint in JOINTS)
        bend = lean + math.pi / 2 + forearm
        out, heading = 0.23 * math.sin(lean) + 0.25 * math.sin(bend), readings["theta"]
        x = (
            readings["x"]
            + (0.045 + 0.06) * math.cos(heading)
            + out * math.cos(heading + arm)
        )
        y = (
            readings["y"]
            + (0.045 + 0.06) * math.sin(heading)
            + out * math.sin(heading + arm)
        )
        z = 0.36 + 0.23 * math.cos(lean) + 0.25 * math.cos(bend)
        assert (
            math.dist((x, y, z), [readings[f"gripper_{axis}"] for axis in "xyz"]) < 0.01
        )  # it rocks a little


def test_the_lasers_see_walls_and_table_and_not_the_arm(robot):
    robot.reset()
    for command in random_commands(1, 40):
        readings = robot.act(command)
        exact = exact_lasers(ROOM, PIONEER, readings)
        assert [readings[laser] for laser in LASERS] == pytest.approx(exact, abs=1e-9)


def test_driven_well_it_reaches_the_object_on_the_table(robot):
    readings = robot.reset()
    for _ in range(60):
        to_object = math.atan2(
            readings["object_y"] - readings["y"], readings["object_x"] - readings["x"]
        )
        off = math.remainder(to_object - readings["theta"], 2 * math.pi)
        ahead = 1.0 if readings["x"] < 0.72 else 0.0
        turn = max(-0.8, min(0.8, off))
        arm = max(-0.3, min(0.3, off - readings["arm"])) if not ahead else 0.0
        wheels = {"left_wheel": ahead - turn, "right_wheel": ahead + turn}
        readings = robot.act(STILL | wheels | {"arm": arm})
        if distance(readings) <= 0.20:
            break
    assert distance(readings) <= 0.20


@pytest.mark.long
def test_it_never_falls_over_and_enters_no_wall(robot):
    robot.reset()
    for command in random_commands(2, 400):
        readings = robot.act(command)
        assert deepest(ROOM, PIONEER, readings) < 0.01
        assert readings["gripper_z"] > 0.2


def test_the_scene_shows_room_table_object_and_every_part_of_the_robot(robot):
    picture = robot.scene()
    names = [solid.name for solid in picture.solids]
    assert len(set(names)) == len(names)
    assert {
        "object",
        "robot/body",
        "robot/nose",
        "robot/left_wheel",
        "robot/upper_arm",
        "robot/gripper",
    } <= set(names)
    assert picture.beams.shape == (8, 2, 3)


@pytest.mark.long
def test_every_bin_of_the_task_is_reached_and_every_reward_is_listed():
    env, seen, over = rl.make_env("mobile_arm_2k", seed=0), [], True
    assert env.task.states.n == 2048
    for action in (
        np.random.default_rng(0).integers(env.action_space.n, size=1200).tolist()
    ):
        if over:
            env.reset()
        observation, _, _, over, _ = env.step(
            action
        )  # a reward that is not listed raises
        seen.append(observation)
    for variable, bins in zip(env.task.inputs, np.array(seen).T, strict=True):
        assert len(set(bins)) == variable.n_bins
