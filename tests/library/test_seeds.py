"""One seed, two streams: an agent and an environment that are made from the same number draw numbers of their own."""

import zlib

import numpy as np
import pytest
from oracles import NumpyModelWorld, learn_in_one_file

import rlrobot_edu as rl
from rlrobot_course.worlds.short_world import ShortWorld

SEEDS, DRAWS = range(3), 200
WORLDS = ("worked_example", "wander_1k", "FrozenLake-v1", "a model")


@pytest.fixture(params=WORLDS)
def world(request, wander_model):
    return wander_model if request.param == "a model" else request.param


def drawn(rng):
    return rng.random(DRAWS).tolist()


@pytest.mark.parametrize("seed", SEEDS)
def test_agent_and_environment_of_one_seed_have_no_number_in_common(world, seed):
    env = rl.make_env(world, seed=seed)
    agent = rl.Agent(env, seed=seed)
    assert set(drawn(agent.rng)).isdisjoint(drawn(env.unwrapped.np_random))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_reset_with_the_agents_seed_gives_the_environment_its_own_numbers_again(
    wander_model, seed
):
    for world in ("worked_example", "wander_1k", wander_model):
        agent, env = rl.Agent(world, seed=seed), rl.make_env(world, seed=99)
        env.reset(seed=seed)
        numbers = drawn(env.unwrapped.np_random)
        assert set(drawn(agent.rng)).isdisjoint(numbers)
        made = rl.make_env(world, seed=seed)
        made.reset()
        assert drawn(made.unwrapped.np_random) == numbers


@pytest.mark.parametrize("seed", SEEDS)
def test_a_short_world_draws_what_the_agent_would_and_nothing_that_its_environment_draws(
    world, seed
):
    short = ShortWorld(rl.make_env(world, seed=seed), seed)
    numbers = []
    for i in range(30):
        if i == 0 or short.ended:
            short.reset()
            short.ended = False
        else:
            short.step(0)
        numbers.append(short.u)
    assert numbers == drawn(rl.Agent(short.env, seed=seed).rng)[:30]
    assert set(numbers).isdisjoint(
        drawn(rl.make_env(world, seed=seed).unwrapped.np_random)
    )


def test_a_seed_sequence_is_taken_as_it_is(world):
    for numbers in (7, [7, 1]):
        expected = drawn(np.random.default_rng(np.random.SeedSequence(numbers)))
        assert (
            drawn(
                rl.Agent(rl.make_env(world), seed=np.random.SeedSequence(numbers)).rng
            )
            == expected
        )
        if world != "FrozenLake-v1":  # Gymnasium's own takes a number
            assert (
                drawn(
                    rl.make_env(
                        world, np.random.SeedSequence(numbers)
                    ).unwrapped.np_random
                )
                == expected
            )


def test_an_agent_draws_what_numpy_draws_with_its_seed():
    assert drawn(rl.Agent("wander_1k", seed=np.int64(3)).rng) == drawn(
        np.random.default_rng(3)
    )


@pytest.mark.parametrize("several", ["repeat", "compare"])
def test_a_repetition_is_a_plain_loop_with_numpys_own_generators_of_its_two_seeds(
    wander_model, several
):
    method = "TOSL+QBIASSR"
    if several == "repeat":
        runs = rl.repeat(
            wander_model, method, repetitions=2, steps=400, seed=0, progress=False
        )
    else:
        runs = rl.compare(wander_model, [method], 2, steps=400, seed=0, progress=False)[
            method
        ]
    key = (zlib.crc32(method.encode()),)
    for its, history in zip(
        np.random.SeedSequence(0, spawn_key=key).spawn(2), runs, strict=True
    ):
        of_agent, of_world = map(np.random.default_rng, its.spawn(2))
        world = NumpyModelWorld(wander_model, of_world)
        _, rewards = learn_in_one_file(world, wander_model, 400, of_agent)
        np.testing.assert_array_equal(history.rewards, rewards)
