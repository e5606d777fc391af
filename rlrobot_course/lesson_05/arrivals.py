"""What an agent knows each time it arrives in a state, how often it was there before, and what its bias is worth."""

from typing import NamedTuple

import gymnasium
import numpy as np

from rlrobot_edu import Agent, steps
from rlrobot_edu.widgets.kernels import bias_of

GROUPS = np.array([0, 1, 2, 4, 8, 16, 32, 64])  # smallest number of earlier visits in each group
GROUP_LABELS = ["never", "1", "2–3", "4–7", "8–15", "16–31", "32–63", "64 …"]


class Arrivals(NamedTuple):
    """One entry for each of n steps: the state it led to, and what was known about this state then.

    s: array (n,) of int; visits: array (n,) of int, how often an action had been tried in s
    q, bias: arrays (n, n_actions), Q(s) and bias(s)
    """

    s: np.ndarray
    visits: np.ndarray
    q: np.ndarray
    bias: np.ndarray


def watch_arrivals(agent: Agent, env: gymnasium.Env, n_steps: int) -> Arrivals:
    """Let `agent` learn in `env` for `n_steps` steps and note what it knows about each state it comes to."""
    n_actions = agent.q.shape[1]
    seen = Arrivals(*np.zeros((2, n_steps), dtype=np.int64), *np.zeros((2, n_steps, n_actions)))
    for step in steps(agent, env, n_steps):
        s = step.s_next
        seen.s[step.t], seen.visits[step.t], seen.q[step.t] = s, agent.visits[s].sum(), agent.q[s]
        seen.bias[step.t] = bias_of(agent.q, agent.shape, s)
    return seen


def mean_by_visits(visits: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Mean of the `values`, those that are NaN left out, in each group of `visits`, both arrays (n,).

    Returns an array (groups,), NaN for a group without values.
    """
    known = ~np.isnan(values)
    group = np.searchsorted(GROUPS, visits[known], side="right") - 1
    total = np.bincount(group, values[known], minlength=len(GROUPS))
    count = np.bincount(group, minlength=len(GROUPS))
    return np.divide(total, count, out=np.full(len(GROUPS), np.nan), where=count > 0)


def quality(q_best: np.ndarray, s: np.ndarray, x: np.ndarray) -> np.ndarray:
    r"""How good it would be to take the action with the largest `x`: 1 the best there is, 0 as good as a guess.

    .. math:: \frac{Q^*(s, \arg\max_a x(a)) - \bar Q^*(s)}{\max_a Q^*(s, a) - \bar Q^*(s)}

    the bar being the mean over the actions; among several largest, any. NaN where every action is equally good.
    q_best: array (n_states, n_actions), Q*; s: array (n,) of states; x: array (n, n_actions). Returns an array (n,).
    """
    row, largest = q_best[s], x == x.max(axis=1, keepdims=True)
    guess = row.mean(axis=1)
    taken = (row * largest).sum(axis=1) / largest.sum(axis=1)
    room = row.max(axis=1) - guess
    return np.divide(taken - guess, room, out=np.full(len(s), np.nan), where=room > 1e-6)


def share_of_bias(q: np.ndarray, bias: np.ndarray) -> np.ndarray:
    """The gap of the bias as a share of both gaps, that of Q(s) and its own, 0 to 1; NaN where both are 0.

    A gap is that between the actions liked most and least. q, bias: arrays (n, n_actions).
    """
    own, others = np.ptp(q, axis=1), np.ptp(bias, axis=1)
    return np.divide(others, own + others, out=np.full(len(q), np.nan), where=own + others > 1e-9)
