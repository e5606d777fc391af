"""The compiled kernels of a sample model, which draw what happens."""

from typing import NamedTuple

import numpy as np

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.models.sample_model import UNSEEN

STAY = UNSEEN.index("stay")
SIBLINGS = UNSEEN.index("siblings")


class Tables(NamedTuple):
    """A SampleModel in types that numba knows, without its task. The outcomes of pair (s, a), number s·A + a, are those
    from offsets[pair] to offsets[pair + 1] − 1.
    """

    shape: np.ndarray  # (inputs,) of int, the bins of each
    n_actions: int
    offsets: np.ndarray  # (pairs + 1,) of int
    s_next: np.ndarray  # (outcomes,) of int
    r: np.ndarray  # (outcomes,)
    terminated: np.ndarray  # (outcomes,) of bool
    cumulative: (
        np.ndarray
    )  # (outcomes,) of int, how often it and those before it of its pair were seen
    starts: np.ndarray  # of int, the states in which episodes began
    rewards: np.ndarray  # all rewards, the lowest first
    unseen: int  # the place of its word in UNSEEN
    episode_steps: (
        int  # after which an episode is cut off, by the task or by a time limit
    )


@compiled
def draw_start(tables, u):
    """The state of a new episode: one of the recorded starts; `u` is uniform in [0, 1)."""
    return tables.starts[int(u * tables.starts.shape[0])]


@compiled
def draw_from(tables, pair, number):
    """An outcome of `pair`, which was seen: the one with this number, if each is counted as often as it was seen.

    Returns (s', r, terminated). number: from 0 to times_seen − 1
    """
    low = tables.offsets[pair]
    high = tables.offsets[pair + 1] - 1
    # Bisection: the first outcome whose cumulative count exceeds the number
    while low < high:
        middle = (low + high) // 2
        if number < tables.cumulative[middle]:
            high = middle
        else:
            low = middle + 1
    return tables.s_next[low], tables.r[low], tables.terminated[low]


@compiled
def times_seen(tables, pair):
    """How often `pair` was tried."""
    offsets = tables.offsets
    if offsets[pair] == offsets[pair + 1]:
        return 0
    return tables.cumulative[offsets[pair + 1] - 1]


@compiled
def draw_from_siblings(tables, s, a, u):
    """An outcome of `a` in the states that share all inputs but one with `s`: (known, s', r, terminated)."""
    shape = tables.shape
    n_actions = tables.n_actions
    number = -1
    # Twice the same way: first to count what there is, then up to the outcome that was drawn
    for attempt in range(2):
        seen = 0
        stride = (tables.offsets.shape[0] - 1) // n_actions
        for i in range(shape.shape[0]):
            stride //= shape[i]
            first = s - (s // stride) % shape[i] * stride
            for k in range(shape[i]):
                pair = (first + k * stride) * n_actions + a
                count = times_seen(tables, pair)
                if attempt == 1 and number < seen + count:
                    s_next, r, terminated = draw_from(tables, pair, number - seen)
                    return True, s_next, r, terminated
                seen += count
        if seen == 0:
            break
        number = int(u * seen)
    return False, s, 0.0, False


@compiled
def draw_outcome(tables, s, a, u, v):
    """What happens after (s, a): (s', r, terminated); `u` and `v` are independent and uniform in [0, 1).

    Of a pair that was never seen: what `unseen` says. The robot stays, with the lowest reward; or an outcome of the
    action in similar states, if there are any; or any state and any reward.
    """
    pair = s * tables.n_actions + a
    seen = times_seen(tables, pair)
    if seen > 0:
        return draw_from(tables, pair, int(u * seen))
    if tables.unseen == STAY:
        return s, tables.rewards[0], False
    if tables.unseen == SIBLINGS:
        known, s_next, r, terminated = draw_from_siblings(tables, s, a, u)
        if known:
            return s_next, r, terminated
    n_states = (tables.offsets.shape[0] - 1) // tables.n_actions
    return int(u * n_states), tables.rewards[int(v * tables.rewards.shape[0])], False


@compiled
def begin(tables, rng):
    """The state of a new episode, drawn from `rng`."""
    return draw_start(tables, rng.random())


@compiled
def outcome(tables, s, a, rng):
    """What happens after (s, a), drawn from `rng`: (s', r, terminated)."""
    return draw_outcome(tables, s, a, rng.random(), rng.random())
