"""Planning on a sample model: the best that can be done in it, computed instead of learned."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy import sparse

from rlrobot_edu.models.sample_model import SampleModel


class Plan(NamedTuple):
    """The solution of a model.

    q: array (n_states, n_actions), Q*; v: array (n_states,), V*; policy: array (n_states,) of int, greedy in Q*
    sweeps: number of sweeps it took
    """

    q: np.ndarray
    v: np.ndarray
    policy: np.ndarray
    sweeps: int


class Expected(NamedTuple):
    """The expectation of every outcome, pairs being numbered s * n_actions + a.

    transitions: sparse array (pairs, n_states), probability of going on in s'; after a terminal outcome nothing goes on
    anywhere: array (pairs,), probability of landing in any state at random
    reward: array (pairs,), expected reward
    """

    transitions: sparse.csr_array
    anywhere: np.ndarray
    reward: np.ndarray


def expected_outcomes(model: SampleModel) -> Expected:
    """Probabilities and mean rewards of a model, what it does after an unseen pair included."""
    return _expectations(model)[0]


def _expectations(model: SampleModel) -> tuple[Expected, np.ndarray]:
    """The same and, array (pairs,), the expected reward of a step after the end: Rmax where an episode ended well."""
    n_states, n_actions = model.n_states, model.n_actions
    pairs = n_states * n_actions
    pair, count = model.pair, model.count.astype(float)
    goes_on = ~model.terminated
    seen = np.bincount(pair, weights=count, minlength=pairs)
    rewards = np.bincount(pair, weights=count * model.r, minlength=pairs)
    after = np.where(model.r > 0, model.r_max, model.r) * model.terminated
    after = np.bincount(pair, weights=count * after, minlength=pairs)
    counts = sparse.csr_array((count[goes_on], (pair[goes_on], model.s_next[goes_on])), shape=(pairs, n_states))
    if model.unseen == "siblings":
        pool = sparse.kron(_sibling_matrix(model.shape), sparse.eye_array(n_actions), format="csr")
        pool = sparse.diags_array((seen == 0).astype(float)) @ pool  # only pairs that were never tried ask others
        counts, rewards, after, seen = (total + pool @ total for total in (counts, rewards, after, seen))

    unseen = np.flatnonzero(seen == 0)
    anywhere = np.zeros(pairs)
    if model.unseen == "stay":
        counts += sparse.csr_array((np.ones(len(unseen)), (unseen, unseen // n_actions)), shape=(pairs, n_states))
        rewards[unseen] = model.rewards[0]
    elif model.unseen == "start":
        starts = np.bincount(model.starts, minlength=n_states) / len(model.starts)
        asks = sparse.csr_array((np.ones(len(unseen)), (unseen, np.zeros(len(unseen), dtype=int))), shape=(pairs, 1))
        counts += asks @ sparse.csr_array(starts[None, :])
        rewards[unseen] = model.rewards[0]
    else:
        anywhere[unseen] = 1.0
        rewards[unseen] = model.rewards.mean()
    total = np.where(seen > 0, seen, 1.0)
    return Expected(sparse.csr_array(sparse.diags_array(1 / total) @ counts), anywhere, rewards / total), after / total


def value_iteration(model: SampleModel, gamma: float = 0.9, tolerance: float = 1e-9) -> Plan:
    r"""Q*, V* and the greedy policy of a sample model.

    .. math:: Q_{k+1}(s, a) = E[r] + \gamma \sum_{s'} T(s, a, s') V_k(s'), \qquad V_k(s) = \max_a Q_k(s, a)

    A pair that was never tried is planned with as the model's `unseen` says, so "uniform" may lean on the unknown.
    Sweeps until no value is further than `tolerance` from its limit. Raises ValueError unless 0 <= gamma < 1.
    Source: paper equation 1; Sutton & Barto, section 4.4.
    """
    if not isinstance(model, SampleModel):
        raise ValueError(f"planning needs a SampleModel, not a {type(model).__name__}")
    if not 0 <= gamma < 1:
        raise ValueError(f"gamma must be in [0, 1), got {gamma!r}")
    expected = expected_outcomes(model)
    v = np.zeros(model.n_states)
    sweeps = 0
    while True:
        sweeps += 1
        q = expected.reward + gamma * (expected.transitions @ v + expected.anywhere * v.mean())
        q = q.reshape(model.n_states, model.n_actions)
        before, v = v, q.max(axis=1)
        # A sweep brings V at least γ times nearer to V*, so what is still missing is at most this:
        if gamma / (1 - gamma) * np.abs(v - before).max() <= tolerance:
            return Plan(q, v, q.argmax(axis=1), sweeps)


def best_average_reward(model: SampleModel, tolerance: float = 1e-6) -> float:
    r"""The largest average reward a step that any policy can reach in a sample model: a ruler for learning curves.

    .. math:: g = \max_\pi \lim_{n \to \infty} \frac{1}{n} E_\pi \Big[ \sum_{t<n} r_t \Big]

    from the recorded starts, to within `tolerance`. A task with episodes is planned over one episode of
    `episode_steps`, its goal counted as in `History.last_episode`.
    Source: Puterman, *Markov Decision Processes*, sections 4.5, 8.5 (relative value iteration) and 9.5.
    """
    if model.episode_steps is not None:
        return _best_episode(model)
    expected = expected_outcomes(model)
    # After a terminal outcome the next episode begins in one of the starts.
    starts = np.bincount(model.starts, minlength=model.n_states) / len(model.starts)
    ends = 1 - expected.transitions.sum(axis=1) - expected.anywhere
    ends[ends < 1e-9] = 0.0
    restarts = sparse.csr_array(ends[:, None]) @ sparse.csr_array(starts[None, :])
    expected = expected._replace(transitions=sparse.csr_array(expected.transitions + restarts))
    stays, component = _end_components(model, expected)
    value = _gains(model, expected, stays, component, tolerance)
    # Which of the components to go to: from below, so that every value on the way can be reached.
    while True:
        before = value
        ahead = expected.transitions @ value + expected.anywhere * value.mean()
        value = np.maximum(value, ahead.reshape(model.n_states, -1).max(axis=1))
        if (value - before).max() <= tolerance / 100:
            return float(starts @ value)


def _best_episode(model: SampleModel) -> float:
    """Largest expected average reward of an episode: one sweep for each step, from the last to the first."""
    expected, after = _expectations(model)
    v = np.zeros(model.n_states)
    for steps_left in range(model.episode_steps):
        q = expected.reward + after * steps_left + expected.transitions @ v + expected.anywhere * v.mean()
        v = q.reshape(model.n_states, -1).max(axis=1)
    return float(v[model.starts].mean() / model.episode_steps)


def _end_components(model: SampleModel, expected: Expected) -> tuple[np.ndarray, np.ndarray]:
    """Sets of states in which an agent can stay for ever and reach each from each (maximal end components).

    Returns arrays (pairs,) of bool, whether a pair keeps inside the set of its state for certain, and (n_states,) of
    int, the number of the set. Within such a set the best average reward is the same from every state.
    """
    n = model.n_states
    row, target = expected.transitions.nonzero()
    owner = np.arange(n * model.n_actions) // model.n_actions
    random = np.flatnonzero(expected.anywhere)
    stays = np.ones(len(owner), dtype=bool)
    while True:
        # "Anywhere" is a place of its own, number n, from which every state can be reached.
        kept, kept_random = stays[row], random[stays[random]]
        a = np.concatenate([owner[row[kept]], owner[kept_random], np.full(n, n)])
        b = np.concatenate([target[kept], np.full(len(kept_random), n), np.arange(n)])
        graph = sparse.csr_array((np.ones(len(a)), (a, b)), shape=(n + 1, n + 1))
        _, component = sparse.csgraph.connected_components(graph, directed=True, connection="strong")
        leaves = np.zeros(len(owner), dtype=bool)
        leaves[row[component[target] != component[owner[row]]]] = True
        leaves[random] = component.min() != component.max()
        if not (stays & leaves).any():
            return stays, component[:n]
        stays &= ~leaves


def _gains(model: SampleModel, expected: Expected, stays: np.ndarray, component: np.ndarray, tolerance) -> np.ndarray:
    """Best average reward of each state's end component, by relative value iteration in all at once, array (n_states,).

    A state outside of all components counts as the worst of them.
    """
    inside = stays.reshape(model.n_states, -1).any(axis=1)
    order = np.flatnonzero(inside)[np.argsort(component[inside], kind="stable")]
    first = np.flatnonzero(np.diff(component[order], prepend=-1))  # of each component, in `order`
    size = np.diff(first, append=len(order))
    penalty = np.where(stays, 0.0, -np.inf)
    v = np.zeros(model.n_states)
    while True:
        q = expected.reward + expected.transitions @ v + expected.anywhere * v.mean() + penalty
        change = (q.reshape(model.n_states, -1).max(axis=1) - v)[order]
        low, high = np.minimum.reduceat(change, first), np.maximum.reduceat(change, first)  # the gain is in between
        if (high - low).max() <= tolerance:
            gain = (low + high) / 2
            value = np.full(model.n_states, gain.min())
            value[order] = np.repeat(gain, size)
            return value
        v[order] += 0.9 * change  # not the whole way: a circle of states would swing for ever
        v[order] -= np.repeat(v[order[first]], size)


def _sibling_matrix(shape: tuple[int, ...]) -> sparse.csr_array:
    """Array (n_states, n_states): in how many inputs' families two states are together (see `StateSpace.siblings`)."""
    n_states = int(np.prod(shape))
    total = sparse.csr_array((n_states, n_states))
    for i, n_bins in enumerate(shape):
        before, after = int(np.prod(shape[:i])), int(np.prod(shape[i + 1 :]))
        family = sparse.kron(sparse.eye_array(before), np.ones((n_bins, n_bins)))
        total = total + sparse.kron(family, sparse.eye_array(after))
    return sparse.csr_array(total)
