"""Others-biased softmax regression (OBIASSR): QBIASSR, but no state advises itself."""

from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.biased import next_input, softmax_with_bias
from rlrobot_edu.learning.jit import compiled, compiled_apart


@compiled
def add_others(q, s, first, stride, bins, weight, bias):
    """Add to `bias`, array (A,), `weight` times the Q of each state but `s` of a set SS(s, x_i), see `next_input`."""
    for k in range(bins):
        row = first + k * stride
        if row != s:
            for a in range(q.shape[1]):
                bias[a] += weight * q[row, a]


@compiled_apart
def softmax_biased_by_others(m, s):
    r"""OBIASSR: softmax over the normalised Q(s) + bias(s), where

    .. math:: bias(s) = \frac{1}{n} \sum_{i=1}^{n} \operatorname{mean}_{s'' \in SS(s, x_i), s'' \ne s} Q(s'')

    QBIASSR's sets hold `s` itself, which makes Q(s) count more than once: a lower temperature in disguise. Without it
    Q(s) counts once, as in SR. An input of one bin has no others, which say nothing.
    """
    m.bias[:] = 0.0
    n, stride, rest = m.shape.shape[0], m.q.shape[0], s
    for i in range(n):
        stride, way, rest = next_input(stride, rest, m.shape[i])
        add_others(m.q, s, s - way, stride, m.shape[i], 1.0 / (max(m.shape[i] - 1, 1) * n), m.bias)
    softmax_with_bias(m, s)


OBIASSR = Selection(name="OBIASSR", weigh=softmax_biased_by_others, is_softmax=True, is_biased=True)
