"""Selections that look at the best action only: ε-greedy (EG), and its two ends, GREEDY and RANDOM.

In each kernel `m` is the agent's memory, see memory.py.
Source: paper section 3 (ε-greedy); Sutton & Barto, section 2.2.
"""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection


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
    p, values = m.probabilities, m.q[s]
    p[:] = epsilon / p.shape[0]
    add_share(p, values, values.max(), 1.0 - epsilon)


@compiled
def best_or_any(m, s):
    """EG: mostly the best action, with probability ε any."""
    epsilon_greedy(m, s, m.parameters.epsilon)


@compiled
def best(m, s):
    """GREEDY: the best action."""
    epsilon_greedy(m, s, 0.0)


@compiled
def any_action(m, s):
    """RANDOM: all actions alike."""
    epsilon_greedy(m, s, 1.0)


EG = Selection(name="EG", compute_probabilities=best_or_any)
GREEDY = Selection(name="GREEDY", compute_probabilities=best)
RANDOM = Selection(name="RANDOM", compute_probabilities=any_action)
