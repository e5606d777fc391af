"""The method in one file, tosl.py, says what the library says, and its page shows what it prints."""

import ast
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from oracles import NumpyModelWorld, learn_in_one_file

import rlrobot_edu as rl
import tosl

ROOT = Path(tosl.__file__).parent


@pytest.mark.parametrize("seed", range(10))
def test_it_learns_in_the_four_cells_what_the_library_learns(seed):
    env = rl.make_env("worked_example", seed=np.random.SeedSequence([seed, 0]))
    agent = rl.Agent(env, "TOSL+QBIASSR", seed=np.random.SeedSequence([seed, 1]))
    history = rl.learn(agent, env, episodes=30, progress=False)
    other, world = tosl.new_robot(seed)
    rewards = [r for _, r in tosl.learn(other, world, n_episodes=30)]
    np.testing.assert_array_equal(history.rewards, rewards)
    # NumPy sums a mean in an order of its own, so the last digits may differ
    np.testing.assert_allclose(agent.q, other.q, atol=1e-9)


def test_it_learns_in_a_sample_model_what_the_library_learns(wander_model):
    agent = rl.Agent(wander_model, "TOSL+QBIASSR", seed=7)
    env = rl.make_env(wander_model, seed=np.random.SeedSequence(11))
    history = rl.learn(agent, env, steps=3600, progress=False)
    world = NumpyModelWorld(wander_model, np.random.default_rng(11))
    rng = np.random.default_rng(7)
    q, rewards = learn_in_one_file(world, wander_model, 3600, rng)
    np.testing.assert_array_equal(history.rewards, rewards)
    np.testing.assert_allclose(agent.q, q, atol=1e-9)


def test_it_needs_numpy_alone():
    imports = [
        node.module if isinstance(node, ast.ImportFrom) else node.names[0].name
        for node in ast.walk(ast.parse(Path(tosl.__file__).read_text("utf-8")))
        if isinstance(node, ast.Import | ast.ImportFrom)
    ]
    assert imports == ["collections", "numpy"]


def test_its_page_and_the_readme_show_what_it_prints():
    command = [sys.executable, "-X", "utf8", "tosl.py"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, check=True)
    printed = run.stdout.decode().replace("\r\n", "\n")
    page = (ROOT / "docs/method.md").read_text("utf-8")
    assert f"```text\n{printed}```" in page
    readme = (ROOT / "README.md").read_text("utf-8")
    assert f"```text\n{printed[printed.index('After') :]}```" in readme
