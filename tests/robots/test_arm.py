"""The arm against geometry: closed-form kinematics, limits, speeds, and runs that repeat."""

import math

import numpy as np
import psutil
import pytest

import rlrobot_edu as rl
from rlrobot_edu.robots.arm.arm_body import HOME, OBJECT_PLACE
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS

there = pytest.importorskip(
    "rlrobot_edu.robots.arm.bullet_arm",
    reason="PyBullet simulates the arm; it has no wheel for this Python or platform",
    exc_type=ImportError,
)
Arm = there.Arm
STILL = dict.fromkeys(JOINTS, 0.0)
TASKS = ["arm_1k", "arm_4k"]


def gripper(readings):
    return np.array([readings[f"gripper_{axis}"] for axis in "xyz"])


def forward_kinematics(arm, biceps, forearm):
    """Where the point between the fingertips is, by trigonometry on the lengths in arm.urdf [m]."""
    lean, bend = (
        biceps,
        biceps + math.pi / 2 + forearm,
    )  # of upper and lower arm, from the vertical
    out = 0.23 * math.sin(lean) + 0.25 * math.sin(bend)
    return [
        out * math.cos(arm),
        out * math.sin(arm),
        0.12 + 0.23 * math.cos(lean) + 0.25 * math.cos(bend),
    ]


def random_commands(seed, n, fastest=0.3):
    return [
        dict(zip(JOINTS, v, strict=True))
        for v in np.random.default_rng(seed).uniform(-fastest, fastest, (n, 3))
    ]


@pytest.fixture(scope="module")
def arm():
    return Arm("table", 1.0)


def test_the_gripper_is_where_trigonometry_says_to_a_millimetre(arm):
    places = [arm.reset(), *(arm.act(command) for command in random_commands(0, 200))]
    for readings in places:
        exact = forward_kinematics(*(readings[joint] for joint in JOINTS))
        assert np.linalg.norm(gripper(readings) - exact) < 0.001
    assert np.ptp([gripper(readings) for readings in places], axis=0).min() > 0.1, (
        "it hardly moved"
    )


def test_no_joint_passes_its_limits_however_hard_it_is_driven(arm):
    limits = {"arm": (-0.7, 0.7), "biceps": (0.4, 1.03), "forearm": (0.0, 0.66)}
    for way in (-1.0, 1.0):
        for joint, (low, high) in limits.items():
            arm.reset()
            arm.act(STILL | {"biceps": -0.5})  # raised, so that nothing is in its way
            for _ in range(4):
                angle = arm.act(STILL | {joint: way})[joint]
                assert low - 0.03 < angle < high + 0.03
            if (joint, way) != (
                "biceps",
                1.0,
            ):  # leaning forward, the gripper may meet the table first
                assert angle == pytest.approx(high if way > 0 else low, abs=0.001)


@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize("speed", [-0.1, 0.05])
def test_a_joint_turns_at_the_speed_it_is_told_and_the_others_hold_still(
    arm, joint, speed
):
    before = arm.reset()
    after = arm.act(STILL | {joint: speed})
    for other in JOINTS:
        assert after[other] - before[other] == pytest.approx(
            speed if other == joint else 0.0, abs=0.002
        )


def test_an_arm_at_rest_does_not_sink(arm):
    before = arm.reset()
    for _ in range(60):
        after = arm.act(STILL)
    assert np.linalg.norm(gripper(after) - gripper(before)) < 1e-4
    assert [after[joint] for joint in JOINTS] == pytest.approx(HOME, abs=1e-4)


def test_a_step_of_any_duration_turns_the_joints_by_speed_times_time():
    assert Arm("table", 0.5).act(STILL | {"arm": 0.4})["arm"] == pytest.approx(
        HOME[0] + 0.2, abs=0.002
    )


def test_one_step_of_the_tasks_moves_the_gripper_by_about_a_bin():
    for output in rl.load_task("arm_4k").outputs:
        arm = Arm("table", 1.0)
        way = max(output.values) * (-1 if output.name == "biceps" else 1)
        moved = np.linalg.norm(
            gripper(arm.act(STILL | {output.name: way}))
            - gripper(Arm("table", 1.0).readings)
        )
        assert 0.025 < moved < 0.05


def test_the_object_keeps_its_place():
    env = rl.make_env("arm_1k", seed=1)
    readings = [env.reset()[1]["readings"] for _ in range(5)]
    assert all(
        [r["object_x"], r["object_y"]] == list(OBJECT_PLACE[:2]) for r in readings
    )


@pytest.mark.long
def test_two_hundred_arms_that_are_made_and_closed_or_dropped_leave_nothing_behind():
    process, sizes = psutil.Process(), []
    for i in range(200):
        env = rl.make_env("arm_1k", seed=0)
        env.reset()
        if i % 2:
            env.close()
            env.close()
        del env
        if i in (50, 199):
            sizes.append(process.memory_info().rss)
    assert sizes[1] - sizes[0] < 5e6
    env = rl.make_env("arm_1k", seed=0)
    assert env.reset() is not None and env.unwrapped.robot._simulation._client <= 20, (
        "clients of PyBullet were kept"
    )


def test_a_closed_world_begins_anew_with_reset_alone():
    env = rl.make_env("arm_1k", seed=0)
    first = env.reset()[1]
    env.close()
    with pytest.raises(Exception, match="reset"):
        env.step(0)
    assert env.reset()[1] == first


@pytest.mark.parametrize(
    "command", [{"arm": 0.1}, STILL | {"biceps": math.nan}, STILL | {"arm": 1.5}]
)
def test_a_command_that_cannot_be_carried_out_is_refused_and_moves_nothing(
    arm, command
):
    before = arm.reset()
    with pytest.raises(ValueError, match="command"):
        arm.act(command)
    assert arm.readings == before


def test_the_scene_shows_every_link_where_the_readings_say(arm):
    readings = arm.act(STILL | {"arm": 0.3})
    assert set(readings) == set(ROBOTS["arm"].sensors)
    solids = {solid.name: solid for solid in arm.scene().solids}
    assert len(solids) == len(arm.scene().solids) == 11
    palm = solids["robot/body"].pose
    assert palm[:3, 3] + 0.065 * palm[:3, 0] == pytest.approx(
        gripper(readings), abs=1e-5
    )
    assert solids["object"].pose[:3, 3] == pytest.approx(OBJECT_PLACE)
    for solid in solids.values():
        assert solid.pose[:3, :3] @ solid.pose[:3, :3].T == pytest.approx(
            np.eye(3), abs=1e-6
        )
