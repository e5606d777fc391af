"""Agents, loops and histories: parameters, names, saving, reproducibility."""

import json
import os
import subprocess
import sys

import gymnasium
import numpy as np
import pytest
from worlds import RandomWorld

import rlrobot_edu as rl
from rlrobot_edu.learning.methods import ALGORITHMS, SELECTIONS

METHODS = [f"{a}+{s}" for a in ALGORITHMS for s in SELECTIONS]


@pytest.mark.parametrize("method", METHODS)
def test_every_method_learns_and_its_probabilities_are_probabilities(method):
    world = RandomWorld(p_end=0.1)
    agent = rl.Agent(world, method, seed=0)
    for step in rl.steps(agent, world, steps=200):
        assert (
            step.probabilities.sum() == pytest.approx(1)
            and step.probabilities[step.a] > 0
        )
        assert (step.bias is None) == ("BIASSR" not in method)
        assert step.temperature >= 1
    assert np.isfinite(agent.q).all() and agent.visits.sum() == 200


@pytest.mark.parametrize(
    "wrong, meant", [("TOSL+QBIASR", "TOSL+QBIASSR"), ("sarsa+sr", "SARSA+SR")]
)
def test_an_unknown_method_is_answered_with_the_nearest_and_all_known_names(
    wrong, meant
):
    with pytest.raises(ValueError, match="unknown method") as error:
        rl.Agent("wander_simple", wrong)
    assert meant in str(error.value) and all(
        name in str(error.value) for name in ALGORITHMS | SELECTIONS
    )


@pytest.mark.parametrize(
    "given, meant",
    [
        ("q-learning", "Q+SR"), ("Q", "Q+SR"), ("tosl", "TOSL+SR"), ("SARSA(λ)", "SL+SR"),
        ("sarsa lambda", "SL+SR"), ("expected_sarsa", "ESARSA+SR"), ("Q-Learning + softmax", "Q+SR"),
        ("TOSL-QBIASSR", "TOSL+QBIASSR"), ("true online SARSA(λ)+ε-greedy", "TOSL+EG"), ("e greedy", "TOSL+EG"),
    ],
)  # fmt: skip
def test_the_words_of_the_literature_are_answered_with_the_name_that_they_have_here(
    given, meant
):
    with pytest.raises(ValueError, match="unknown method") as error:
        rl.Agent("wander_simple", given)
    assert f"{given!r}; did you mean {meant!r}? A method is" in str(error.value)


@pytest.mark.parametrize("given", ["zebra", "", None, 3])
def test_what_resembles_no_method_is_answered_with_whole_sentences(given):
    with pytest.raises(
        ValueError, match=f"^unknown method {given!r}. A method is ALGORITHM"
    ):
        rl.Agent("wander_simple", given)


@pytest.mark.parametrize(
    "settings",
    [
        {"alpha": 0}, {"alpha": 1.1}, {"alpha": float("nan")}, {"gamma": 1}, {"gamma": -0.1}, {"lam": 1.01},
        {"lam": -1}, {"temperature": 0}, {"temperature": float("inf")}, {"epsilon": 2}, {"traces": "some"},
        {"r_max": 0}, {"r_max": float("nan")},
    ],
)  # fmt: skip
def test_a_parameter_outside_its_domain_is_refused_by_name(settings):
    (name,) = settings
    with pytest.raises(ValueError, match=f"^{name} must be"):
        rl.Agent("wander_simple", **settings)


def test_the_default_parameters_are_the_papers():
    agent = rl.Agent("wander_1k")
    assert agent.method.name == "TOSL+QBIASSR"
    assert {k: getattr(agent.parameters, k) for k in ("alpha", "gamma", "lam", "temperature", "traces", "r_max")} == {
        "alpha": 0.1, "gamma": 0.9, "lam": 0.9, "temperature": 1.0, "traces": "reduced", "r_max": 10.0,
    }  # fmt: skip
    assert agent.parameters.q_scale == pytest.approx(100 / (10 / (1 - 0.9)))
    assert agent.memory.parameters.q_scale == agent.parameters.q_scale


def test_ties_are_broken_at_random():
    agent = rl.Agent("wander_1k", "Q+GREEDY", seed=0)
    first = [agent.begin_episode(0) for _ in range(500)]
    assert set(first) == set(range(9))


def test_the_least_explored_action_is_favoured():
    agent = rl.Agent("wander_1k", "Q+EGLE", epsilon=0.5, seed=0)
    agent.visits[0] = [5, 5, 5, 1, 5, 5, 5, 5, 5]
    agent.q[0, 7] = 1.0
    agent.begin_episode(0)
    np.testing.assert_allclose(agent.probabilities[[3, 7]], 0.5)


def test_an_environment_with_other_observations_is_refused():
    with pytest.raises(ValueError, match="MultiDiscrete or Discrete"):
        rl.Agent(gymnasium.make("MountainCar-v0"))


def test_an_agent_for_another_world_is_refused():
    with pytest.raises(ValueError, match="the agent was made for"):
        rl.steps(rl.Agent("wander_simple"), RandomWorld(), steps=1)


def test_a_step_cannot_be_changed_and_shares_no_number_with_the_agent():
    world = RandomWorld()
    agent = rl.Agent(world, seed=0)
    (step,) = rl.steps(agent, world, steps=1)
    with pytest.raises(AttributeError):
        step.r = 5.0
    assert not np.shares_memory(step.probabilities, agent.probabilities)
    assert not np.shares_memory(step.bias, agent.bias)


