"""True online SARSA(λ), TOSL (van Seijen & Sutton 2014): equal, at every step, to the forward view of λ."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm
from rlrobot_edu.learning.traces import pass_on, remember


@compiled
def update(m, s, a, r, s_next, a_next, terminated):
    r"""Learn from one transition; returns the TD error. `m` is the agent's memory, see memory.py.

    .. math::
        \delta = r + \gamma Q(s', a') - Q(s, a), \qquad e(s, a) \leftarrow (1 - \alpha) e(s, a) + 1 \\
        Q \leftarrow Q + \alpha (\delta + Q(s, a) - Q_{old}) e, \qquad
        Q(s, a) \leftarrow Q(s, a) - \alpha (Q(s, a) - Q_{old}) \\
        Q_{old} \leftarrow Q(s', a'), \qquad e \leftarrow \gamma \lambda e

    Every Q on a right-hand side but the one that is added to is the Q before this step.
    Source: van Seijen & Sutton 2014; Sutton & Barto, section 12.7 (dutch traces: section 12.5).
    """
    alpha, gamma, lam = m.parameters.alpha, m.parameters.gamma, m.parameters.lam
    q, e, q_old = m.q, m.e, m.now.q_old

    q_sa = q[s, a]
    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa

    remember(m, s)
    e[s, a] = (1.0 - alpha) * e[s, a] + 1.0
    pass_on(m, alpha * (delta + q_sa - q_old), gamma * lam)
    q[s, a] -= alpha * (q_sa - q_old)
    m.now.q_old = q_next
    return delta


TRUE_ONLINE_SARSA = Algorithm("TOSL", update, has_traces=True)
