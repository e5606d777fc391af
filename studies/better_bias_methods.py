"""Rivals and relatives of the biased selections, for better_bias.py: each is one change, or one other idea.

The rivals: a count bonus, and true online SARSA(λ) with linear features, which shares what it learns among the very
states that the biases share it among. The relatives take VBIASSR apart.
"""

import math

from rlrobot_course.lesson_22.vbiassr import VBIASSR, next_input, softmax_with_bias
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.selections.qbiassr import compute_bias
from rlrobot_edu.learning.selections.softmax import softmax
from rlrobot_edu.learning.traces import remember

COUNT_BONUS = 2.0  # of an action that was never tried, where 100 is Qmax


@compiled
def softmax_with_count_bonus(m, s):
    r"""COUNT: softmax over the normalised Q(s, a), plus :math:`2 / \sqrt{1 + N(s, a)}`."""
    for a in range(m.q.shape[1]):
        m.probabilities[a] = m.q[s, a] * m.parameters.q_scale + COUNT_BONUS / math.sqrt(
            1.0 + m.visits[s, a]
        )
    softmax(m.probabilities, m.now.temperature, m.probabilities)


COUNT = Selection("COUNT", softmax_with_count_bonus, is_softmax=True)


@compiled
def add_alike(q, shape, s, a, amount):
    """Add to q what a change of `amount` in the weights of all features of (s, a) adds to it.

    The features of s: s itself, and for each input i the set SS(s, x_i). So s has them all in common with itself, and
    one of them with each state that differs in one input.
    """
    q[s, a] += amount
    stride, rest = q.shape[0], s
    for i in range(shape.shape[0]):
        stride, way, rest = next_input(stride, rest, shape[i])
        for k in range(shape[i]):
            q[s - way + k * stride, a] += amount


@compiled
def sum_alike(e, shape, s, a):
    """The sum of e over the states, each as often as it has a feature in common with s."""
    total = e[s, a]
    stride, rest = e.shape[0], s
    for i in range(shape.shape[0]):
        stride, way, rest = next_input(stride, rest, shape[i])
        for k in range(shape[i]):
            total += e[s - way + k * stride, a]
    return total


@compiled
def update_linear(m, s, a, r, s_next, a_next, terminated):
    r"""True online SARSA(λ) with linear features (van Seijen et al. 2016), at the step α / (inputs + 1).

    With w the weights and φ the features, Q = wᵀφ. Here m.q holds Q itself, and m.e how often the features of each pair
    are in the trace, :math:`e = \sum_{s, a} e(s, a) \phi(s, a)`: so no table of weights is needed, and the result is
    the same. Where no two states have a feature in common it is TOSL.
    """
    alpha = m.parameters.alpha / (m.shape.shape[0] + 1)
    decay, q, e = m.parameters.gamma * m.parameters.lam, m.q, m.e
    q_old, q_sa = m.now.q_old, q[s, a]
    q_next = 0.0 if terminated else q[s_next, a_next]
    delta = r + m.parameters.gamma * q_next - q_sa
    overlap = sum_alike(e, m.shape, s, a)
    remember(m, s)
    e[s, a] += 1.0 - alpha * overlap
    share, kept = alpha * (delta + q_sa - q_old), 0
    for i in range(m.now.register_size):
        x, largest = m.register[i], 0.0
        for b in range(q.shape[1]):
            if e[x, b] != 0.0:
                add_alike(q, m.shape, x, b, share * e[x, b])
                faded = decay * e[x, b]
                e[x, b] = faded if abs(faded) >= m.parameters.smallest_trace else 0.0
                largest = max(largest, abs(e[x, b]))
        if largest > 0.0:
            m.register[kept] = x
            kept += 1
    m.now.register_size = kept
    add_alike(q, m.shape, s, a, -alpha * (q_sa - q_old))
    m.now.q_old = q_next
    return delta


LINEAR = Algorithm("LINEAR", update_linear, has_traces=True)


