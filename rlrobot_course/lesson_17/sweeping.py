"""Prioritized sweeping (Moore & Atkeson 1993): news of a changed value goes back to the pairs that lead there.

A planner of one's own: a name, a kernel, and what it notes down between two steps.
"""

from typing import NamedTuple

import numpy as np

from rlrobot_course.lesson_17.heap import pop, put
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Planner

# A pair whose value is wrong by no more than this share of Qmax waits. Softmax sees Q in hundredths of Qmax, so at the
# temperature 1 such an error changes the ratio of two probabilities by 1 % at the most.
SMALLEST = 1e-4


class Notes(NamedTuple):
    """What sweeping keeps; S states, P pairs.

    priority: array (P,), by how much the value of each pair may be wrong
    told: array (S,), V(s) as it was when the pairs that lead to s were last told of it
    heap, place, waiting: arrays (P,), (P,) and (1,) of int, the pairs that wait for their turn, see heap.py
    """

    priority: np.ndarray
    told: np.ndarray
    heap: np.ndarray
    place: np.ndarray
    waiting: np.ndarray


def new_notes(n_states: int, n_actions: int) -> Notes:
    """The notes of who has met nothing yet."""
    pairs = n_states * n_actions
    heap, place, waiting = (
        np.zeros(pairs, np.int64),
        np.full(pairs, -1),
        np.zeros(1, np.int64),
    )
    return Notes(np.zeros(pairs), np.zeros(n_states), heap, place, waiting)


@compiled
def expected_target(m, x, pair):
    r"""What `pair` is worth by all that was met after it, each outcome counted as often as it was met.

    .. math:: \sum_{s', r} \hat p(s', r | s, a) [r + \gamma \max_{a'} Q(s', a')]
    """
    total, i = 0.0, x.last_of[pair]
    while i >= 0:
        v_next = 0.0 if x.terminated[i] else m.q[x.s_next[i]].max()
        total += x.times[i] / x.tries[pair] * (x.r[i] + m.parameters.gamma * v_next)
        i = x.same_pair[i]
    return total


@compiled
def set_priority(m, x, pair, priority):
    """A pair waits in the heap once its priority is above `SMALLEST`."""
    x.notes.priority[pair] = priority
    if priority > SMALLEST * 100.0 / m.parameters.q_scale or x.notes.place[pair] >= 0:
        put(x.notes, pair)


@compiled
def tell(m, x, s):
    r"""Tell the pairs that led to `s` by how much V(s) = max Q(s, ·) has changed since they were told last.

    The priority of each rises by :math:`\gamma \hat p(s | pair) |V(s) - V_{told}(s)|`, so it is never less than the
    error that such changes have made.
    """
    v = m.q[s].max()
    change = abs(v - x.notes.told[s])
    if change == 0.0:
        return
    x.notes.told[s] = v
    i = x.last_into[s]
    while i >= 0:
        if not x.terminated[i]:
            pair = x.pair[i]
            rise = m.parameters.gamma * x.times[i] / x.tries[pair] * change
            set_priority(m, x, pair, x.notes.priority[pair] + rise)
        i = x.same_next[i]


@compiled
def plan(m, x, s, a, n, rng):
    r"""Set the `n` pairs of highest priority, one after the other, to what they are worth by all that was met.

    .. math:: Q(s, a) \leftarrow \sum_{s', r} \hat p(s', r | s, a) [r + \gamma \max_{a'} Q(s', a')]

    First the real step is told on: its pair's priority is its error, and V(s) may have changed. The targets are greedy
    as Q-learning's are, whatever the agent's algorithm is; alpha has no part, and nothing is drawn from `rng`. What
    traces have changed in other states is told on when next a pair of these changes.
    Source: Moore & Atkeson 1993; Sutton & Barto, section 8.4, with the full backups of their section 8.5.
    """
    n_actions = m.q.shape[1]
    pair = s * n_actions + a
    tell(m, x, s)
    set_priority(m, x, pair, abs(expected_target(m, x, pair) - m.q[s, a]))
    for _ in range(n):
        if x.notes.waiting[0] == 0:
            return
        pair = pop(x.notes)
        x.notes.priority[pair] = 0.0
        m.q[pair // n_actions, pair % n_actions] = expected_target(m, x, pair)
        tell(m, x, pair // n_actions)


SWEEPING = Planner(name="sweeping", plan=plan, new_notes=new_notes)
