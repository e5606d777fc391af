"""Every task on wheels: what it promises occurs, it can be learned with the default parameters, and it costs little."""

import functools
import gc
import math
import time

import numpy as np
import psutil
import pytest
from scipy.stats import ttest_ind

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.chassis import GIRAFF
from rlrobot_edu.robots.giraff import STOP_DISTANCE, Giraff
from rlrobot_edu.task.rewards import approach_reward, collision_reward, wander_reward
from rlrobot_edu.task.robot_cards import FRONT_LASERS
from rlrobot_edu.task.task_file import available_tasks
from rlrobot_edu.task.wheel_commands import no_reversing

# Steps after which ten repetitions (of the slow mobile manipulator, four) tell learning from chance
STEPS = {
    "worked_example": 600,
    "wander_simple": 600,
    "wander_1k": 1500,
    "wander_4k": 1500,
    "wander_12k": 1500,
    "navigation_1k": 3600,
    "giraff_wander_simple": 1000,
    "giraff_wander_1k": 2500,
    "giraff_wander_4k": 4500,
}
RARE = (
    "navigation_1k",
    "giraff_wander_simple",
)  # what a random policy meets only once in thousands of steps
ARM_STEPS = {
    "arm_1k": 600,
    "arm_4k": 1200,
    "mobile_arm_2k": 4500,
}  # the manipulator learns late
OTHERS = set(available_tasks()) - STEPS.keys() - ARM_STEPS.keys()
STEPS |= dict.fromkeys(sorted(OTHERS), 3000)  # enough for most new tasks


@functools.cache
def random_walk(name, engine=None):
    """The recording of a robot that acts at random, until it has met all there is."""
    steps = 2400 if name in ARM_STEPS else 20_000 if name in RARE else 6000
    return rl.record(
        rl.Agent(name, "Q+RANDOM", seed=0),
        rl.make_env(name, seed=0, engine=engine),
        steps=steps,
    )


@pytest.mark.long
@pytest.mark.parametrize("name", STEPS)
def test_a_random_policy_meets_each_bin_and_each_reward_or_the_task_says_why_not(name):
    task, walk = rl.load_task(name), random_walk(name)
    bins = np.stack(np.unravel_index(walk.s_next, task.states.shape), axis=1)
    empty = {
        variable.name
        for variable, n_bins, column in zip(
            task.inputs, task.states.shape, bins.T, strict=True
        )
        if (np.bincount(column, minlength=n_bins) == 0).any()
    }
    missing = set(task.rewards) - set(walk.r)
    assert not empty or "stay empty" in task.description, empty
    assert not missing or "does not occur" in task.description, missing


@pytest.mark.long
@pytest.mark.parametrize("name", ["arm_1k", "arm_4k"])
def test_a_random_policy_meets_each_bin_and_each_reward_of_an_arm_whose_object_stays_in_its_place(
    name,
):
    pytest.importorskip("pybullet", reason="PyBullet simulates this robot")
    task, walk = rl.load_task(name), random_walk(name)
    assert set(walk.r) == set(task.rewards) and not walk.terminated.any()
    for variable, bins in zip(
        task.inputs, np.unravel_index(walk.s_next, task.states.shape), strict=True
    ):
        assert len(set(bins)) == (
            1 if variable.name.startswith("object") else variable.n_bins
        )


def assert_learned(name, steps, repetitions, engine=None, stretch=300):
    """In its last 1000 steps the default method earns more a step than a random policy in stretches of its walk."""
    by_chance = random_walk(name, engine)
    # on one core: the tests beside this one need the other, and a pool of processes takes seconds to start
    runs = rl.repeat(
        name,
        repetitions=repetitions,
        steps=steps,
        seed=0,
        engine=engine,
        n_jobs=1,
        progress=False,
    )
    learned = [history.rewards[-1000:].mean() for history in runs]
    random = (
        by_chance.r[: len(by_chance) // stretch * stretch]
        .reshape(-1, stretch)
        .mean(axis=1)
    )
    assert len(random) >= 4
    assert (
        ttest_ind(learned, random, equal_var=False, alternative="greater").pvalue < 0.01
    )


@pytest.mark.long
@pytest.mark.parametrize(("name", "steps"), STEPS.items())
def test_learning_with_the_default_parameters_beats_a_random_policy(name, steps):
    assert_learned(name, steps, 10)


@pytest.mark.long
@pytest.mark.parametrize(("name", "steps"), ARM_STEPS.items())
def test_learning_with_an_arm_of_geometry_beats_a_random_policy(name, steps):
    assert_learned(name, steps, 10, "kinematic")


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "steps"),
    [
        # the physics of the others takes minutes
        pytest.param(*each, marks=[] if each[0] == "arm_1k" else pytest.mark.nightly)
        for each in ARM_STEPS.items()
    ],
)
def test_learning_with_an_arm_in_pybullet_beats_a_random_policy(name, steps):
    pytest.importorskip("pybullet", reason="PyBullet simulates this robot")
    assert_learned(name, steps, 6 if name == "mobile_arm_2k" else 10)


@pytest.mark.parametrize(
    ("wheels", "told"),
    [
        ((-1, -1), (2, 2)),
        ((-0.5, -1), (1, 2)),
        ((-1, 0), (0, 0)),
        ((0, -0.5), (0, 0)),
        ((-1, 0.5), (-1, 0.5)),
    ],
)
def test_backward_means_fast_forward_and_half_of_it_means_stop(wheels, told):
    names = ("left_wheel", "right_wheel")
    assert no_reversing(dict(zip(names, wheels, strict=True))) == dict(
        zip(names, told, strict=True)
    )


