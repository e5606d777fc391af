"""The biases beside the paper's: against NumPy along the axes of Q, and what must hold of each."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import numpy_bias, numpy_softmax

import rlrobot_edu as rl
from rlrobot_course.lesson_22.biases import BIASES
from rlrobot_edu.learning.size import Size

ALPHA, OTHERS = 0.1, {bias.name: bias for bias in BIASES}


def families(table, shape, s):
    """The rows of `table` (S, A) along each input's axis through `s`, `s` included: one array (bins, A) an input."""
    cube, bins = table.reshape(*shape, -1), np.unravel_index(s, shape)
    return [
        cube[(*bins[:i], slice(None), *bins[i + 1 :])] for i in range(len(shape))
    ], bins


def weighed(q, visits, shape, s):
    """VBIASSR: one mean over all the rows, each weighed by its visits and by one over its input's bins."""
    values, _ = families(q, shape, s)
    says = [n / len(n) for n in families(visits, shape, s)[0]]
    said = np.concatenate(says).sum(axis=0)
    total = (np.concatenate(says) * np.concatenate(values)).sum(axis=0)
    return np.divide(total, said, out=np.zeros_like(total), where=said > 0)


def of_others(q, visits, shape, s):
    """OBIASSR: numpy's means, with the row of `s` taken out; a set without others says zero."""
    others = [
        np.delete(rows, b, axis=0)
        for rows, b in zip(*families(q, shape, s), strict=True)
    ]
    return np.mean(
        [rows.mean(axis=0) if len(rows) else np.zeros(q.shape[1]) for rows in others],
        axis=0,
    )


def fading(q, visits, shape, s):
    """FBIASSR: the paper's, times what is left of Q's first value after so many updates."""
    return numpy_bias(q, shape, s) * (1 - ALPHA) ** visits[s]


def corrected(q, visits, shape, s):
    """TBIASSR: from its definition, the paper's preferences over the weight of Q(s) in them, less Q(s)."""
    share = np.mean(1 / np.array(shape))
    return (q[s] + numpy_bias(q, shape, s)) / (1 + share) - q[s]


ORACLES = {
    "VBIASSR": weighed,
    "OBIASSR": of_others,
    "FBIASSR": fading,
    "TBIASSR": corrected,
}


def agent_of(selection, shape, q, visits):
    method = rl.Method("TOSL", OTHERS.get(selection, selection))
    agent = rl.Agent(Size(shape, q.shape[1]), method, alpha=ALPHA, r_max=10)
    agent.q[:], agent.visits[:] = q, visits
    return agent


def tables(seed, shape, n_actions=3, most_visits=30):
    rng = np.random.default_rng(seed)
    size = int(np.prod(shape)), n_actions
    return rng.normal(scale=20, size=size), rng.integers(0, most_visits, size) * (
        rng.random(size) < 0.6
    )


@pytest.mark.parametrize("selection", ORACLES)
@given(
    st.integers(0, 2**32),
    st.lists(st.integers(1, 5), min_size=1, max_size=4),
    st.integers(1, 6),
)
@settings(max_examples=40, deadline=None)
def test_each_bias_is_what_numpy_says_along_the_axes_of_q_and_softmax_takes_it(
    selection, seed, shape, n_actions
):
    q, visits = tables(seed, shape, n_actions)
    agent, s = agent_of(selection, tuple(shape), q, visits), seed % len(q)
    agent.begin_episode(s)
    expected = ORACLES[selection](q, visits, shape, s)
    np.testing.assert_allclose(agent.bias, expected, atol=1e-9)
    np.testing.assert_allclose(
        agent.probabilities, numpy_softmax(q[s] + expected, 1.0), atol=1e-9
    )


def chosen(selection, q, visits, shape=(3, 4, 2), s=13):
    """Bias and probabilities in one state."""
    agent = agent_of(selection, shape, q, visits)
    agent.begin_episode(s)
    return agent.bias, agent.probabilities


def test_weighed_by_visits_is_the_papers_bias_where_all_were_tried_as_often_and_nothing_where_none_was():
    q, visits = tables(1, (3, 4, 2))
    same = np.full_like(visits, 7)
    np.testing.assert_allclose(
        chosen("VBIASSR", q, same)[0], chosen("QBIASSR", q, same)[0]
    )
    assert not chosen("VBIASSR", q, 0 * visits)[0].any()


def test_a_pair_that_was_never_tried_has_no_say_in_the_bias_weighed_by_visits():
    q, visits = tables(2, (3, 4, 2))
    other = np.where(visits > 0, q, 1e6)
    np.testing.assert_array_equal(
        chosen("VBIASSR", q, visits)[0], chosen("VBIASSR", other, visits)[0]
    )


def test_the_bias_of_others_does_not_depend_on_the_state_itself():
    q, visits = tables(3, (3, 4, 2))
    other = q.copy()
    other[13] = -5.0
    for selection in ("OBIASSR", "TBIASSR"):
        np.testing.assert_array_equal(
            chosen(selection, q, visits)[0], chosen(selection, other, visits)[0]
        )


def test_the_fading_bias_begins_as_the_papers_and_ends_as_no_bias():
    q, visits = tables(4, (3, 4, 2))
    np.testing.assert_array_equal(
        chosen("FBIASSR", q, 0 * visits)[0], chosen("QBIASSR", q, visits)[0]
    )
    np.testing.assert_array_equal(
        chosen("FBIASSR", q, visits + 10**6)[1], chosen("SR", q, visits)[1]
    )


@pytest.mark.parametrize("selection", ["OBIASSR", "TBIASSR"])
def test_where_no_other_state_knows_anything_it_is_softmax_regression(selection):
    q, visits = tables(5, (3, 4, 2))
    q[np.arange(len(q)) != 13] = 0.0
    np.testing.assert_array_equal(
        chosen(selection, q, visits)[1], chosen("SR", q, visits)[1]
    )
    assert not np.allclose(chosen("QBIASSR", q, visits)[1], chosen("SR", q, visits)[1])


def test_the_papers_bias_is_the_corrected_one_at_a_lower_temperature():
    q, visits = tables(6, (3, 4, 2))
    agent = agent_of("TBIASSR", (3, 4, 2), q, visits)
    agent.change(temperature=1 / (1 + np.mean([1 / 3, 1 / 4, 1 / 2])))
    agent.memory.now.temperature = agent.parameters.temperature
    agent.begin_episode(13)
    np.testing.assert_allclose(
        agent.probabilities, chosen("QBIASSR", q, visits)[1], atol=1e-12
    )
