"""Copies of an environment, in this process and another: the same state, the same future, a world of their own."""

import copy
import gc
import hashlib
import pickle
import subprocess
import sys
from functools import partial
from importlib.util import find_spec
from pathlib import Path

import cloudpickle
import numpy as np
import pytest
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv

import rlrobot_edu as rl
from rlrobot_edu.robots.giraff import Giraff
from rlrobot_edu.robots.mobile_base import MobileBase

NO_PYBULLET = pytest.mark.skipif(
    find_spec("pybullet") is None, reason="pybullet is not installed"
)
NOISE = rl.Realism(laser_noise=0.02, wheel_slip=0.1, delay=2)
WORLDS = {
    "the cell robot": partial(rl.make_env, "worked_example", 3),
    "the base in pymunk": partial(rl.make_env, "wander_simple", 3),
    "the base in a maze": partial(rl.make_env, "wander_1k", 3),
    "the base without an engine": partial(
        rl.make_env, "wander_1k", 3, engine="kinematic"
    ),
    "that base where walls hold": partial(
        rl.make_env, "wander_1k", 3, engine="kinematic", realism=rl.Realism.vrep()
    ),
    "the giraff": partial(rl.make_env, "giraff_wander_simple", 3),
    "a base with noise": partial(rl.make_env, "wander_simple", 3, realism=NOISE),
    "a base with lag and friction": partial(
        rl.make_env, "wander_1k", 3, realism=rl.Realism.vrep()
    ),
    "the arm without contact": partial(rl.make_env, "arm_1k", 3, engine="kinematic"),
    "a base in pymunk with that arm": partial(
        rl.make_env, "mobile_arm_2k", 3, engine="kinematic"
    ),
    "a cell robot with delay": partial(
        rl.make_env, "worked_example", 3, realism=rl.Realism(delay=1)
    ),
}
IN_PYBULLET = {
    "the arm": partial(rl.make_env, "arm_1k", 3, engine="pybullet"),
    "the base in PyBullet": partial(rl.make_env, "wander_simple", 3, engine="pybullet"),
    "a base in PyBullet with noise": partial(
        rl.make_env, "wander_simple", 3, engine="pybullet", realism=NOISE
    ),
    "the mobile manipulator": partial(
        rl.make_env, "mobile_arm_2k", 3, engine="pybullet"
    ),
}
ALL_WORLDS = [
    *(pytest.param(make, id=name) for name, make in WORLDS.items()),
    *(
        pytest.param(make, id=name, marks=NO_PYBULLET)
        for name, make in IN_PYBULLET.items()
    ),
]
WAYS = {
    "deepcopy": copy.deepcopy,
    "pickle": lambda env: pickle.loads(pickle.dumps(env)),
    "cloudpickle": lambda env: cloudpickle.loads(cloudpickle.dumps(env)),
}


def actions_of(env, steps, seed=0):
    """Random actions, every other one full speed ahead: into a wall, sooner or later."""
    totals = [sum(env.task.command_for(a).values()) for a in range(env.action_space.n)]
    rng = np.random.default_rng(seed)
    return np.where(
        rng.random(steps) < 0.5,
        np.argmax(totals),
        rng.integers(env.action_space.n, size=steps),
    ).tolist()


def seen_on_the_way(env, actions):
    """All that an agent is told in these steps, and after the reset that follows them."""
    steps = [env.step(action) for action in actions] + [env.reset()]
    return [
        [part.tolist() if isinstance(part, np.ndarray) else part for part in step]
        for step in steps
    ]


@pytest.mark.parametrize("make", ALL_WORLDS)
def test_a_world_repeats_to_the_last_bit_after_a_reset_with_the_same_seed(make):
    env, told = make(), []
    actions = actions_of(env, 30)
    for _ in range(2):
        env.reset(seed=4)
        told.append(seen_on_the_way(env, actions)[:-1])
    assert told[0] == told[1]


@pytest.mark.parametrize("make", ALL_WORLDS)
def test_a_copy_goes_on_to_the_last_bit_as_if_nothing_had_been_copied_and_neither_disturbs_the_other(
    make,
):
    env, never_copied = make(), make()
    assert env.reset()[1] == never_copied.reset()[1]
    past, future = actions_of(env, 24), actions_of(env, 10, seed=1)
    copies = []
    for i, action in enumerate(past):
        env.step(action), never_copied.step(action)
        if i % 12 == 11:
            copies.append([way(env) for way in WAYS.values()])
            assert all(
                twin.state == env.state and twin.robot.readings == env.robot.readings
                for twin in copies[-1]
            )
    told = seen_on_the_way(never_copied, future)
    for twin in copies[-1][:-1]:
        assert seen_on_the_way(twin, future) == told
    assert seen_on_the_way(env, future) == told
    assert seen_on_the_way(copies[-1][-1], future) == told
    for twin in copies[0]:  # left alone for 12 steps of the others
        assert seen_on_the_way(twin, past[12:] + future)[12:] == told


