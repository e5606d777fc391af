"""Stable-Baselines3 finds nothing to complain about in our environments, and learns in them."""

import warnings

import gymnasium
import pytest

import rlrobot_edu as rl

INSTALL = "Stable-Baselines3 is missing: pip install 'rlrobot-edu[baselines]' (some gigabytes)"
checker = pytest.importorskip("stable_baselines3.common.env_checker", reason=INSTALL)


def make_all():
    """Name and maker of each kind of environment."""
    for name in rl.available_tasks():
        yield name, lambda name=name: rl.make_env(name, seed=0)
    yield "gymnasium.make", lambda: gymnasium.make("rlrobot/wander_1k-v0")
    yield "with pictures", lambda: rl.make_env("wander_simple", render_mode="rgb_array")
    yield "with realism", lambda: rl.make_env("wander_1k", realism=rl.Realism(laser_noise=0.02))
    yield "in PyBullet", lambda: rl.make_env("wander_simple", engine="pybullet")
    for name in ("worked_example", "arm_1k"):
        model = rl.SampleModel.from_recording(rl.read_recording(name))
        yield f"model of {name}", lambda model=model: rl.make_env(model, seed=0)


@pytest.mark.parametrize(("name", "make"), [pytest.param(*pair, id=pair[0]) for pair in make_all()])
def test_its_checker_accepts_every_environment_without_a_warning(name, make):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            checker.check_env(make())
        except ImportError as error:
            pytest.skip(str(error))  # PyBullet


def test_its_dqn_learns_in_one():
    from stable_baselines3 import DQN

    network = DQN("MlpPolicy", rl.make_env("wander_simple", seed=0), learning_starts=10, seed=0, device="cpu")
    network.learn(60)
    assert network.num_timesteps == 60
