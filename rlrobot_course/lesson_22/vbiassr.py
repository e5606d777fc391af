"""Visit-weighed biased softmax regression (VBIASSR): QBIASSR, but who has tried an action more has more say in it."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.selections.softmax import softmax


@compiled
def next_input(stride, rest, bins):
    """One step of the walk through the sets SS(s, x_i), from input to input, which begins with (n_states, s, bins[0]).

    As in `qbiassr.compute_bias`, the members of a set are one stride apart. Returns this stride, how far `s` is from
    its sibling whose input i is in bin 0, and the rest of the state's number, for the inputs to come.
    """
    stride //= bins
    return stride, rest // stride * stride, rest % stride


@compiled
def softmax_with_bias(m, s):
    r"""Softmax over the normalised :math:`(Q(s) + bias(s)) \cdot 100 / Q_{max}` (paper equations 9 and 10)."""
    for a in range(m.q.shape[1]):
        m.probabilities[a] = (m.q[s, a] + m.bias[a]) * m.parameters.q_scale
    softmax(m.probabilities, m.now.temperature, m.probabilities)


@compiled
def softmax_biased_by_visits(m, s):
    r"""VBIASSR: softmax over the normalised Q(s) + bias(s), where with N(s'', a), the visits of a pair,

    .. math:: bias(s, a) = \frac{\sum_i \frac{1}{n_i} \sum_{s'' \in SS(s, x_i)} N(s'', a) Q(s'', a)}
        {\sum_i \frac{1}{n_i} \sum_{s'' \in SS(s, x_i)} N(s'', a)}

    and 0 for an action that none of them has tried. `n_i` is the number of bins of input i. QBIASSR takes the zeros of
    pairs that were never tried for values; here those have no say. Where all have been tried as often, it is QBIASSR.
    """
    m.bias[:] = 0.0
    said = m.probabilities  # the sum below the line; softmax writes over it
    said[:] = 0.0
    stride, rest = m.q.shape[0], s
    for i in range(m.shape.shape[0]):
        stride, way, rest = next_input(stride, rest, m.shape[i])
        for k in range(m.shape[i]):
            row = s - way + k * stride
            for a in range(m.q.shape[1]):
                weight = m.visits[row, a] / m.shape[i]
                m.bias[a] += weight * m.q[row, a]
                said[a] += weight
    for a in range(m.q.shape[1]):
        if said[a] > 0.0:
            m.bias[a] /= said[a]
    softmax_with_bias(m, s)


VBIASSR = Selection(
    name="VBIASSR",
    compute_probabilities=softmax_biased_by_visits,
    is_softmax=True,
    is_biased=True,
)