def test_the_history_is_what_the_steps_say():
    def fresh():
        world = RandomWorld(p_end=0.05)
        return rl.Agent(world, "TOSL+QBIASSR", seed=4), world

    agent, world = fresh()
    history = rl.learn(agent, world, steps=300, progress=False)
    walked = list(rl.steps(*fresh(), steps=300))
    assert [step.r for step in walked] == history.rewards.tolist()
    assert [step.terminated for step in walked] == history.terminated.tolist()
    rewards = np.array([step.r for step in walked])
    np.testing.assert_allclose(
        history.average_reward, [rewards[: t + 1].mean() for t in range(300)]
    )
    ends = np.flatnonzero(history.terminated)
    assert history.returns[1] == pytest.approx(rewards[ends[0] + 1 : ends[1] + 1].sum())


def test_there_must_be_something_to_resume():
    world = RandomWorld()
    with pytest.raises(ValueError, match="nothing to resume"):
        rl.steps(rl.Agent(world), world, steps=1, resume=True)


@pytest.mark.parametrize("damage", ["cut", "other", "pickle"])
def test_a_damaged_agent_file_is_refused_and_nothing_is_unpickled(tmp_path, damage):
    path = tmp_path / "agent.npz"
    rl.Agent("wander_simple").save(path)
    if damage == "cut":
        path.write_bytes(path.read_bytes()[:-200])
    elif damage == "other":
        np.savez(path, q=np.zeros(3))
    else:
        np.savez(path, about=np.array([{"a": 1}], dtype=object))
    with pytest.raises(ValueError, match=r"agent\.npz"):
        rl.Agent.load(path)


SCRIPT = """
import hashlib, sys
import rlrobot_edu as rl
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_course.lesson_17.sweeping import SWEEPING
digest = hashlib.sha256()
model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"), unseen="siblings")
methods = "Q+EG Q+EGLE Q+GREEDY Q+RANDOM SARSA+SR ESARSA+SR SL+SR TOSL+SR".split()
methods += ["TOSL+QBIASSR", rl.Method("TOSL", VBIASSR)]
for method, planner in [*((method, None) for method in methods), ("Q+QBIASSR", "dyna"), ("TOSL+SR", SWEEPING)]:
    agent = rl.Agent(model, method, planner=planner, seed=3)
    env = rl.make_env(model, seed=4)
    if sys.argv[1] == "loop":
        rl.learn(agent, env, steps=250, progress=False)
    else:
        for _ in rl.steps(agent, env, steps=250):
            pass
    digest.update(agent.q.tobytes())
print(digest.hexdigest())
"""


@pytest.mark.long
def test_compiled_or_not_stepped_or_not_the_numbers_are_the_same_to_the_last_bit():
    def digest(how, disable):
        env = {**os.environ, "NUMBA_DISABLE_JIT": disable}
        run = subprocess.run(
            [sys.executable, "-c", SCRIPT, how],
            env=env,
            capture_output=True,
            text=True,
            check=True,
        )
        return run.stdout

    results = {
        (how, jit): digest(how, jit) for how in ("loop", "steps") for jit in ("0", "1")
    }
    assert len(set(results.values())) == 1, json.dumps(
        {str(k): v for k, v in results.items()}, indent=2
    )


def test_the_package_is_quick_to_import_because_heavy_libraries_wait():
    heavy = (
        "numba",
        "pymunk",
        "pybullet",
        "meshcat",
        "matplotlib",
        "scipy",
        "IPython",
        "ipywidgets",
        "joblib",
    )
    script = f"import sys, rlrobot_edu; print([m for m in {heavy} if m in sys.modules])"
    run = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "[]"


@pytest.mark.parametrize("method", ["TOSL+QBIASSR", "Q+SR", "SL+SR", "SARSA+EGLE"])
def test_who_is_evaluated_acts_as_one_who_learns_next_to_nothing_and_stays_as_it_was(
    method,
):
    world = RandomWorld(p_end=0.1)
    agent, slow = (
        rl.Agent(world, method, seed=0, lam=0.5, loop_evasion=False) for _ in range(2)
    )
    for learner in (agent, slow):
        rl.learn(learner, RandomWorld(p_end=0.1), steps=200, progress=False)
    slow.change(alpha=1e-300)
    q, visits, drawn = (
        agent.q.copy(),
        agent.visits.copy(),
        agent.rng.bit_generator.state,
    )
    evaluated = rl.evaluate(agent, RandomWorld(p_end=0.1), 300)
    stepped = list(rl.steps(agent.frozen(), RandomWorld(p_end=0.1), 300))
    learned = rl.learn(slow, RandomWorld(p_end=0.1), 300, progress=False)
    assert np.array_equal(evaluated.rewards, learned.rewards) and np.array_equal(
        evaluated.q, q
    )
    assert [step.r for step in stepped] == evaluated.rewards.tolist() and all(
        np.isnan(step.delta) for step in stepped
    )
    assert np.array_equal(agent.q, q) and np.array_equal(agent.visits, visits)
    assert agent.rng.bit_generator.state == drawn


@pytest.mark.long
def test_a_frozen_agent_goes_wherever_an_agent_goes(wander_model):
    agent = rl.Agent(wander_model, "TOSL+SR", planner="dyna", seed=0)
    rl.learn(agent, rl.make_env(wander_model, seed=0), 500, progress=False)
    still = agent.frozen()
    in_python = [
        step.r
        for step in rl.steps(agent.frozen(), rl.make_env(wander_model, seed=1), 400)
    ]
    compiled = rl.learn(still, rl.make_env(wander_model, seed=1), 400, progress=False)
    assert compiled.rewards.tolist() == in_python and np.array_equal(still.q, agent.q)
    recording = rl.record(agent.frozen(), rl.make_env(wander_model, seed=1), 400)
    assert recording.r.tolist() == in_python and recording.source.method == "TOSL+SR"
