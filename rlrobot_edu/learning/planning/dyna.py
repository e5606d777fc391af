"""Dyna-Q (Sutton 1990): between two real steps, learn from some that were met before, as if they happened again."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import NO_ACTION, Planner
from rlrobot_edu.learning.algorithms import q_learning


@compiled
def draw_outcome(x, pair, number):
    """The place in `x` of an outcome of `pair`: the one with this number, if each is counted as often as it was met.

    The pair was tried; number: from 0 to x.tries[pair] − 1
    """
    i = x.last_of[pair]
    while number >= x.times[i]:
        number -= x.times[i]
        i = x.same_pair[i]
    return i


@compiled
def plan(m, x, s, a, n, rng):
    r"""Imagine `n` steps: draw a tried pair uniformly, then one of its outcomes (s', r) by how often it was met.

    .. math:: Q(s, a) \leftarrow Q(s, a) + \alpha [r + \gamma \max_{a'} Q(s', a') - Q(s, a)]

    Each learns as Q-learning does, whatever the agent's algorithm is: where an imagined step leads to nobody acts, so
    there is no a' to learn from. The real step's pair (s, a) is not asked for.
    `m` is the agent's memory, see memory.py; `x` its experience, see experience.py: at least one pair has been tried.
    Source: Sutton 1990; Sutton & Barto, section 8.2 (Tabular Dyna-Q).
    """
    n_actions = m.q.shape[1]
    for _ in range(n):
        pair = x.tried[int(rng.random() * x.now.pairs)]
        i = draw_outcome(x, pair, int(rng.random() * x.tries[pair]))
        q_learning.update(
            m,
            pair // n_actions,
            pair % n_actions,
            x.r[i],
            x.s_next[i],
            NO_ACTION,
            x.terminated[i],
        )


DYNA = Planner(name="dyna", plan=plan)
