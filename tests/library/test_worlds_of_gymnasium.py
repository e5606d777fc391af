"""Comparisons in Gymnasium's environments, by id, spec or a function that makes them."""

import re
import zlib
from functools import partial

import gymnasium
import numpy as np
import pytest
from worlds import RandomWorld
from worlds import same_histories as same

import rlrobot_edu as rl
from rlrobot_edu.task.task_file import available_tasks

CLIFF = "CliffWalking-v1"
FAST = {"repetitions": 2, "n_jobs": 1, "progress": False}
GREEDY = {"alpha": 0.5, "epsilon": 0.1, "loop_evasion": False}


def slippery():
    return gymnasium.make("FrozenLake-v1", is_slippery=True)


def test_the_classical_cliff_takes_three_lines():
    result = rl.compare(
        CLIFF,
        ["SARSA+EG", "Q+EG"],
        4,
        episodes=200,
        gamma=0.999,
        n_jobs=1,
        progress=False,
        **GREEDY,
    )
    returns = {
        method: np.mean([history.returns[-100:] for history in runs])
        for method, runs in result.items()
    }
    assert (
        returns["Q+EG"] < returns["SARSA+EG"] < -17
    )  # -17 is the way round, which no ε-greedy robot always takes
    assert all(
        len(history.returns) == 200 for runs in result.values() for history in runs
    )
    assert (
        result.name == "CliffWalking"
        and "CliffWalking" in result.plot().texts[1].get_text()
    )


@pytest.mark.parametrize(
    "world", [CLIFF, gymnasium.spec(CLIFF), partial(gymnasium.make, CLIFF)]
)
def test_an_id_a_spec_and_a_function_are_the_same_world_on_one_core_and_on_two(world):
    one = rl.compare(CLIFF, ["Q+EG"], steps=200, **FAST)
    assert same(
        rl.compare(world, ["Q+EG"], 2, steps=200, n_jobs=2, progress=False), one
    )


def test_a_repetition_in_gymnasiums_world_can_be_made_again_by_hand():
    history = rl.repeat("FrozenLake-v1", "Q+EG", steps=300, seed=5, **FAST)[1]
    root = np.random.SeedSequence(5, spawn_key=(zlib.crc32(b"Q+EG"),))
    agent_seed, env_seed = root.spawn(2)[1].spawn(2)
    with rl.make_env("FrozenLake-v1", env_seed) as env:
        again = rl.learn(
            rl.Agent(env, "Q+EG", seed=agent_seed), env, 300, progress=False
        )
    assert np.array_equal(history.rewards, again.rewards) and np.array_equal(
        history.q, again.q
    )


@pytest.mark.parametrize(
    "world", [CLIFF, gymnasium.spec(CLIFF), lambda: gymnasium.make(CLIFF)]
)
def test_an_agent_takes_whatever_world_make_env_takes(world):
    agent = rl.Agent(world, "Q+EG", gamma=1, seed=0)
    assert agent.q.shape == (48, 4) and agent.task is None
    history = rl.learn(agent, rl.make_env(world, seed=0), steps=50, progress=False)
    assert len(history) == 50


def test_an_agent_of_an_unknown_world_is_refused_as_its_environment_is():
    for make in (rl.Agent, rl.make_env):
        with pytest.raises(gymnasium.error.Error, match="Did you mean: `CliffWalking`"):
            make("CliffWalkin-v1")
        with pytest.raises(ValueError, match="no task 'wandr'; did you mean"):
            make("wandr")
    assert rl.Agent("rlrobot/wander_simple-v0").task.name == "wander_simple"


def test_episodes_need_no_steps_and_one_of_the_two_is_needed():
    agent, env = rl.Agent(CLIFF, "Q+EG", seed=0), rl.make_env(CLIFF, seed=0)
    for call in (rl.learn, rl.evaluate):
        with pytest.raises(ValueError, match="give steps= or episodes="):
            call(agent, env)
        with pytest.raises(TypeError, match="positional"):
            call(agent, env, 10, 2)
    assert len(rl.learn(agent, env, episodes=3, progress=False).returns) == 3
    history = rl.evaluate(agent, env, steps=40, progress=False)
    assert len(history) == 40


def test_each_repetition_makes_its_own_environment_and_closes_it():
    made = []

    class Counted(RandomWorld):
        closed = False

        def __init__(self):
            made.append(self)
            super().__init__(p_end=0.2)

        def close(self):
            self.closed = True

    rl.repeat(Counted, "Q+SR", repetitions=3, steps=10, n_jobs=1, progress=False)
    assert len(made) >= 4 and all(env.closed for env in made)


