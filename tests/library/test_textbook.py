"""The textbook's results come out: small versions of docs/studies/textbook.md, which studies/textbook.py writes.

The bounds are four standard errors or more from the mean of many runs, so other random numbers do not break them.
"""

import re
from pathlib import Path

import numpy as np
import pytest
import textbook
import textbook_worlds as worlds
from gymnasium.envs.toy_text import FrozenLakeEnv, TaxiEnv

import rlrobot_edu as rl

PAGE = Path(__file__).parents[2] / "docs/studies/textbook.md"


@pytest.fixture(scope="module")
def on_the_cliff():
    return {
        method: textbook.cliff(method, 10).mean() for method in ("SARSA", "Q", "ESARSA")
    }


def test_on_the_cliff_sarsa_earns_more_than_q_learning_and_expected_sarsa_most(
    on_the_cliff,
):
    assert -32 < on_the_cliff["SARSA"] < -19
    assert -60 < on_the_cliff["Q"] < -40
    assert (
        -24 < on_the_cliff["ESARSA"] < -18
        and on_the_cliff["ESARSA"] > on_the_cliff["SARSA"]
    )


def test_in_the_windy_gridworld_sarsa_ends_some_160_episodes_in_8000_steps():
    assert 140 < textbook.windy(6).mean() < 182
    plan = rl.value_iteration(worlds.windy_gridworld(), gamma=0.99)
    assert plan.v[30] == pytest.approx(-(1 - 0.99**15) / 0.01), (
        "the shortest way takes 15 steps, as the book says"
    )


def test_in_the_maze_more_planning_takes_fewer_episodes():
    steps = {n: textbook.maze(n, 15, episodes=30) for n in (0, 5, 50)}
    good = {n: textbook.good_from(mine) for n, mine in steps.items()}
    assert good[0] > 15 and good[5] <= 9 and good[50] <= 5
    second = {n: mine[:, 1].mean() for n, mine in steps.items()}
    assert second[0] > 2 * second[5] > 4 * second[50]
    plan = rl.value_iteration(worlds.dyna_maze(), gamma=0.95)
    assert plan.v[18] == pytest.approx(0.95**13), (
        "the shortest way takes 14 steps, as the book says"
    )


def plain_true_online_td(transitions, lam, alpha):
    """The values after each episode of the random walk, as the book's pseudocode has it (section 12.5)."""
    values, traces, old = np.zeros(worlds.WALK_CELLS), np.zeros(worlds.WALK_CELLS), 0.0
    for s, r, s_next, terminated in transitions:
        value, following = values[s], 0.0 if terminated else values[s_next]
        delta = r + following - value
        added = 1 - alpha * lam * traces[s]
        traces *= lam
        traces[s] += added
        values += alpha * (delta + value - old) * traces
        values[s] -= alpha * (value - old)
        old = following
        if terminated:
            traces, old = np.zeros(worlds.WALK_CELLS), 0.0
            yield values.copy()


@pytest.mark.parametrize(("lam", "alpha"), [(0.8, 0.4), (0.0, 0.4), (1.0, 0.1)])
def test_on_the_random_walk_true_online_learning_is_the_books_pseudocode(lam, alpha):
    model, parameters = (
        worlds.random_walk(),
        {"alpha": alpha, "gamma": textbook.GAMMA, "lam": lam, "traces": "full"},
    )
    agent, env = (
        rl.Agent(model, "TOSL+RANDOM", seed=1, **parameters),
        rl.make_env(model, seed=2),
    )
    history = rl.learn(
        agent, env, textbook.LONG, episodes=10, keep=True, progress=False
    )
    steps = zip(
        history.s, history.rewards, history.s_next, history.terminated, strict=True
    )
    *_, last = plain_true_online_td(steps, lam, alpha)
    assert agent.q[:, 0] == pytest.approx(last, abs=1e-6)  # γ is 1e-9 from 1


def test_on_the_random_walk_its_error_is_the_books():
    long, short = textbook.walk(0.8, 0.4, 60), textbook.walk(0.0, 0.4, 60)
    assert 0.22 < long.mean() < 0.28 and 0.40 < short.mean() < 0.43


def solved(env, gamma, sweeps=3000):
    """The optimal values of an environment of Gymnasium by plain sweeps over its table."""
    v = np.zeros(env.observation_space.n)
    for _ in range(sweeps):
        v = np.array([
            max(sum(p * (r + (not end) * gamma * v[s_next]) for p, s_next, r, end in env.P[s][a]) for a in env.P[s])
            for s in env.P
        ])  # fmt: skip
    return v


@pytest.mark.parametrize(("size", "value"), [("4x4", 0.5420), ("8x8", 0.4146)])
def test_value_iteration_solves_the_frozen_lake(size, value):
    assert textbook.frozen_lake(size) == pytest.approx(value, abs=5e-5)
    plan = rl.value_iteration(
        worlds.of_gymnasium(FrozenLakeEnv(map_name=size)), gamma=0.99
    )
    assert plan.v == pytest.approx(
        solved(FrozenLakeEnv(map_name=size), 0.99, 1500), abs=1e-6
    )


def test_the_best_trips_of_the_taxi_earn_793_on_average():
    trips = textbook.taxi()
    assert trips.mean() == pytest.approx(7.93, abs=0.005)
    env = TaxiEnv()
    best = solved(env, 1.0, 60)[
        env.initial_state_distrib > 0
    ]  # without discounting: a trip takes 18 steps at most
    assert trips == pytest.approx(best)


def test_the_worlds_are_those_of_gymnasium():
    cliffs = rl.value_iteration(worlds.cliff(), gamma=0.9).v[36]
    assert cliffs == pytest.approx(-(1 - 0.9**13) / 0.1), "13 steps along the edge"


def test_the_page_is_the_studys_and_its_numbers_are_near_the_published_ones():
    text = PAGE.read_text(encoding="utf-8")
    for part in re.split(r"\{\w+\}", textbook.PAGE):
        assert part in text
    here = [
        line.rpartition(" | ")[2].removesuffix(" |")
        for line in text.splitlines()
        if re.match(r"\| .*\d", line)
    ]
    numbers = [
        [float(x) for x in re.findall(r"-?\d+(?:\.\d+)?", cell.replace("−", "-"))]
        for cell in here
    ]
    published = [-25, -50, -21, 165, [25, 5, 3], None, 0.26, 0.542, 0.4146, 7.93]
    assert len(numbers) == len(published)
    for got, expected in zip(numbers, published, strict=True):
        if isinstance(expected, list):
            assert got == pytest.approx(expected, abs=2)
        elif expected is not None:
            assert got[0] == pytest.approx(expected, rel=0.06)
