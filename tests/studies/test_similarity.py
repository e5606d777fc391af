"""When similarity helps: the split, worlds of one order, the skill of advice, and that the page says what they show."""

import json

import numpy as np
import pytest
import similarity
import similarity_figures as figures
import similarity_numbers as numbers
import similarity_page
from scipy import stats
from similarity_split import (
    factors,
    of_order,
    spectrum,
    spectrum_of_noise,
    split,
)
from similarity_worlds import ACTIONS, SHAPE, EvenWorld, rewards_of_order
from test_headlines import ROOT

import rlrobot_edu as rl
from rlrobot_edu.widgets.kernels import bias_of

FOUND = json.loads((ROOT / "studies/similarity.json").read_text(encoding="utf-8"))
THREE = (3, 1, 4)


def table_of(shape, n_actions=3, seed=0):
    rng = np.random.default_rng(seed)
    return rng.normal(size=(int(np.prod(shape)), n_actions))


@pytest.mark.parametrize("shape", [(2,), THREE, (2, 3, 2, 2)])
def test_the_parts_sum_to_q_and_each_is_centred_over_its_inputs_and_needs_no_other(
    shape,
):
    q = table_of(shape)
    parts = split(q, shape)
    assert len(parts) == 2 ** len(shape)
    np.testing.assert_allclose(sum(parts.values()), q.reshape(*shape, -1), atol=1e-12)
    for inputs, part in parts.items():
        for i in range(len(shape)):
            if i in inputs:
                np.testing.assert_allclose(part.mean(axis=i), 0, atol=1e-12)
            else:
                assert part.shape[i] == 1


def test_the_spectrum_of_noise_counts_dimensions_and_is_the_mean_of_noisy_tables():
    expected = np.array([1, 15, 90, 270, 405, 243]) / 1024  # of (1 + 3 x)^5
    np.testing.assert_allclose(spectrum_of_noise((4,) * 5), expected)
    tables = [spectrum(table_of(THREE, seed=seed), THREE) for seed in range(400)]
    mean = np.mean(tables, axis=0)
    np.testing.assert_allclose(mean, spectrum_of_noise(THREE), atol=0.02)


def test_the_mean_factor_of_noise_is_1_plus_the_mean_of_1_over_the_bins():
    for shape in (THREE, (4, 8, 4, 8), (2, 2)):
        mean = spectrum_of_noise(shape) @ factors(len(shape))
        assert mean == pytest.approx(1 + np.mean(1 / np.array(shape)))


def test_a_table_in_which_no_action_is_better_has_no_spectrum():
    with pytest.raises(ValueError, match="same value in every state"):
        spectrum(np.ones((12, 3)), THREE)


def test_the_mean_factor_is_the_slope_of_q_plus_bias_over_q():
    q = table_of(THREE)
    biased = np.array([row + bias_of(q, THREE, s) for s, row in enumerate(q)])
    centred, both = (x - x.mean(axis=1, keepdims=True) for x in (q, biased))
    slope = (both * centred).sum() / (centred * centred).sum()
    assert spectrum(q, THREE) @ factors(3) == pytest.approx(slope)


@pytest.mark.parametrize("k", range(6))
def test_softmax_at_the_fair_temperature_chooses_as_qbiassr_in_a_table_of_one_order(k):
    q = of_order(table_of(SHAPE, ACTIONS), SHAPE, k)
    world = EvenWorld(q, np.random.SeedSequence(0))
    chosen = []
    for method, temperature in (("Q+QBIASSR", 0.3), ("Q+SR", 0.3 / factors(5)[k])):
        agent = rl.Agent(world, method, temperature=temperature, **similarity.EVEN)
        agent.q[:] = q
        for s in (0, 77, 1023):
            agent.begin_episode(s)
            chosen.append(agent.probabilities.copy())
    biased, fair = chosen[:3], chosen[3:]
    assert not np.allclose(biased, 1 / ACTIONS)
    np.testing.assert_allclose(biased, fair, atol=1e-12)


@pytest.mark.parametrize("k", range(6))
def test_a_world_of_one_order_has_rewards_of_no_other(k):
    rewards = rewards_of_order(k, np.random.default_rng(3))
    np.testing.assert_allclose(spectrum(rewards, SHAPE), np.eye(6)[k], atol=1e-12)
    np.testing.assert_allclose(rewards.mean(axis=1), 0, atol=1e-12)
    assert rewards.std() == pytest.approx(2)


def test_the_compiled_loop_in_such_a_world_is_the_plain_one():
    rewards = rewards_of_order(2, np.random.default_rng(0))
    earned = []
    for is_compiled in (True, False):
        env = EvenWorld(rewards, np.random.SeedSequence(1))
        agent = rl.Agent(env, "Q+QBIASSR", seed=2, **similarity.EVEN)
        if is_compiled:
            earned.append(rl.learn(agent, env, 300, progress=False).rewards)
        else:
            earned.append([step.r for step in rl.steps(agent, env, steps=300)])
    np.testing.assert_array_equal(*earned)


