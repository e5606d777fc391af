"""ε-greedy towards the least explored action (EGLE): to explore is to try what was tried least."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.selections.greedy import add_share


@compiled
def epsilon_greedy_least_explored(m, s):
    """The action that was tried least often in `s`, with probability ε; else the best one.

    `m` is the agent's memory, see memory.py. Source: our own variant of ε-greedy; the paper does not have it.
    """
    epsilon = m.parameters.epsilon
    m.probabilities[:] = 0.0
    add_share(m.probabilities, m.visits[s], m.visits[s].min(), epsilon)
    add_share(m.probabilities, m.q[s], m.q[s].max(), 1.0 - epsilon)


EGLE = Selection(name="EGLE", compute_probabilities=epsilon_greedy_least_explored)
