"""Temperature-corrected biased softmax regression (TBIASSR): QBIASSR at the temperature that was asked for."""

from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.biased import next_input, softmax_with_bias
from rlrobot_edu.learning.jit import compiled_apart
from rlrobot_edu.learning.obiassr import add_others


@compiled_apart
def softmax_biased_at_its_temperature(m, s):
    r"""TBIASSR: softmax over QBIASSR's preferences, divided by how often they count Q(s).

    .. math:: \frac{Q(s) + bias(s)}{1 + c} = Q(s) + \frac{1}{1 + c} \cdot
        \frac{1}{n} \sum_{i=1}^{n} \frac{1}{n_i} \sum_{s'' \in SS(s, x_i), s'' \ne s} Q(s''), \qquad
        c = \frac{1}{n} \sum_{i=1}^{n} \frac{1}{n_i}

    `n_i` is the number of bins of input i, and c is the share of Q(s) in QBIASSR's bias(s). So QBIASSR at the
    temperature T is this at T / (1 + c). What is added to Q(s) here, the sum on the right, is this selection's bias.
    """
    n, share = m.shape.shape[0], 0.0
    for i in range(n):
        share += 1.0 / (m.shape[i] * n)
    m.bias[:] = 0.0
    stride, rest = m.q.shape[0], s
    for i in range(n):
        stride, way, rest = next_input(stride, rest, m.shape[i])
        add_others(m.q, s, s - way, stride, m.shape[i], 1.0 / (m.shape[i] * n * (1.0 + share)), m.bias)
    softmax_with_bias(m, s)


TBIASSR = Selection(name="TBIASSR", weigh=softmax_biased_at_its_temperature, is_softmax=True, is_biased=True)
