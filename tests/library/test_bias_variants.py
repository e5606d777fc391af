"""The bias weighted by visits, against NumPy along the axes of Q, and what must hold of it."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import numpy_softmax

import rlrobot_edu as rl
from rlrobot_course.lesson_22.vbiassr import VBIASSR
from rlrobot_edu.learning.size import Size


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


def agent_of(selection, shape, q, visits):
    method = rl.Method("TOSL", selection)
    agent = rl.Agent(Size(shape, q.shape[1]), method, r_max=10)
    agent.q[:], agent.visits[:] = q, visits
    return agent


def tables(seed, shape, n_actions=3, most_visits=30):
    rng = np.random.default_rng(seed)
    size = int(np.prod(shape)), n_actions
    return rng.normal(scale=20, size=size), rng.integers(0, most_visits, size) * (
        rng.random(size) < 0.6
    )


@given(
    st.integers(0, 2**32),
    st.lists(st.integers(1, 5), min_size=1, max_size=4),
    st.integers(1, 6),
)
@settings(max_examples=40, deadline=None)
def test_the_bias_is_what_numpy_says_along_the_axes_of_q_and_softmax_takes_it(
    seed, shape, n_actions
):
    q, visits = tables(seed, shape, n_actions)
    agent, s = agent_of(VBIASSR, tuple(shape), q, visits), seed % len(q)
    agent.begin_episode(s)
    expected = weighed(q, visits, shape, s)
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
        chosen(VBIASSR, q, same)[0], chosen("QBIASSR", q, same)[0]
    )
    assert not chosen(VBIASSR, q, 0 * visits)[0].any()


def test_a_pair_that_was_never_tried_has_no_say_in_the_bias_weighed_by_visits():
    q, visits = tables(2, (3, 4, 2))
    other = np.where(visits > 0, q, 1e6)
    np.testing.assert_array_equal(
        chosen(VBIASSR, q, visits)[0], chosen(VBIASSR, other, visits)[0]
    )
