"""The arms without PyBullet: PyBullet's gripper where nothing is touched, and a word where they stand in."""

import math
import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import rlrobot_edu as rl
from rlrobot_edu.installing import to_install
from rlrobot_edu.robots.arm.arm_body import HOME, Angles, joints, link_poses
from rlrobot_edu.robots.arm.kinematic_arm import KinematicArm, gripper
from rlrobot_edu.robots.arm.kinematic_manipulator import KinematicManipulator
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS, WHEELS

TASKS = ["arm_1k", "arm_4k", "mobile_arm_2k"]
STILL = dict.fromkeys(JOINTS, 0.0)
LIMITS = {"arm": (-0.7, 0.7), "biceps": (0.4, 1.03), "forearm": (0.0, 0.66)}


def place(readings, name="gripper"):
    return np.array([readings[f"{name}_{axis}"] for axis in "xyz"])


def angles(readings):
    return np.array([readings[joint] for joint in JOINTS])


def actions(env, steps, seed=0):
    return np.random.default_rng(seed).integers(env.action_space.n, size=steps).tolist()


def test_the_formula_for_the_gripper_agrees_with_the_chain_of_transforms_in_the_urdf_file():
    low, high = np.transpose([joints()[joint].limits for joint in JOINTS])
    for some in np.random.default_rng(0).uniform(low, high, (200, 3)):
        assert gripper(*some) == pytest.approx(
            link_poses(Angles(*some))["gripper"][:3, 3], abs=1e-12
        )


@pytest.mark.parametrize("task", ["arm_1k", "arm_4k"])
def test_where_nothing_was_touched_the_gripper_is_that_of_pybullet_to_a_tenth_of_a_millimetre(
    task,
):
    pytest.importorskip("pybullet")
    physics, geometry = (
        rl.make_env(task, seed=0, engine=engine) for engine in ("pybullet", "kinematic")
    )
    farthest, free, touched = 0.0, 0, 0
    for episode in range(4):
        its, mine = (env.reset()[1]["readings"] for env in (physics, geometry))
        for a in actions(physics, 120, seed=episode):
            its, mine = (env.step(a)[-1]["readings"] for env in (physics, geometry))
            if (
                np.abs(angles(its) - angles(mine)).max() > 0.0002
            ):  # held up: from now on the two go different ways
                touched += 1
                break
            farthest = max(farthest, np.linalg.norm(place(its) - place(mine)))
            free += 1
    assert farthest < 1e-4 and free > 20 and touched, "none was held up, or all at once"


def test_the_manipulators_gripper_moves_as_pybullets_to_two_millimetres_as_long_as_the_base_stands():
    pytest.importorskip("pybullet")
    physics, geometry = (
        rl.make_env("mobile_arm_2k", engine=engine).robot
        for engine in ("pybullet", "kinematic")
    )
    command = dict.fromkeys(ROBOTS["mobile_manipulator"].commands, 0.0)
    for arm, forearm in np.random.default_rng(1).uniform(-0.3, 0.3, (10, 2)):
        turn = command | {"arm": arm, "forearm": forearm}
        physics.reset(), geometry.reset()
        its, mine = physics.act(turn), geometry.act(turn)
        assert (
            np.linalg.norm(place(its) - place(mine)) < 0.002
        )  # PyBullet's base rocks, and turns a little
        assert angles(its) == pytest.approx(angles(mine), abs=0.002)
    drawn, real = (
        {solid.name for solid in robot.scene().solids} for robot in (geometry, physics)
    )
    assert drawn == real


def test_the_scene_is_that_of_pybullet():
    there = pytest.importorskip(
        "rlrobot_edu.robots.arm.bullet_arm",
        reason="needs PyBullet",
        exc_type=ImportError,
    )
    arms = [kind("table", 1.0) for kind in (there.Arm, KinematicArm)]
    for arm in arms:
        arm.reset(np.random.default_rng(3))
        arm.act({"arm": 0.3, "biceps": -0.2, "forearm": 0.1})
    its, mine = (arm.scene() for arm in arms)
    assert its.bounds == mine.bounds and len(its.solids) == len(mine.solids)
    for one, other in zip(its.solids, mine.solids, strict=True):
        assert (one.name, one.shape, one.role) == (other.name, other.shape, other.role)
        assert one.size == pytest.approx(other.size) and one.pose[:2] == pytest.approx(
            other.pose[:2], abs=1e-4
        )


@pytest.mark.parametrize(
    "robot", [KinematicArm("table", 1.0), KinematicManipulator("table_room", 1.0)]
)
def test_joints_turn_by_speed_times_time_and_stop_at_their_limits(robot):
    still = STILL | (
        dict.fromkeys(WHEELS, 0.0) if isinstance(robot, KinematicManipulator) else {}
    )
    for joint, (low, high) in LIMITS.items():
        for way in (-1.0, 1.0):
            before = robot.reset()
            after = robot.act(still | {joint: 0.1 * way})
            assert after[joint] - before[joint] == pytest.approx(0.1 * way)
            assert all(
                after[other] == before[other] for other in JOINTS if other != joint
            )
            for _ in range(3):
                after = robot.act(still | {joint: way})
            assert after[joint] == (high if way > 0 else low)


