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
    n_states, n_actions = model.n_states, model.n_actions
    pairs = n_states * n_actions
    pair, count = model.pair, model.count.astype(float)
    goes_on = ~model.terminated
    seen = np.bincount(pair, weights=count, minlength=pairs)
    rewards = np.bincount(pair, weights=count * model.r, minlength=pairs)
    counts = sparse.csr_array((count[goes_on], (pair[goes_on], model.s_next[goes_on])), shape=(pairs, n_states))
    if model.unseen == "siblings":
        pool = sparse.kron(_sibling_matrix(model.shape), sparse.eye_array(n_actions), format="csr")
        pool = sparse.diags_array((seen == 0).astype(float)) @ pool  # only pairs that were never tried ask others
        counts, rewards, seen = counts + pool @ counts, rewards + pool @ rewards, seen + pool @ seen

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
    return Expected(sparse.csr_array(sparse.diags_array(1 / total) @ counts), anywhere, rewards / total)


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


def _sibling_matrix(shape: tuple[int, ...]) -> sparse.csr_array:
    """Array (n_states, n_states): in how many inputs' families two states are together (see `StateSpace.siblings`)."""
    n_states = int(np.prod(shape))
    total = sparse.csr_array((n_states, n_states))
    for i, n_bins in enumerate(shape):
        before, after = int(np.prod(shape[:i])), int(np.prod(shape[i + 1 :]))
        family = sparse.kron(sparse.eye_array(before), np.ones((n_bins, n_bins)))
        total = total + sparse.kron(family, sparse.eye_array(after))
    return sparse.csr_array(total)
