"""Softmax regression (SR): better actions are more probable, and the temperature says how much."""

import math

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection


@compiled
def softmax(x, temperature, p):
    r"""Write into `p`, array (A,), the probability of each action given its preference `x`, array (A,).

    .. math:: P(a) = \frac{e^{x(a) / T}}{\sum_i e^{x(a_i) / T}}

    The largest x is subtracted first, which changes no probability and lets no exponential overflow. `p` may be `x`.
    Source: paper equation 5; Sutton & Barto, equation 2.11, without a temperature.
    """
    x_max, total = x[0], 0.0
    for a in range(x.shape[0]):
        x_max = max(x_max, x[a])
    for a in range(x.shape[0]):
        p[a] = math.exp((x[a] - x_max) / temperature)
        total += p[a]
    for a in range(x.shape[0]):
        p[a] /= total


@compiled
def softmax_regression(m, s):
    r"""SR: softmax over the normalised values :math:`Q(s) \cdot 100 / Q_{max}`.

    `m` is the agent's memory, see memory.py. Source: paper equations 5, 10 and 11.
    """
    q, p = m.q, m.probabilities
    for a in range(q.shape[1]):
        p[a] = q[s, a] * m.parameters.q_scale
    softmax(p, m.now.temperature, p)


SR = Selection(name="SR", compute_probabilities=softmax_regression, is_softmax=True)