def test_to_and_fro_leads_back_to_the_very_same_place_however_often():
    arm = KinematicArm("table", 1.0)
    first = arm.reset()
    for _ in range(1000):
        arm.act(STILL | {"arm": 0.14, "forearm": 0.13})
        last = arm.act(STILL | {"arm": -0.14, "forearm": -0.13})
    assert last == first and tuple(first[joint] for joint in JOINTS) == HOME


def test_nothing_stops_the_gripper_neither_the_object_nor_the_table():
    arm = KinematicArm("table", 1.0)
    lowest = min(
        place(arm.act(STILL | {"biceps": 0.1, "forearm": 0.1}))[2] for _ in range(9)
    )
    assert lowest < 0


def test_the_arm_rides_on_the_base_and_the_base_drives_as_it_would_alone():
    robot, rng = KinematicManipulator("table_room", 1.0), np.random.default_rng(2)
    for _ in range(100):
        wheels, speeds = rng.uniform(-2, 2, 2), rng.uniform(-0.3, 0.3, 3)
        command = dict(
            zip(("left_wheel", "right_wheel", *JOINTS), (*wheels, *speeds), strict=True)
        )
        readings = robot.act(command)
        out, aside, up = gripper(*angles(readings))
        heading, ahead = readings["theta"], 0.045 + 0.06 + out
        x = readings["x"] + ahead * math.cos(heading) - aside * math.sin(heading)
        y = readings["y"] + ahead * math.sin(heading) + aside * math.cos(heading)
        assert place(readings) == pytest.approx([x, y, 0.24 + up])
        solids = {solid.name: solid.pose for solid in robot.scene().solids}
        palm = solids["robot/gripper"]
        assert palm[:3, 3] + 0.065 * palm[:3, 0] == pytest.approx(place(readings))
        assert place(readings, "object") == pytest.approx(solids["object"][:3, 3])


@pytest.mark.parametrize("task", TASKS)
def test_gymnasium_finds_nothing_wrong_with_it_and_it_says_who_simulates(task):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(f"rlrobot/{task}-v0", engine="kinematic").unwrapped
        check_env(env, skip_render_check=True)
    assert env.engine == "kinematic"


def test_a_weakness_that_needs_physics_and_an_engine_that_is_not_there_are_refused():
    with pytest.raises(ValueError, match="lag has nothing to act on"):
        rl.make_env("mobile_arm_2k", engine="kinematic", realism=rl.Realism(lag=0.1))
    with pytest.raises(
        ValueError, match=r"has no engine 'pymunk'.*pybullet, kinematic"
    ):
        rl.make_env("arm_1k", engine="pymunk")
    with pytest.raises(ValueError, match=r"has no engine 'kinematic'.*pymunk"):
        rl.compare("giraff_wander_simple", ["Q+SR"], 1, steps=10, engine="kinematic")


def test_a_comparison_keeps_in_its_store_who_simulated_the_arm(tmp_path):
    def final(engine):
        result = rl.compare(
            "arm_1k",
            ["Q+SR"],
            2,
            episodes=1,
            engine=engine,
            store=tmp_path,
            n_jobs=1,
            progress=False,
        )
        return result["Q+SR"][1].rewards

    first = final("kinematic")
    assert np.array_equal(final("kinematic"), first)
    alone = rl.repeat(
        "arm_1k",
        "Q+SR",
        repetitions=1,
        episodes=1,
        engine="kinematic",
        n_jobs=1,
        progress=False,
    )
    assert len(alone[0].rewards) == 120
    pytest.importorskip("pybullet")
    with pytest.raises(ValueError, match="engine"):
        final(None)


WITHOUT = """
import sys
import warnings
sys.modules["pybullet"] = None  # importing it fails
import rlrobot_edu as rl
for name in ("wander_1k", "arm_1k", "mobile_arm_2k", "arm_1k"):
    env = rl.make_env(name, seed=0)
    env.reset()
    print(env.engine, env.step(0)[0])
try:
    rl.make_env("arm_1k", engine="pybullet")
except ImportError as error:
    print(error)
"""


def test_without_pybullet_the_kinematic_arm_stands_in_and_says_so_once_and_who_asks_for_pybullet_is_told_what_to_do():
    run = subprocess.run(
        [sys.executable, "-c", WITHOUT], capture_output=True, text=True, check=True
    )
    *engines, refusal = run.stdout.splitlines()
    assert [line.split()[0] for line in engines] == [
        "pymunk",
        "kinematic",
        "kinematic",
        "kinematic",
    ]
    assert to_install("arm") in refusal
    assert "engine='kinematic'" in run.stderr and len(run.stderr.splitlines()) == 1


def test_in_a_notebook_the_note_is_no_error():
    """There stderr is shown in red."""
    program = (
        "import sys, types\nsys.modules['ipykernel'] = types.ModuleType('x')" + WITHOUT
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert run.stderr == ""
    notes = [line for line in run.stdout.splitlines() if line.startswith("Note: arms")]
    assert len(notes) == 1 and "engine='kinematic'" in notes[0]


def test_nobody_can_change_the_joints_of_all_arms():
    joint = joints()["arm"]
    with pytest.raises(ValueError, match="read-only"):
        joint.origin[2, 3] = 9.0
    with pytest.raises(TypeError):
        joints()["arm"] = joint
