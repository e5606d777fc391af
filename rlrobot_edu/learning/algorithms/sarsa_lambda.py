"""SARSA(λ): every pair visited lately learns from the TD error, the more recent the more."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm
from rlrobot_edu.learning.traces import pass_on, remember


@compiled
def update(m, s, a, r, s_next, a_next, terminated):
    r"""Learn from one transition; returns the TD error. `m` is the agent's memory, see memory.py.

    .. math::
        \delta = r + \gamma Q(s', a') - Q(s, a), \qquad e(s, a) \leftarrow 1 \text{ (or } e(s, a) + 1) \\
        Q \leftarrow Q + \alpha \delta e, \qquad e \leftarrow \gamma \lambda e

    Source: paper equations 4, 6 and 7; Singh & Sutton 1996 for replacing traces; Sutton & Barto, section 12.7.
    """
    alpha, gamma, lam = m.parameters.alpha, m.parameters.gamma, m.parameters.lam
    q, e = m.q, m.e

    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]

    remember(m, s)
    e[s, a] = e[s, a] + 1.0 if m.parameters.accumulating else 1.0
    pass_on(m, alpha * delta, gamma * lam)
    return delta


SARSA_LAMBDA = Algorithm("SL", update, on_policy=True, has_traces=True)
