"""The mobile base in PyBullet against geometry, and against the base in pymunk, which follows exact arcs."""

import math

import numpy as np
import pytest
from test_mobile_base import deepest, exact_lasers, wheels

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS, Arena
from rlrobot_edu.robots.chassis import BODY_HEIGHT, PIONEER
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.task.robot_cards import LASERS, ROBOTS
from rlrobot_edu.task.task_file import available_tasks

WHEEL_RADIUS = PIONEER.wheel_radius
there = pytest.importorskip(
    "rlrobot_edu.robots.engines.bullet.mobile_base",
    reason="PyBullet simulates this base; it has no wheel for this Python or platform",
    exc_type=ImportError,
)
BulletBase = there.BulletBase
TASKS = [
    name for name in available_tasks() if rl.load_task(name).robot == "mobile_base"
]


def random_commands(seed, n):
    return [
        wheels(*pair)
        for pair in np.random.default_rng(seed).choice(
            [-2.0, -1.0, 0.0, 1.0, 2.0], (n, 2)
        )
    ]


def test_in_free_space_the_base_keeps_to_the_exact_arcs_of_rolling_wheels(monkeypatch):
    monkeypatch.setitem(
        ARENAS, "free_space", Arena((), (-5, -5, 5, 5), (0.0, 0.0, 0.0))
    )
    rolling, exact = BulletBase("free_space", 1.0), MobileBase("free_space", 1.0)
    turns = []
    for seed in range(10):
        rolling.reset(), exact.reset()
        for command in random_commands(seed, 20):
            here, ideal = rolling.act(command), exact.act(command)
            turns.append(
                abs(math.remainder(here["theta"] - ideal["theta"], 2 * math.pi))
            )
            assert math.hypot(here["x"] - ideal["x"], here["y"] - ideal["y"]) < 0.02
    assert max(turns) < math.radians(3) and np.mean(turns) < math.radians(1)


def test_a_step_of_any_duration_covers_the_same_ground_a_second():
    base = BulletBase("maze_6x6", 0.5)
    start = base.readings["x"]
    for _ in range(4):
        base.act(wheels(1, 1))
    assert base.readings["x"] - start == pytest.approx(2 * WHEEL_RADIUS, abs=0.002)


@pytest.mark.parametrize("scene", ["square_2x2", "maze_6x6"])
def test_the_lasers_measure_exactly_to_the_walls(scene):
    base = BulletBase(scene, 1.0)
    for command in random_commands(1, 150):
        readings = base.act(command)
        exact = exact_lasers(ARENAS[scene], PIONEER, readings)
        assert [readings[laser] for laser in LASERS] == pytest.approx(exact, abs=1e-9)


def test_the_hull_in_pybullet_is_that_of_the_base_in_pymunk():
    lines = [
        line.split()
        for line in there.URDF.with_name("hull.obj").read_text().splitlines()
    ]
    corners = [tuple(map(float, line[1:])) for line in lines if line[0] == "v"]
    assert corners == [
        (x, y, z) for z in (-BODY_HEIGHT / 2, BODY_HEIGHT / 2) for x, y in PIONEER.hull
    ]


@pytest.mark.long
@pytest.mark.parametrize("scene", ["square_2x2", "maze_6x6"])
def test_no_wall_is_entered_by_a_centimetre_in_500_steps_at_double_speed_and_the_base_stays_level(
    scene,
):
    base = BulletBase(scene, 1.0)
    for i, command in enumerate(
        np.random.default_rng(3).choice([2.0, 2.0, -2.0], (500, 2))
    ):
        readings = base.act(wheels(*command))
        assert deepest(ARENAS[scene], PIONEER, readings) < 0.01
        if i % 50 == 0:
            body = base._simulation.link_pose(base._body, -1)
            assert (
                body[2, 2] > math.cos(math.radians(2))
                and abs(body[2, 3] - PIONEER.wheel_radius) < 0.005
            )


@pytest.mark.parametrize("name", TASKS)
def test_every_task_of_the_base_runs_on_it(name):
    env = rl.make_env(name, seed=0, engine="pybullet")
    usual = rl.make_env(name, seed=0)
    assert env.reset()[1]["state"] == usual.reset()[1]["state"]
    for action in (
        np.random.default_rng(0).integers(env.action_space.n, size=20).tolist()
    ):
        readings = env.step(action)[4]["readings"]
    assert set(readings) == set(ROBOTS["mobile_base"].sensors)


@pytest.mark.long
def test_a_learner_does_better_than_chance_on_it():
    ends = []
    for method in ("TOSL+QBIASSR", "Q+RANDOM"):
        env = rl.make_env("wander_simple", seed=1, engine="pybullet")
        ends.append(
            rl.learn(
                rl.Agent(env.task, method, seed=1), env, 400, progress=False
            ).average_reward[-1]
        )
    assert ends[0] > ends[1] + 1


def test_the_scene_shows_the_base_where_its_readings_say_and_beams_as_long_as_they_measure():
    base = BulletBase("square_2x2", 1.0)
    readings = base.act(wheels(2, 1))
    picture = base.scene()
    solids = {solid.name: solid for solid in picture.solids}
    assert {
        "robot/body",
        "robot/nose",
        "robot/left_wheel",
        "robot/right_wheel",
    } <= solids.keys()
    assert len(solids) == len(picture.solids)
    body, nose = solids["robot/body"].pose, solids["robot/nose"].pose
    assert body[:3, 3] == pytest.approx([readings["x"], readings["y"], 0.16], abs=0.002)
    ahead = nose[:2, 3] - body[:2, 3]
    assert math.atan2(ahead[1], ahead[0]) == pytest.approx(readings["theta"], abs=0.01)
    lengths = np.linalg.norm(picture.beams[:, 1] - picture.beams[:, 0], axis=1)
    assert lengths == pytest.approx([readings[laser] for laser in LASERS])
