"""Realism on request: noise, slip and delay do what they say, repeatably, and nothing at all when off."""

import math

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.realism import RealisticRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import (
    LASER_RANGE,
    LASERS,
    ROBOTS,
    Quantity,
    RobotCard,
)

WHEEL_RADIUS = PIONEER.wheel_radius
ACTIONS = np.random.default_rng(1).integers(9, size=300)
ALL = {
    "laser_noise": 0.02,
    "wheel_slip": 0.1,
    "delay": 1,
    "lag": 0.1,
    "wall_friction": 0.72,
}
WITHOUT_CHANCE = ("delay", "lag", "wall_friction")


def readings_of_a_run(realism, seed=3, actions=ACTIONS):
    """Readings after each action, array (steps, sensors)."""
    env = rl.make_env("wander_1k", seed=seed, realism=realism)
    env.reset()
    return np.array([list(env.step(a)[4]["readings"].values()) for a in actions])


def column(name):
    return list(ROBOTS["mobile_base"].sensors).index(name)


def test_without_realism_and_with_all_of_it_at_zero_a_run_is_the_same_bit_for_bit():
    assert np.array_equal(readings_of_a_run(None), readings_of_a_run(rl.Realism()))


@pytest.mark.parametrize("weakness", ALL)
def test_each_weakness_changes_the_run_and_repeats_with_its_seed(weakness):
    realism = rl.Realism(**{weakness: ALL[weakness]})
    first = readings_of_a_run(realism)
    assert np.array_equal(readings_of_a_run(realism), first)
    assert not np.array_equal(readings_of_a_run(None), first)
    assert np.array_equal(readings_of_a_run(realism, seed=4), first) == (
        weakness in WITHOUT_CHANCE
    )


def test_noise_has_the_given_size_acts_on_lasers_alone_and_leaves_the_robot_where_it_is():
    sigma = 0.02
    ideal = readings_of_a_run(None)
    error = readings_of_a_run(rl.Realism(laser_noise=sigma)) - ideal
    noisy = [column(laser) for laser in LASERS]
    assert not np.delete(error, noisy, axis=1).any()
    truth = ideal[:, noisy]
    inside = error[:, noisy][(truth > 0.1) & (truth < 3)]
    assert np.mean(inside) == pytest.approx(0, abs=5 * sigma / math.sqrt(len(inside)))
    assert np.std(inside) == pytest.approx(sigma, rel=0.1)


def test_noisy_readings_stay_within_the_range_of_the_sensor():
    readings = readings_of_a_run(rl.Realism(laser_noise=3))
    lasers = readings[:, [column(laser) for laser in LASERS]]
    assert lasers.min() == 0 and lasers.max() == LASER_RANGE


def test_slipping_wheels_drive_as_far_as_commanded_on_average():
    robot = RealisticRobot(
        MobileBase("maze_6x6", 1.0), ROBOTS["mobile_base"], rl.Realism(wheel_slip=0.1)
    )
    rng = np.random.default_rng(0)
    ways = []
    for _ in range(300):
        robot.reset(rng)
        ways.append(robot.act({"left_wheel": 1.0, "right_wheel": 1.0})["x"])
    assert np.mean(ways) == pytest.approx(WHEEL_RADIUS, rel=0.02)
    assert np.std(ways) == pytest.approx(
        WHEEL_RADIUS * 0.1 / math.sqrt(2), rel=0.15
    )  # two wheels slip independently


def test_a_delayed_robot_does_what_it_was_told_some_steps_ago():
    prompt = readings_of_a_run(None)
    late = readings_of_a_run(rl.Realism(delay=2))
    start = MobileBase("maze_6x6", 1.0).readings
    assert late[:2] == pytest.approx(np.array([list(start.values())] * 2))
    assert np.array_equal(late[2:], prompt[:-2])


@pytest.mark.parametrize("engine", ["pymunk", "kinematic"])
def test_with_a_lag_the_former_command_acts_first_and_the_robot_stands_still_before_the_first_one(
    engine,
):
    robot = rl.make_env(
        "wander_simple", seed=0, engine=engine, realism=rl.Realism(lag=0.25)
    ).robot
    robot.reset(np.random.default_rng(0))
    ways = [
        robot.act({"left_wheel": speed, "right_wheel": speed})["x"]
        for speed in (1.0, 2.0, 0.0)
    ]
    assert np.diff([0.0, *ways]) / WHEEL_RADIUS == pytest.approx(
        [0.75 * 1, 0.25 * 1 + 0.75 * 2, 0.25 * 2]
    )


@pytest.mark.parametrize("engine", ["pymunk", "kinematic"])
def test_delay_and_lag_add_up(engine):
    robot = rl.make_env(
        "wander_simple", seed=0, engine=engine, realism=rl.Realism(lag=0.25, delay=1)
    ).robot
    robot.reset(np.random.default_rng(0))
    ways = [
        robot.act({"left_wheel": speed, "right_wheel": speed})["x"]
        for speed in (1.0, 0.0, 0.0)
    ]
    assert np.diff([0.0, *ways]) / WHEEL_RADIUS == pytest.approx([0, 0.75, 0.25])