def seen(front=1.0, left=1.0, right=1.0, x=0.0):
    return {
        "laser_front": front,
        "laser_front_left": left,
        "laser_front_right": right,
        "x": x,
        "y": 0.0,
    }


def test_the_rewards_are_those_of_the_paper():
    assert (
        collision_reward(seen(0.04, 0.04, 0.04), 0.05)
        == collision_reward(seen(left=0.04, right=0.04), 0.05)
        == -10
    )
    assert collision_reward(seen(right=0.04), 0.05) == -2
    assert collision_reward(seen(0.05, 0.05, 0.05), 0.05) == 0
    assert wander_reward(seen(), seen(x=0.0701), 0.05, 0.07) == 10
    assert wander_reward(seen(), seen(x=0.0699), 0.05, 0.07) == -0.02
    assert wander_reward(seen(), seen(front=0.04, x=0.1), 0.05, 0.07) == -2
    assert [approach_reward(d + 0.1, d, 0.07, -0.1) for d in (0.5, 1.2, 1.8, 4.0)] == [
        5,
        4,
        3,
        2,
    ]
    assert approach_reward(1.0, 1.08, 0.07, -0.1) == -1
    assert (
        approach_reward(1.0, 0.94, 0.07, -0.1)
        == approach_reward(1.0, 1.06, 0.07, -0.1)
        == -0.1
    )


def test_the_navigation_task_and_its_scene_agree_on_the_goal():
    task, (x, y, radius) = rl.load_task("navigation_1k"), ARENAS["maze_4x4_goal"].goal
    for angle in np.linspace(0, 2 * math.pi, 9):
        for part, inside in ((0.99, True), (1.01, False)):
            at = {
                "x": x + part * radius * math.cos(angle),
                "y": y + part * radius * math.sin(angle),
            }
            assert task.goal(at) is inside
    goals = [
        solid
        for solid in rl.make_env(task, seed=0).robot.scene().solids
        if solid.role == "goal"
    ]
    assert [(*goal.pose[:2, 3], goal.size[0]) for goal in goals] == [(x, y, radius)]


def test_navigation_terminates_at_exactly_the_sixth_step_in_a_row_within_the_goal(
    monkeypatch,
):
    env = rl.make_env("navigation_1k", seed=0)
    x, y, radius = ARENAS["maze_4x4_goal"].goal
    inside, outside = (
        {**env.robot.readings, "x": x + part * radius, "y": y} for part in (0.5, 1.5)
    )
    for way in (
        [inside] * 6,
        [inside] * 5 + [outside] + [inside] * 6,
    ):  # who leaves has to start counting anew
        env.reset()
        script = iter(way)
        monkeypatch.setattr(
            env.robot, "act", lambda command, script=script: dict(next(script))
        )
        results = [env.step(4)[1:4] for _ in way]
        assert [terminated for _, terminated, _ in results] == [False] * (
            len(way) - 1
        ) + [True]
        assert [reward == 10 for reward, _, _ in results] == [
            readings is inside for readings in way
        ]
        assert not any(truncated for _, _, truncated in results)


def test_giraff_drives_and_turns_by_its_own_dimensions(monkeypatch):
    monkeypatch.setitem(
        ARENAS, "hexagon_giraff", ARENAS["hexagon_giraff"]._replace(walls=())
    )
    robot = Giraff("hexagon_giraff", 1.0)
    assert robot.act({"left_wheel": 0.5, "right_wheel": 0.5})["x"] == pytest.approx(
        0.5 * GIRAFF.wheel_radius
    )
    turned = robot.act({"left_wheel": -0.5, "right_wheel": 0.5})
    assert turned["theta"] == pytest.approx(
        GIRAFF.wheel_radius / GIRAFF.wheel_separation
    )


def test_giraff_does_not_drive_towards_what_is_near_but_turns_on_the_spot_as_commanded():
    robot = Giraff("hexagon_giraff", 1.0)
    rng = np.random.default_rng(0)
    held = 0
    for left, right in rng.choice([-1.0, -0.5, 0.0, 0.5, 1.0], (5000, 2)).tolist():
        before = robot.readings
        after = robot.act({"left_wheel": left, "right_wheel": right})
        turned = math.remainder(after["theta"] - before["theta"], 2 * math.pi)
        assert turned == pytest.approx(
            (right - left) * GIRAFF.wheel_radius / GIRAFF.wheel_separation
        )
        if min(before[laser] for laser in FRONT_LASERS) < STOP_DISTANCE:
            ahead = (after["x"] - before["x"]) * math.cos(before["theta"]) + (
                after["y"] - before["y"]
            ) * math.sin(before["theta"])
            assert ahead < 1e-3  # backward it may
            held += left + right > 0
    assert held > 300


def seconds_a_round(envs, steps=300):
    """Processor time in which one of `envs` takes `steps` steps, all taking turns [s]; the best of three."""
    best = math.inf
    for env in envs:
        env.reset()
    for _ in range(3):
        start = time.process_time()
        for t in range(steps):
            for env in envs:
                env.step(t % 9)
        best = min(best, (time.process_time() - start) / len(envs))
    return best


def test_many_environments_in_one_process_do_not_slow_each_other():
    alone = seconds_a_round([rl.make_env("wander_1k", seed=0)])
    together = (
        seconds_a_round([rl.make_env("wander_1k", seed=i) for i in range(20)], steps=60)
        * 5
    )
    assert together < 4 * alone  # 20 times, if each paid for all


def test_200_environments_made_and_closed_leave_no_memory_behind():
    def make_and_close(times):
        for _ in range(times):
            env = rl.make_env("wander_1k", seed=0)
            env.reset()
            env.step(8)
            env.close()
        gc.collect()
        return psutil.Process().memory_info().rss

    before = make_and_close(20)
    assert make_and_close(200) - before < 5e6