@compiled
def pool(m, s, by_visits, with_own):
    """Write into m.bias, array (A,), the mean Q of the similar states, without those that never tried an action.

    by_visits: whether a state counts as often as it tried the action, or once; with_own: whether s is one of them.
    m.probabilities then holds the sums of the weights.
    """
    m.bias[:] = 0.0
    said = m.probabilities
    said[:] = 0.0
    stride, rest = m.q.shape[0], s
    for i in range(m.shape.shape[0]):
        stride, way, rest = next_input(stride, rest, m.shape[i])
        for k in range(m.shape[i]):
            row = s - way + k * stride
            if with_own or row != s:
                for a in range(m.q.shape[1]):
                    n = m.visits[row, a]
                    weight = (n if by_visits else min(n, 1)) / m.shape[i]
                    m.bias[a] += weight * m.q[row, a]
                    said[a] += weight
    for a in range(m.q.shape[1]):
        if said[a] > 0.0:
            m.bias[a] /= said[a]


@compiled
def fade(m, s):
    """Multiply the bias by what is left in Q(s, a) of the zero that it began with, (1 − α)^N(s, a)."""
    for a in range(m.q.shape[1]):
        m.bias[a] *= math.pow(1.0 - m.parameters.alpha, float(m.visits[s, a]))


@compiled
def without_zeros(m, s):
    """NZBIASSR: QBIASSR without the zeros of pairs that were never tried; who tried an action counts once."""
    pool(m, s, False, True)
    softmax_with_bias(m, s)


@compiled
def without_own(m, s):
    """VOBIASSR: VBIASSR of the other states alone."""
    pool(m, s, True, False)
    softmax_with_bias(m, s)


@compiled
def halved(m, s):
    """VHBIASSR: (Q(s) + VBIASSR's bias) / 2, so VBIASSR at twice the temperature."""
    pool(m, s, True, True)
    for a in range(m.q.shape[1]):
        m.bias[a] = (m.bias[a] - m.q[s, a]) / 2
    softmax_with_bias(m, s)


@compiled
def fading(m, s):
    """VFBIASSR: VBIASSR of the other states alone, which fades with the visits as FBIASSR does."""
    pool(m, s, True, False)
    fade(m, s)
    softmax_with_bias(m, s)


@compiled
def zeros_fading(m, s):
    """FOBIASSR: QBIASSR, zeros and all, which fades; for comparison with VFBIASSR."""
    compute_bias(m.q, m.shape, s, m.bias)
    fade(m, s)
    softmax_with_bias(m, s)


@compiled
def shrunk(m, s):
    r"""EBIASSR: each value shrunk to what the others say, by as much as they agree with one another.

    .. math:: (1 - w) Q(s, a) + w \cdot prior(s, a), \qquad w = \frac{1}{1 + N(s, a) D(s, a)}, \qquad
        D = \frac{V}{V + prior^2}

    The prior is VBIASSR's mean of the other states, and V their variance about it, by the same weights. Where they
    agree, D is near 0, and the prior keeps its say; where they do not, it loses it with the first visits. Where nobody
    has tried the action, w is 0.
    """
    pool(m, s, True, False)
    for a in range(m.q.shape[1]):
        said, prior, variance = m.probabilities[a], m.bias[a], 0.0
        stride, rest = m.q.shape[0], s
        for i in range(m.shape.shape[0]):
            stride, way, rest = next_input(stride, rest, m.shape[i])
            for k in range(m.shape[i]):
                row = s - way + k * stride
                if row != s:
                    variance += (
                        m.visits[row, a] / m.shape[i] * (m.q[row, a] - prior) ** 2
                    )
        m.bias[a] = 0.0
        if said > 0.0:
            variance /= said
            size = variance + prior**2
            disagreement = variance / size if size > 0.0 else 0.0
            m.bias[a] = (prior - m.q[s, a]) / (1.0 + m.visits[s, a] * disagreement)
    softmax_with_bias(m, s)


RELATIVES = {
    name: Selection(name, weigh, is_softmax=True, is_biased=True)
    for name, weigh in {
        "NZBIASSR": without_zeros, "VOBIASSR": without_own, "VHBIASSR": halved, "VFBIASSR": fading,
        "FBIASSR": zeros_fading, "EBIASSR": shrunk,
    }.items()
}  # fmt: skip

OWN = {**RELATIVES, "COUNT": COUNT, "VBIASSR": VBIASSR}