def test_the_advice_is_what_others_think_and_its_skill_is_what_it_saves():
    q = np.array(
        [[5.0, 0.0], [1.0, 4.0], [3.0, 2.0], [0.0, 6.0]]
    )  # two inputs, two bins
    shape = (2, 2)
    np.testing.assert_allclose(similarity.advice(q, shape, 0), [2.0, 3.0])
    # the favourites are 1, 1 (6 against 5/2), 1 (3 against 5/2) and 1 (3 against 2)
    np.testing.assert_allclose(similarity.advice(q, shape, 1), [2.5, 3.0])
    np.testing.assert_allclose(similarity.advice(q, shape, 2), [2.5, 3.0])
    np.testing.assert_allclose(similarity.advice(q, shape, 3), [2.0, 3.0])
    lost, by_chance = 5 + 0 + 1 + 0, 2.5 + 1.5 + 0.5 + 3
    skill = similarity.skill(q, shape, np.arange(4))
    assert skill == pytest.approx(1 - lost / by_chance)


def test_advice_is_perfect_where_nothing_depends_on_the_state():
    q = np.tile([1.0, 3.0, 2.0], (12, 1))
    assert similarity.skill(q, THREE, np.arange(12)) == 1


def test_the_page_is_what_its_numbers_say():
    text = similarity_page.PAGE_OF.read_text(encoding="utf-8")
    assert text == similarity_page.page(FOUND)


def test_the_factors_in_the_figure_are_those_of_the_theorem():
    np.testing.assert_allclose(figures.measured_factors(), factors(5), atol=1e-12)


@pytest.mark.parametrize("temperature", FOUND["orders"])
def test_the_gain_falls_with_the_order_as_the_page_says(temperature):
    means = numbers.gains(FOUND, temperature, "SR").mean(axis=1)
    assert (np.diff(means[:, 1]) < 0).all()
    slope = numbers.slope(FOUND, temperature, 1)
    assert slope.mean + slope.half < 0
    first, last = (f"{means[k, 1]:+.2f}".replace("-", "−") for k in (0, 5))
    assert f"{first} to {last} (T = {temperature})" in figures.gain_finding(FOUND)


def intervals(temperature, rival):
    """Low and high ends of the gains' 95 % intervals, arrays (orders, lengths)."""
    its = numbers.gains(FOUND, temperature, rival).swapaxes(1, 2)
    ends = [[numbers.estimate(worlds) for worlds in order] for order in its]
    low = np.array([[end.mean - end.half for end in order] for order in ends])
    high = np.array([[end.mean + end.half for end in order] for order in ends])
    return low, high


def test_what_the_page_says_of_the_fair_temperature_is_so():
    low, high = intervals("1", "SR, fair T")
    assert (low[:5, 0] <= 0).all()
    ahead_later = (low[:5, 1:] > 0).all(axis=1)
    assert ahead_later.tolist() == [True] * 3 + [False] * 2
    over_both = [
        numbers.gains(FOUND, "1", rival).mean(axis=1)[:5] for rival in figures.RIVALS
    ]
    assert (over_both[1] < over_both[0] / 2).all()  # most of it is temperature
    low, high = intervals("0.2", "SR, fair T")
    assert (low[:4] > 0).all()
    over_both = [
        numbers.gains(FOUND, "0.2", rival).mean(axis=1)[:4] for rival in figures.RIVALS
    ]
    assert (over_both[1] > over_both[0] / 2).all()  # most of it is advice
    for rival in figures.RIVALS:
        low, high = intervals("0.2", rival)
        assert (high[4:, 1] < 0).all()


def test_a_table_of_a_few_tries_has_low_orders_that_the_rewards_do_not_have():
    rewards = rewards_of_order(5, np.random.default_rng(0))
    env = EvenWorld(rewards, np.random.SeedSequence(0))
    agent = rl.Agent(env, "Q+QBIASSR", temperature=0.2, seed=0, **similarity.EVEN)
    rl.learn(agent, env, 20_000, progress=False)
    assert (agent.visits == 0).mean() > 0.5
    assert spectrum(agent.q, SHAPE)[:5].sum() > 0.4


def test_the_spectra_are_titled_with_what_the_low_orders_have():
    for task in ("wander_1k", "arm_1k"):
        shares = np.array(FOUND["spectra"][task][numbers.METHOD])
        share = 100 * shares[:, :2].sum(axis=1).mean()
        assert f"{share:.0f} % in {task}" in figures.spectra_finding(FOUND)


def test_the_rank_correlation_is_scipys_and_shows_nothing():
    its = FOUND["advice"].values()
    skills = [np.mean(x["skill"]) for x in its]
    gained = [np.mean(x["QBIASSR"]) - np.mean(x["SR"]) for x in its]
    rank = numbers.rank_correlation(FOUND)
    assert rank.rho == pytest.approx(stats.spearmanr(skills, gained).statistic)
    assert abs(rank.rho) < rank.critical
    assert rank.critical == pytest.approx(0.738, abs=5e-4)  # of printed tables, n = 8
    assert rank.p > 0.05


def test_where_the_advice_is_best_no_gain_is_shown():
    advice = FOUND["advice"]
    best = sorted(advice, key=lambda task: -np.mean(advice[task]["skill"]))[:2]
    assert set(best) == {"arm_4k", "worked_example"}
    for task in best:
        gain = numbers.gain_of_robots(advice[task])
        assert abs(gain.mean) < gain.half
