"""Lesson 07b's figures: weights with which both views of λ agree, and the walk in which the values are known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rlrobot_course.lesson_07.exercises import sarsa_lambda_update
from rlrobot_course.lesson_07b.figures import lambda_weights, plot_views
from rlrobot_course.lesson_07b.random_walk import TRUE, sweep


@given(st.floats(0, 1), st.integers(1, 30))
def test_the_weights_sum_to_one(lam, steps):
    weights = lambda_weights(lam, steps)
    assert len(weights) == steps
    assert weights.sum() == pytest.approx(1)


def test_lambda_0_looks_one_step_ahead_and_lambda_1_to_the_end():
    assert lambda_weights(0.0, 4).tolist() == [1, 0, 0, 0]
    assert lambda_weights(1.0, 4).tolist() == [0, 0, 0, 1]


@given(st.floats(0, 1), st.integers(1, 12), st.integers(0, 1000))
def test_forward_and_backward_view_agree_while_q_stays_as_it_is(lam, steps, seed):
    gamma, rng = 0.9, np.random.default_rng(seed)
    r, v = rng.normal(size=steps), np.append(rng.normal(size=steps), 0.0)
    returns = [gamma ** np.arange(n) @ r[:n] + gamma**n * v[n] for n in range(1, steps + 1)]
    delta = r + gamma * v[1:] - v[:-1]
    forward = lambda_weights(lam, steps) @ returns
    assert forward == pytest.approx(v[0] + (gamma * lam) ** np.arange(steps) @ delta)


def test_the_picture_of_the_views_writes_both_kinds_of_weights():
    picture = plot_views(gamma=0.9, lam=0.5, steps=3)
    above, below = ([text.get_text() for text in ax.texts] for ax in picture.axes)
    assert above[:3] == ["0.50", "0.25", "0.25"]
    assert below[:4] == ["1.00", "0.45", "0.20", "0.09"]


def test_the_walks_true_values_are_the_mean_of_their_neighbours():
    values = np.concatenate([[-1.0], TRUE, [1.0]])
    np.testing.assert_allclose(TRUE, (values[:-2] + values[2:]) / 2, atol=1e-12)


def test_the_sweep_shows_the_error_of_each_lambda():
    errors = sweep(sarsa_lambda_update, (0.0, 0.8, 1.0), walkers=12, alpha=0.4, episodes=5)
    assert errors[0.8].mean() < min(errors[0.0].mean(), errors[1.0].mean())
