"""SARSA (Rummery & Niranjan 1994): learn the value of the action that will really be taken next."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm


@compiled
def update(m, s, a, r, s_next, a_next, terminated):
    r"""Learn from one transition; returns the TD error. `m` is the agent's memory, see memory.py.

    .. math:: \delta = r + \gamma Q(s', a') - Q(s, a), \qquad Q(s, a) \leftarrow Q(s, a) + \alpha \delta

    Source: paper equations 2 and 4; Sutton & Barto, section 6.4.
    """
    alpha, gamma = m.parameters.alpha, m.parameters.gamma
    q = m.q

    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    q[s, a] += alpha * delta
    return delta


SARSA = Algorithm("SARSA", update, on_policy=True)