def test_a_copy_of_a_base_that_pushes_against_walls_keeps_to_the_bit_whenever_it_is_made():
    base, commands = (
        MobileBase("square_2x2", 0.5),
        np.random.default_rng(2).choice([2.0, 2.0, 2.0, -1.0], (120, 2)),
    )
    twins = []
    for left, right in commands:
        here = base.act({"left_wheel": left, "right_wheel": right})
        assert [
            twin.act({"left_wheel": left, "right_wheel": right}) for twin in twins
        ] == [here] * len(twins)
        twins = [*twins[-9:], copy.deepcopy(base)]


@pytest.mark.parametrize(
    ("kind", "scene", "physics"),
    [
        (Giraff, "hexagon_giraff", {}),
        (MobileBase, "maze_6x6", {}),
        (MobileBase, "maze_4x4_goal", {"realism": rl.Realism.vrep()}),
    ],
)
def test_a_copy_wedged_between_walls_goes_on_to_the_last_bit(kind, scene, physics):
    base, commands = (
        kind(scene, 1.0, **physics),
        np.random.default_rng(0).choice([2.0, 2.0, -1.0], (200, 2)),
    )
    twins = []
    for left, right in commands:
        command = {"left_wheel": left, "right_wheel": right}
        here = base.act(command)
        assert [twin.act(command) for twin in twins] == [here] * len(twins)
        twins = [*twins[-9:], copy.deepcopy(base)]


ELSEWHERE = """
import pickle, sys
sys.path.insert(0, sys.argv[1])
from test_copies import fingerprint
for env, future in pickle.load(sys.stdin.buffer):
    print(fingerprint(env, future))
"""


def fingerprint(env, future):
    return hashlib.sha256(repr(seen_on_the_way(env, future)).encode()).hexdigest()


@pytest.mark.long
def test_an_environment_goes_on_in_another_process_to_the_last_bit():
    worlds = [
        make()
        for make in (
            *WORLDS.values(),
            *(IN_PYBULLET.values() if find_spec("pybullet") else ()),
        )
    ]
    for env in worlds:
        env.reset()
        for action in actions_of(env, 12):
            env.step(action)
    luggage = pickle.dumps([(env, actions_of(env, 12, seed=1)) for env in worlds])
    command = [sys.executable, "-c", ELSEWHERE, str(Path(__file__).parent)]
    run = subprocess.run(command, input=luggage, capture_output=True, check=True)
    assert run.stdout.decode().split() == [
        fingerprint(env, actions_of(env, 12, seed=1)) for env in worlds
    ]
    assert run.stderr == b"", "importing PyBullet is not silent"


@pytest.mark.parametrize(
    "many",
    [SyncVectorEnv, partial(AsyncVectorEnv, context="spawn")],
    ids=["here", "elsewhere"],
)
def test_several_environments_side_by_side_see_what_each_would_see_alone(many):
    makers = [
        partial(rl.make_env, "wander_simple", seed, realism=NOISE) for seed in (0, 1)
    ]
    together, alone = many(makers), [make() for make in makers]
    try:
        seen, _ = together.reset()
        assert seen.tolist() == [env.reset()[0].tolist() for env in alone]
        for action in actions_of(alone[0], 8):
            seen, rewards, *_ = together.step([action, 1])
            each = [env.step(a) for env, a in zip(alone, (action, 1), strict=True)]
            assert seen.tolist() == [step[0].tolist() for step in each]
            assert rewards.tolist() == [step[1] for step in each]
    finally:
        together.close()


@NO_PYBULLET
def test_a_base_in_pybullet_that_is_closed_leaves_no_lists_behind():
    def lists():
        gc.collect()
        return sum(
            type(thing) is list for thing in gc.get_objects()
        )  # isinstance asks what a dead weak proxy is

    rl.make_env("wander_1k", engine="pybullet").robot.close()
    before = lists()
    for _ in range(3):
        rl.make_env("wander_1k", engine="pybullet").robot.close()
    assert (
        lists() - before < 50
    )  # PyBullet keeps the lists of a mesh: 112 corners, were they new each time
