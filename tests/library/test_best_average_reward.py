"""The best achievable average reward: against every policy there is."""

import itertools

import numpy as np
import pytest
from worlds import recording_of

import rlrobot_edu as rl
from rlrobot_edu.models.value_iteration import best_average_reward, expected_outcomes


def best_of_all_policies(model):
    """Long-run average reward from the starts of each deterministic policy, the largest one."""
    expected = expected_outcomes(model)
    n, m = model.n_states, model.n_actions
    t = expected.transitions.toarray() + expected.anywhere[:, None] / n
    starts = np.bincount(model.starts, minlength=n) / len(model.starts)
    t += (1 - t.sum(axis=1))[:, None] * starts
    best = -np.inf
    for policy in itertools.product(range(m), repeat=n):
        pairs = np.arange(n) * m + policy
        lazy = np.linalg.matrix_power(
            (t[pairs] + np.eye(n)) / 2, 2**20
        )  # same average, but no circles that swing
        best = max(best, starts @ lazy @ expected.reward[pairs])
    return best


def random_model(seed, unseen, p_end=0.0, rows=14):
    rng = np.random.default_rng(seed)
    columns = (
        rng.integers(6, size=rows),
        rng.integers(2, size=rows),
        rng.choice([-1.0, 0.0, 5.0], rows),
    )
    s_next, end = rng.integers(6, size=rows), rng.random(rows) < p_end
    return rl.SampleModel.from_recording(
        recording_of(list(zip(*columns, s_next, end, strict=True))), unseen=unseen
    )


@pytest.mark.parametrize("unseen", ["uniform", "stay", "siblings"])
@pytest.mark.parametrize("seed", range(8))
def test_no_policy_of_a_random_model_is_better_and_one_is_as_good(seed, unseen):
    for p_end in (0.0, 0.3):
        model = random_model(seed, unseen, p_end)
        assert best_average_reward(model) == pytest.approx(
            best_of_all_policies(model), abs=1e-5
        )


def test_the_best_loop_counts_only_as_far_as_it_can_be_reached():
    rows = [
        (0, 0, 0.0, 1, 0),
        (1, 0, -1.0, 1, 0),
        (0, 1, 0.0, 0, 0),
        (2, 0, 5.0, 2, 0),
        (2, 1, 5.0, 2, 0),
    ]
    model = rl.SampleModel.from_recording(
        recording_of(rows[:3], rewards=(-1.0, 0.0, 5.0)), unseen="stay"
    )
    assert best_average_reward(model) == pytest.approx(0.0, abs=1e-5)

    lottery = [
        (0, 0, 0.0, 2, 0),
        (2, 0, 5.0, 2, 0),
        (0, 0, 0.0, 3, 0),
        (3, 0, -1.0, 3, 0),
        (0, 1, 0.0, 0, 0),
    ]
    model = rl.SampleModel.from_recording(recording_of(lottery), unseen="stay")
    model = model.__class__(**{**vars(model), "starts": np.array([0])})
    assert best_average_reward(model) == pytest.approx((5 - 1) / 2, abs=1e-5)


def test_a_circle_that_pays_only_now_and_then_is_averaged():
    circle = [(s, 0, 5.0 if s == 5 else 0.0, (s + 1) % 6, 0) for s in range(6)]
    model = rl.SampleModel.from_recording(recording_of(circle), unseen="stay")
    assert best_average_reward(model) == pytest.approx(5 / 6, abs=1e-5)


def test_an_episode_counts_its_goal_for_the_rest_of_its_time():
    rows = [(0, 0, 0.0, 1, 0), (1, 0, 5.0, 2, 1)]
    model = rl.SampleModel.from_recording(recording_of(rows), unseen="stay")
    model = model.__class__(
        **{**vars(model), "episode_steps": 10, "starts": np.array([0])}
    )
    assert best_average_reward(model) == pytest.approx((0 + 9 * 5) / 10)


def test_the_optimum_of_the_course_model_is_above_what_agents_reach(wander_model):
    best = best_average_reward(wander_model)
    assert 8 < best <= wander_model.r_max + 1e-9
    assert (
        rl.repeat(wander_model, repetitions=3, steps=3600)[0].average_reward[-1] < best
    )
