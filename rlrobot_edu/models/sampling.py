"""The compiled kernels of a sample model, which draw what happens."""

from typing import Any, NamedTuple

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.models.sample_model import UNSEEN

STAY, SIBLINGS = UNSEEN.index("stay"), UNSEEN.index("siblings")


class Tables(NamedTuple):
    """A SampleModel in types that numba knows, without its task.

    shape: array (inputs,) of int; unseen: the place of its word in UNSEEN
    episode_steps: steps after which an episode is cut off, by the task or by a time limit
    """

    shape: Any
    n_actions: int
    offsets: Any
    s_next: Any
    r: Any
    terminated: Any
    cumulative: Any
    starts: Any
    rewards: Any
    unseen: int
    episode_steps: int


@compiled
def draw_start(tables, u):
    """The state of a new episode: one of the recorded starts; `u` is uniform in [0, 1)."""
    return tables.starts[int(u * tables.starts.shape[0])]


@compiled
def draw_from(tables, pair, number):
    """The outcome of `pair` with this number, counting each as often as it was seen: (s', r, terminated)."""
    offsets, cumulative = tables.offsets, tables.cumulative
    low, high = offsets[pair], offsets[pair + 1] - 1
    while (
        low < high
    ):  # bisection: the first outcome whose cumulative count exceeds the number
        middle = (low + high) // 2
        if number < cumulative[middle]:
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
    shape, n_actions = tables.shape, tables.n_actions
    number = -1
    for attempt in range(
        2
    ):  # first count what there is, then walk to the outcome drawn
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
    """What happens after (s, a): (s', r, terminated); `u` and `v` are independent and uniform in [0, 1)."""
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
