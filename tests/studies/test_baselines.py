"""Stable-Baselines3 finds nothing to complain about in our environments, and learns in them."""

import warnings

import baselines as study
import gymnasium
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.task.task_file import available_tasks

INSTALL = "Stable-Baselines3 is missing: pip install --group baselines (some gigabytes)"


@pytest.fixture(scope="module")
def baselines():
    pytest.importorskip("stable_baselines3.common.env_checker", reason=INSTALL)
    return pytest.importorskip("stable_baselines3", reason=INSTALL)


def make_all():
    """Name and maker of each kind of environment."""
    for name in available_tasks():
        yield name, lambda name=name: rl.make_env(name, seed=0)
    yield "gymnasium.make", lambda: gymnasium.make("rlrobot/wander_1k-v0")
    yield "with pictures", lambda: rl.make_env("wander_simple", render_mode="rgb_array")
    yield (
        "with realism",
        lambda: rl.make_env("wander_1k", realism=rl.Realism(laser_noise=0.02)),
    )
    yield "in PyBullet", lambda: rl.make_env("wander_simple", engine="pybullet")
    for name in ("worked_example", "arm_1k"):
        yield f"model of {name}", lambda name=name: rl.make_env(model_of(name), seed=0)


def model_of(name):
    return rl.SampleModel.from_recording(rl.read_recording(name))


@pytest.mark.parametrize(
    ("name", "make"), [pytest.param(*pair, id=pair[0]) for pair in make_all()]
)
def test_its_checker_accepts_every_environment_without_a_warning(baselines, name, make):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            baselines.common.env_checker.check_env(make())
        except ImportError as error:
            pytest.skip(str(error))  # PyBullet


def test_a_run_of_the_study_tells_rewards_and_seconds(baselines):
    one = study.run("wander_simple", "DQN, fitted, sees readings", seed=0, steps=200)
    assert len(one["windows"]) == 1 and -10 <= one["windows"][0] <= 10
    assert one["learning"] > one["robot"] > 0


def test_the_page_of_the_study_says_the_numbers():
    rng = np.random.default_rng(0)
    of = {}
    for i, method in enumerate((*study.TABLES, *study.NETWORKS)):
        of[method] = [
            {
                "windows": rng.normal(i, 0.1, 18).tolist(),
                "learning": 1.8,
                "robot": 0.4,
                "goals": 1,
            }
            for _ in range(3)
        ]
    page = study.page({"machine": "a computer", "runs": dict.fromkeys(study.TASKS, of)})
    (line, with_goals) = (
        line for line in page.splitlines() if line.startswith("| at random ")
    )
    mean, first, last, seconds, milliseconds, difference = (
        cell.strip() for cell in line.strip("|").split("|")[1:]
    )
    assert [float(cell.split()[0]) for cell in (mean, first, last)] == pytest.approx(
        [2, 2, 2], abs=0.3
    )
    assert seconds == "1.80 ± 0.00" and milliseconds == "0.50"
    assert difference.startswith("+2.") or difference.startswith("+1.9")
    assert with_goals.endswith("| 1.0 ± 0.0 |")
    assert (
        "p < 0.01" in difference
        and "a computer" in page
        and "Mean reward a step" in page
    )


def test_a_table_learns_in_a_run_of_the_study():
    one = study.run("wander_simple", "Q+SR", seed=0, steps=400)
    assert len(one["windows"]) == 2 and one["robot"] > 0
