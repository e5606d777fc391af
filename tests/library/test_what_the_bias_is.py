"""What QBIASSR's bias is, against a split of Q of its own: docs/when_similarity_helps.md."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rlrobot_edu.widgets.kernels import bias_of

SHAPES = st.lists(st.integers(1, 5), min_size=1, max_size=5)


def parts(q, shape):
    """Q_U by U, arrays (*shape, actions), by inclusion and exclusion: for each set V of inputs within U, the mean over
    the inputs that are not in V, with the sign (-1)^(|U| - |V|).
    """
    n, table = len(shape), q.reshape(*shape, -1)
    found = {}
    for k in range(n + 1):
        for inputs in combinations(range(n), k):
            part = np.zeros_like(table)
            for kept in range(k + 1):
                for within in combinations(inputs, kept):
                    others = tuple(i for i in range(n) if i not in within)
                    mean = table.mean(axis=others, keepdims=True)
                    part += (-1) ** (k - kept) * mean
            found[inputs] = part
    return found


def with_bias(q, shape, bias):
    """Q(s) + bias(s) of all states, array (n_states, actions)."""
    return np.array([q[s] + bias(q, shape, s) for s in range(len(q))])


def as_the_theorem_says(q, shape):
    """The sum of all (2 - |U| / n) Q_U, array (n_states, actions)."""
    n = len(shape)
    total = sum((2 - len(u) / n) * part for u, part in parts(q, shape).items())
    return total.reshape(q.shape)


def random_table(shape, n_actions, seed):
    return np.random.default_rng(seed).normal(size=(int(np.prod(shape)), n_actions))


@given(SHAPES, st.integers(1, 4), st.integers(0, 2**32))
@settings(max_examples=40, deadline=None)
def test_the_bias_weighs_what_needs_k_of_n_inputs_by_1_minus_k_over_n(
    shape, n_actions, seed
):
    q = random_table(shape, n_actions, seed)
    found = with_bias(q, shape, bias_of)
    np.testing.assert_allclose(found, as_the_theorem_says(q, shape), rtol=0, atol=1e-12)


def sets_of(q, shape, s):
    """The values of each set of similar states, arrays (bins, actions), and the bin of `s` in each."""
    table, bins = q.reshape(*shape, -1), np.unravel_index(s, shape)
    for i, place in enumerate(bins):
        yield table[(*bins[:i], slice(None), *bins[i + 1 :])], place


def without_s(q, shape, s):
    return np.mean(
        [np.delete(its, place, axis=0).mean(axis=0) for its, place in sets_of(q, shape, s)],
        axis=0,
    )  # fmt: skip


def in_one_sum(q, shape, s):
    return np.concatenate([its for its, _ in sets_of(q, shape, s)]).mean(axis=0)


def of_the_last_input(q, shape, s):
    *_, (its, _) = sets_of(q, shape, s)
    return its.mean(axis=0)


@pytest.mark.parametrize("other", [without_s, in_one_sum, of_the_last_input])
def test_another_bias_is_none_of_this(other):
    shape = (2, 3, 4)
    q = random_table(shape, 2, seed=0)
    theory = as_the_theorem_says(q, shape)
    np.testing.assert_allclose(with_bias(q, shape, bias_of), theory, rtol=0, atol=1e-12)
    assert np.abs(with_bias(q, shape, other) - theory).max() > 0.1


def test_without_the_state_itself_two_bins_would_cancel_what_needs_all_inputs():
    shape = (2, 2, 2)
    q = parts(random_table(shape, 2, seed=0), shape)[0, 1, 2].reshape(8, 2)
    np.testing.assert_allclose(with_bias(q, shape, bias_of), q, rtol=0, atol=1e-12)
    np.testing.assert_allclose(with_bias(q, shape, without_s), 0, rtol=0, atol=1e-12)


def test_an_input_with_one_bin_counts_in_n_and_is_needed_by_no_part():
    q = random_table((3, 1), 2, seed=0)
    alone = {len(u): part for u, part in parts(q, (3,)).items()}
    found = with_bias(q, (3, 1), bias_of)
    expected = 2 * alone[0] + 1.5 * alone[1]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)
    np.testing.assert_allclose(with_bias(q, (3,), bias_of), 2 * alone[0] + alone[1])


def test_the_bias_of_the_bias_again_and_again_is_a_robot_that_sees_nothing():
    shape = (3, 4, 2)
    q = random_table(shape, 3, seed=1)
    filtered = q
    for _ in range(90):
        filtered = with_bias(filtered, shape, bias_of) - filtered
    same_everywhere = np.broadcast_to(q.mean(axis=0), q.shape)
    np.testing.assert_allclose(filtered, same_everywhere, rtol=0, atol=1e-12)
