"""Expected SARSA (van Seijen et al. 2009): learn the value of the next action on average, whichever will be drawn."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm


@compiled
def update(m, s, a, r, s_next, a_next, terminated):
    r"""Learn from one transition; returns the TD error. `m` is the agent's memory, see memory.py.

    .. math:: \delta = r + \gamma \sum_{a'} \pi(a' | s') Q(s', a') - Q(s, a), \qquad
        Q(s, a) \leftarrow Q(s, a) + \alpha \delta

    π are the probabilities with which the next action, `a_next`, has just been selected.
    Source: van Seijen, van Hasselt, Whiteson & Wiering 2009; Sutton & Barto, section 6.6.
    """
    alpha, gamma = m.parameters.alpha, m.parameters.gamma
    q, p = m.q, m.probabilities

    v_next = 0.0
    if not terminated:
        for b in range(q.shape[1]):
            v_next += p[b] * q[s_next, b]
    delta = r + gamma * v_next - q[s, a]
    q[s, a] += alpha * delta
    return delta


EXPECTED_SARSA = Algorithm("ESARSA", update)