@pytest.mark.parametrize("world", [CLIFF, gymnasium.spec("FrozenLake-v1"), slippery])
def test_a_store_goes_on_in_gymnasiums_world(tmp_path, world):
    first = rl.compare(
        world, ["Q+EG"], 1, steps=200, n_jobs=1, progress=False, store=tmp_path
    )
    more = rl.compare(world, ["Q+EG"], steps=200, store=tmp_path, **FAST)
    assert first["Q+EG"][0].seconds == more["Q+EG"][0].seconds  # not run again
    assert same(rl.Comparison.load(tmp_path, world), more)


def test_a_store_knows_its_world_by_its_id_and_its_arguments(tmp_path):
    spec = gymnasium.spec("FrozenLake-v1")
    ran = rl.compare(spec, ["Q+EG"], steps=100, store=tmp_path, **FAST)
    assert same(rl.Comparison.load(tmp_path), ran)
    dry = gymnasium.make("FrozenLake-v1", is_slippery=False).spec
    with pytest.raises(
        ValueError,
        match=r"has another experiment: kwargs is .* in the store, .*is_slippery",
    ):
        rl.compare(dry, ["Q+EG"], steps=100, store=tmp_path, **FAST)
    for other in (dry, CLIFF, slippery):
        with pytest.raises(ValueError, match="was made in another world"):
            rl.Comparison.load(tmp_path, other)


def test_a_store_of_a_function_needs_it_and_knows_its_code(tmp_path):
    def mine():
        return RandomWorld(p_end=0.2)

    def yours():
        return RandomWorld(p_end=0.3)

    ran = rl.compare(mine, ["Q+SR"], steps=50, store=tmp_path, **FAST)
    assert same(rl.Comparison.load(tmp_path, mine), ran)
    with pytest.raises(
        ValueError,
        match="made in what a function makes, which it lacks; give it as world=",
    ):
        rl.Comparison.load(tmp_path)
    with pytest.raises(ValueError, match="what makes it is"):
        rl.compare(yours, ["Q+SR"], steps=50, store=tmp_path, **FAST)


def test_episodes_that_do_not_end_in_time_are_said():
    with pytest.raises(
        ValueError, match="in 50 steps only 0 episodes have ended; give more steps"
    ):
        rl.compare(CLIFF, ["Q+RANDOM"], steps=50, episodes=1, **FAST)


@pytest.mark.parametrize(
    "world, match",
    [("CliffWalkin-v1", "`CliffWalkin` doesn't exist. Did you mean: `CliffWalking`"),
     ("wander", "the toolkit has no task 'wander'; did you mean"), (3, "a world is a task, a sample model, .*, not 3"),
     (lambda: 3, "must return a new environment of Gymnasium, not 3"),
     (gymnasium.make(CLIFF), "must be a new one each time: give its id, or a function that makes it"),
     ("CartPole-v1", "a tabular agent needs MultiDiscrete or Discrete observations")],
)  # fmt: skip
def test_what_is_no_world_is_refused_before_anything_runs(world, match):
    for call in (
        partial(rl.compare, world, ["Q+SR"]),
        partial(rl.repeat, world, "Q+SR", repetitions=2),
    ):
        with pytest.raises((ValueError, gymnasium.error.Error), match=match):
            call(steps=10, progress=False)


def test_gymnasiums_world_has_no_robot_but_may_be_drawn():
    for weak in ({"engine": "kinematic"}, {"realism": rl.Realism()}):
        with pytest.raises(
            ValueError, match="only a task has a robot: leave engine, realism"
        ):
            rl.make_env(CLIFF, **weak)
    with rl.make_env(CLIFF, seed=0, render_mode="rgb_array") as env:
        env.reset()
        assert env.render_mode == "rgb_array"
    with rl.make_env("FrozenLake-v1", map_name="8x8") as env:
        assert env.observation_space.n == 64


def test_one_seed_one_environment():
    def walk(seed):
        with rl.make_env("FrozenLake-v1", seed=seed) as env:
            seen = [int(env.reset()[0]), *(int(env.step(2)[0]) for _ in range(6))]
        return seen

    walks = [walk(seed) for seed in (0, 0, 1, 2, 3)]
    assert walks[0] == walks[1] and len({*map(str, walks)}) > 1


def test_no_task_has_a_name_like_an_id():
    assert not [name for name in available_tasks() if re.search(r"-v\d+$", name)]