def test_vreps_preset_is_a_lag_and_friction_and_no_noise():
    assert rl.Realism.vrep() == rl.Realism(lag=0.1, wall_friction=0.72)


@pytest.mark.parametrize("engine", ["pymunk", "kinematic"])
@pytest.mark.parametrize("realism", [rl.Realism(delay=1), rl.Realism(lag=0.9)])
def test_a_reset_forgets_commands_that_were_on_their_way(realism, engine):
    robot = rl.make_env("wander_simple", seed=0, engine=engine, realism=realism).robot
    rng = np.random.default_rng(0)
    robot.reset(rng)
    robot.act({"left_wheel": 1.0, "right_wheel": 1.0})
    robot.reset(rng)
    assert robot.act({"left_wheel": 1.0, "right_wheel": 1.0})["x"] < 0.2 * WHEEL_RADIUS


class Finger:
    """A robot of one joint, to see that realism suits more than the mobile base."""

    def __init__(self):
        self.told, self.readings = [], {"finger": 0.0}

    def reset(self, rng):
        return self.readings

    def act(self, command):
        self.told.append(command["finger"])
        return self.readings

    def scene(self):
        return Scene((), np.empty((0, 2, 3)), (0, 0, 1, 1))

    def close(self):
        pass


def test_slip_and_delay_act_on_any_joint_within_its_limits():
    card = RobotCard(
        {"finger": Quantity("rad", -1, 1)},
        {"finger": Quantity("rad/s", -1, 1)},
        {},
        (),
        {},
    )
    finger = Finger()
    robot = RealisticRobot(finger, card, rl.Realism(wheel_slip=0.5, delay=1))
    robot.reset(np.random.default_rng(0))
    for _ in range(50):
        robot.act({"finger": 0.9})
    assert finger.told[0] == 0 and max(finger.told) == 1 and len(set(finger.told)) > 20


def test_readings_are_measured_once_a_step_and_are_the_callers_own():
    robot = rl.make_env(
        "wander_simple", seed=0, realism=rl.Realism(laser_noise=0.1)
    ).robot
    robot.reset(np.random.default_rng(0))
    robot.readings.clear()
    assert robot.readings == robot.readings != {}
    assert robot.scene().solids


@pytest.mark.parametrize(
    "values",
    [
        *(
            {"laser_noise": -0.1},
            {"wheel_slip": math.inf},
        ),
        *({"delay": -1}, {"delay": 0.5}, {"lag": -0.1}, {"wall_friction": math.nan}),
    ],
)
def test_a_realism_that_cannot_be_is_refused(values):
    with pytest.raises(ValueError, match=next(iter(values))):
        rl.Realism(**values)


@pytest.mark.parametrize(
    "weakness", ["laser_noise", "wheel_slip", "lag", "wall_friction"]
)
def test_realism_that_a_robot_has_nothing_for_is_refused_and_not_ignored(
    weakness, wander_model
):
    with pytest.raises(ValueError, match=f"{weakness} has nothing to act on"):
        rl.make_env("worked_example", realism=rl.Realism(**{weakness: 0.1}))
    with pytest.raises(ValueError, match="only a task has a robot"):
        rl.make_env(wander_model, realism=rl.Realism(**{weakness: 0.1}))


@pytest.mark.parametrize("weakness", ["lag", "wall_friction"])
@pytest.mark.parametrize(
    ("task", "engine"), [("wander_simple", "pybullet"), ("arm_1k", None)]
)
def test_a_lag_or_friction_that_the_engine_cannot_simulate_is_refused(
    weakness, task, engine
):
    pytest.importorskip("pybullet")
    with pytest.raises(ValueError, match=f"{weakness} has nothing to act on"):
        rl.make_env(task, engine=engine, realism=rl.Realism(**{weakness: 0.1}))


@pytest.mark.parametrize("weakness", [*ALL])
@pytest.mark.parametrize("size", [0.1, 5.0, -1])
def test_a_weakness_has_one_way_in_and_that_one_is_checked(weakness, size):
    with pytest.raises(
        ValueError,
        match=rf"'mobile_base' has no setting '{weakness}'.*It has: .*engine, realism",
    ):
        rl.make_env("wander_1k", **{weakness: size})


@pytest.mark.parametrize("kind", [MobileBase, KinematicBase])
def test_a_robot_itself_refuses_a_lag_longer_than_its_step(kind):
    with pytest.raises(ValueError, match=r"lag must be below 0\.5 s, a control step"):
        kind("square_2x2", 0.5, realism=rl.Realism(lag=5.0))
