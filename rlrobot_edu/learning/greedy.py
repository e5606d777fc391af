"""Selections that look at the best action only: GREEDY, ε-greedy (EG) and its least-explored variant (EGLE)."""

from rlrobot_edu.learning.jit import compiled


@compiled
def add_share(p, values, best, share):
    """Add `share` of probability to `p`, split evenly among the actions whose value is `best`: ties are no accident."""
    ties = 0
    for a in range(values.shape[0]):
        ties += values[a] == best
    for a in range(values.shape[0]):
        if values[a] == best:
            p[a] += share / ties


@compiled
def epsilon_greedy(m, s, epsilon):
    """With probability `epsilon` any action, else the best one. GREEDY is ε = 0, RANDOM is ε = 1."""
    m.probabilities[:] = epsilon / m.q.shape[1]
    add_share(m.probabilities, m.q[s], m.q[s].max(), 1.0 - epsilon)


@compiled
def epsilon_greedy_least_explored(m, s, epsilon):
    """With probability `epsilon` the action that was tried least often in `s`, else the best one."""
    m.probabilities[:] = 0.0
    add_share(m.probabilities, m.visits[s], m.visits[s].min(), epsilon)
    add_share(m.probabilities, m.q[s], m.q[s].max(), 1.0 - epsilon)
