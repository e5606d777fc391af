"""Q-learning (Watkins 1989): learn the value of acting greedily from the next state on."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm


@compiled
def update(m, s, a, r, s_next, a_next, terminated):
    r"""Learn from one transition; returns the TD error. `m` is the agent's memory, see memory.py.

    .. math:: \delta = r + \gamma \max_{a'} Q(s', a') - Q(s, a), \qquad Q(s, a) \leftarrow Q(s, a) + \alpha \delta

    Source: paper equations 2 and 3, algorithm 1; Sutton & Barto, section 6.5. `a_next` is not used: off-policy.
    """
    alpha, gamma = m.parameters.alpha, m.parameters.gamma
    q = m.q

    v_next = 0.0 if terminated else q[s_next].max()
    delta = r + gamma * v_next - q[s, a]
    q[s, a] += alpha * delta
    return delta


Q_LEARNING = Algorithm("Q", update, on_policy=False)
