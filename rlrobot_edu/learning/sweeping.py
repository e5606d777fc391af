"""Prioritized sweeping (Moore & Atkeson 1993): news of a changed value goes back to the pairs that lead there."""

from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.heap import pop, put
from rlrobot_edu.learning.jit import compiled

# A pair whose value is wrong by no more than this share of Qmax waits. Softmax sees Q in hundredths of Qmax, so at the
# temperature 1 such an error changes the ratio of two probabilities by 1 % at the most.
SMALLEST = 1e-4


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
def set_urgency(m, x, pair, urgency):
    """A pair waits in the heap once its urgency is above `SMALLEST`."""
    x.urgency[pair] = urgency
    if urgency > SMALLEST * 100.0 / m.parameters.q_scale or x.place[pair] >= 0:
        put(x, pair)


@compiled
def tell(m, x, s):
    r"""Tell the pairs that led to `s` by how much V(s) = max Q(s, ·) has changed since they were told last.

    The urgency of each rises by :math:`\gamma \hat p(s | pair) |V(s) - V_{told}(s)|`, so it is never less than the
    error that such changes have made.
    """
    v = m.q[s].max()
    change = abs(v - x.told[s])
    if change == 0.0:
        return
    x.told[s] = v
    i = x.last_into[s]
    while i >= 0:
        if not x.terminated[i]:
            pair = x.pair[i]
            rise = m.parameters.gamma * x.times[i] / x.tries[pair] * change
            set_urgency(m, x, pair, x.urgency[pair] + rise)
        i = x.same_next[i]


@compiled
def plan(m, x, s, a, n, rng):
    r"""Set the `n` most urgent pairs, one after the other, to what they are worth by all that was met after them.

    .. math:: Q(s, a) \leftarrow \sum_{s', r} \hat p(s', r | s, a) [r + \gamma \max_{a'} Q(s', a')]

    First the real step is told on: its pair's urgency is its error, and V(s) may have changed. The targets are greedy
    as Q-learning's are, whatever the agent's algorithm is; alpha has no part, and nothing is drawn from `rng`. What
    traces have changed in other states is told on when next a pair of these changes.
    Source: Moore & Atkeson 1993; Sutton & Barto, section 8.4, with the full backups of their section 8.5.
    """
    n_actions = m.q.shape[1]
    pair = s * n_actions + a
    tell(m, x, s)
    set_urgency(m, x, pair, abs(expected_target(m, x, pair) - m.q[s, a]))
    for _ in range(n):
        if x.now.urgent == 0:
            return
        pair = pop(x)
        x.urgency[pair] = 0.0
        m.q[pair // n_actions, pair % n_actions] = expected_target(m, x, pair)
        tell(m, x, pair // n_actions)


SWEEPING = Planner(name="sweeping", plan=plan)
