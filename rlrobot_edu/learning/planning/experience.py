"""What an agent has met while acting, counted: the model of the world from which a planner imagines steps."""

from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.memory import new_record

# How many different outcomes were met, and how many pairs were tried
NOW = np.dtype([("outcomes", "i8"), ("pairs", "i8")])


class Experience(NamedTuple):
    """The outcomes that an agent has met; S states, A actions, P = S·A pairs, the pair (s, a) being number s·A + a.

    It grows with what was met, never with S². Two lists run through the outcomes, the latest first: those of the same
    pair, and those that lead to the same state; −1 ends a list.

    pair, s_next, r, terminated, times: arrays (C,), an outcome of a pair and how often it was met; C is
        the capacity
    same_pair, same_next: arrays (C,) of int, the next older outcome of the same pair, and into the same state
    last_of, last_into: arrays (P,) and (S,) of int, the latest outcome of each pair, and into each state
    tries: array (P,) of int, how often each pair was tried; tried: array (P,) of int, the pairs tried, in their order
    notes: named tuple of arrays, what the planner keeps besides, see `Planner`
    now: record of the dtype above
    """

    pair: np.ndarray
    s_next: np.ndarray
    r: np.ndarray
    terminated: np.ndarray
    times: np.ndarray
    same_pair: np.ndarray
    same_next: np.ndarray
    last_of: np.ndarray
    last_into: np.ndarray
    tries: np.ndarray
    tried: np.ndarray
    notes: tuple[Any, ...]
    now: np.record


OUTCOME = Experience._fields[:7]  # the arrays with one entry for each outcome
MOST_OUTCOMES = 2**22  # 206 MB: each takes 49 bytes


def new_experience(n_states: int, n_actions: int, planner: Planner) -> Experience:
    """The experience of an agent that has met nothing yet and plans like this."""
    pairs = n_states * n_actions
    ints = np.zeros(0, dtype=np.int64)
    notes: tuple[Any, ...] = ()
    if planner.new_notes is not None:
        notes = planner.new_notes(n_states, n_actions)
    return Experience(
        pair=ints,
        s_next=ints,
        r=np.zeros(0),
        terminated=np.zeros(0, dtype=np.bool_),
        times=ints,
        same_pair=ints,
        same_next=ints,
        last_of=np.full(pairs, -1),
        last_into=np.full(n_states, -1),
        tries=np.zeros(pairs, dtype=np.int64),
        tried=np.zeros(pairs, dtype=np.int64),
        notes=notes,
        now=new_record(NOW),
    )


def with_room(x: Experience, n: int) -> Experience:
    """The same experience with room for `n` outcomes more: itself, or a larger one to use in its place.

    It doubles its room, as far as MOST_OUTCOMES allows. Raises ValueError for too many.
    """
    size = int(x.now.outcomes)
    room = len(x.pair)
    if size + n <= room:
        return x
    if size + n > MOST_OUTCOMES:
        raise ValueError(
            f"a planner keeps at most {MOST_OUTCOMES:,} outcomes; plan in a smaller world"
        )
    more = min(max(2 * room, size + n), MOST_OUTCOMES) - size
    longer = {name: np.pad(getattr(x, name)[:size], (0, more)) for name in OUTCOME}
    return Experience(**{**x._asdict(), **longer})


@compiled
def count_outcome(x, pair, s_next, r, terminated):
    """Count what happened after `pair`. There must be room for one outcome more.

    The outcomes of the pair are gone through one by one: quick while few differ.
    """
    if x.tries[pair] == 0:
        x.tried[x.now.pairs] = pair
        x.now.pairs += 1
    x.tries[pair] += 1
    i = x.last_of[pair]
    while i >= 0 and not (
        x.s_next[i] == s_next and x.r[i] == r and x.terminated[i] == terminated
    ):
        i = x.same_pair[i]
    if i < 0:  # it never happened before
        i = x.now.outcomes
        x.now.outcomes = i + 1
        x.pair[i] = pair
        x.s_next[i] = s_next
        x.r[i] = r
        x.terminated[i] = terminated
        x.times[i] = 0
        x.same_pair[i] = x.last_of[pair]
        x.same_next[i] = x.last_into[s_next]
        x.last_of[pair] = i
        x.last_into[s_next] = i
    x.times[i] += 1
