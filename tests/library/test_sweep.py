"""Sweeps: the same robots at every setting, the number that `rl.learn` gives, and what the box of settings is."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.sweep import BOX, Range, Sweep, random_settings, sweep

TWO = [{"alpha": 0.1, "temperature": 1.0}, {"alpha": 0.5, "temperature": 0.1}]


def small(model, settings=TWO, **more):
    given = {"robots": 3, "steps": 300, "seed": 1, "n_jobs": 1, "progress": False}
    return sweep(model, settings, **{**given, **more})


def test_a_score_is_the_final_average_reward_of_the_agent_made_by_hand(wander_model):
    result = small(wander_model, method="TOSL+SR")
    for robot, seed in enumerate(np.random.SeedSequence(1).spawn(3)):
        agent_seed, env_seed = seed.spawn(2)
        env = rl.make_env(wander_model, env_seed)
        agent = rl.Agent(env, "TOSL+SR", seed=agent_seed, **TWO[1])
        history = rl.learn(agent, env, 300, progress=False)
        assert result.scores[1, robot] == history.final_average_reward


def test_all_settings_share_their_random_numbers(wander_model):
    twice = small(wander_model, [TWO[0], TWO[1], TWO[0]], method="Q+SR")
    assert np.array_equal(twice.scores[0], twice.scores[2])
    assert not np.array_equal(twice.scores[0], twice.scores[1])
    alone = small(wander_model, [TWO[1]], robots=2, method="Q+SR")
    assert np.array_equal(alone.scores[0], twice.scores[1, :2])
    at_random = [{"method": "Q+RANDOM"}, {"method": "TOSL+RANDOM"}]
    as_one = small(wander_model, at_random)
    assert np.array_equal(*as_one.scores)  # what they learn changes nothing


def test_the_scores_depend_on_the_seed_and_not_on_the_number_of_cores(wander_model):
    one = small(wander_model)
    assert np.array_equal(one.scores, small(wander_model, n_jobs=2).scores)
    assert not np.array_equal(one.scores, small(wander_model, seed=2).scores)


@pytest.mark.long
def test_a_robots_task_gives_the_same_numbers_in_other_processes():
    one, two = (
        small("arm_1k", episodes=1, engine="kinematic", n_jobs=n) for n in (1, 2)
    )
    assert np.array_equal(one.scores, two.scores)


def test_the_settings_fill_the_box_evenly():
    settings = random_settings(64, seed=3)
    assert len(settings) == 64 and list(settings[0]) == list(BOX)
    for name, its in BOX.items():
        values = np.array([setting[name] for setting in settings])
        if its.log:
            values = np.log(values / its.low) / np.log(its.high / its.low)
        else:
            values = (values - its.low) / (its.high - its.low)
        # of a Sobol sequence there is one in each 64th of the range
        assert sorted((64 * values).astype(int)) == list(range(64))
    assert random_settings(20, seed=3) == random_settings(32, seed=3)[:20]
    assert random_settings(4, seed=4) != random_settings(4, seed=3)
    assert Range(1, 100, log=True).at(0.5) == pytest.approx(10)


def test_regret_is_what_a_setting_earns_less_than_the_best():
    result = Sweep(TWO, np.array([[1.0, 3.0], [4.0, 6.0]]))
    assert result.means.tolist() == [2.0, 5.0] and result.winner == TWO[1]
    assert (result.regret(0), result.regret(1)) == (3.0, 0.0)
    (first, _) = result.table().rows
    assert first == [0.5, 0.1, 5.0, 1.0]
    with pytest.raises(ValueError, match="setting"):
        result.regret(2)


def test_the_map_has_a_dot_for_each_setting_and_its_title_the_numbers():
    result = Sweep(TWO, np.array([[1.0, 3.0], [4.0, 6.0]]))
    picture = result.plot()
    (dots,) = picture.axes[0].collections
    assert dots.get_offsets().tolist() == [[1.0, 0.1], [0.1, 0.5]]
    assert dots.get_array().tolist() == [2.0, 5.0]
    assert "5.00" in picture.finding and "3.50" in picture.alt
    with pytest.raises(ValueError, match="gama"):
        result.plot("gama")


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"settings": []}, "at least one setting"),
        ({"settings": [{"alfa": 1}]}, "alfa"),
        ({"settings": [{"alpha": 7}]}, "alpha"),
        ({"robots": 0}, "robots"),
        ({"temperatur": 1}, "temperatur"),
        ({"n_jobs": 0}, "n_jobs"),
        ({"seed": -1}, "seed"),
        ({"episodes": 3}, "no episodes"),
    ],
)
def test_what_is_wrong_is_refused_before_anything_runs(wander_model, wrong, message):
    with pytest.raises(ValueError, match=message):
        small(wander_model, **wrong)
