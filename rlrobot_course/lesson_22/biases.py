"""Three more biases, each a selection of one's own as VBIASSR is (vbiassr.py): a kernel, and a name for it.

Each changes one thing about QBIASSR. docs/studies/a_better_bias.md says what VBIASSR and FBIASSR gain.
"""

import math

from rlrobot_course.lesson_22.vbiassr import VBIASSR, next_input, softmax_with_bias
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.selections.qbiassr import compute_bias


@compiled
def add_others(q, s, first, stride, bins, weight, bias):
    """Add to `bias`, array (A,), `weight` times the Q of each state but `s` of a set SS(s, x_i), see `next_input`."""
    for k in range(bins):
        row = first + k * stride
        if row != s:
            for a in range(q.shape[1]):
                bias[a] += weight * q[row, a]


@compiled
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
        add_others(
            m.q,
            s,
            s - way,
            stride,
            m.shape[i],
            1.0 / (max(m.shape[i] - 1, 1) * n),
            m.bias,
        )
    softmax_with_bias(m, s)


OBIASSR = Selection(
    name="OBIASSR", weigh=softmax_biased_by_others, is_softmax=True, is_biased=True
)


@compiled
def softmax_with_fading_bias(m, s):
    r"""FBIASSR: softmax over the normalised Q(s) + bias(s), where with N(s, a), the visits of the pair,

    .. math:: bias(s, a) = (1 - \alpha)^{N(s, a)} \cdot \frac{1}{n} \sum_{i=1}^{n}
        \operatorname{mean}_{s'' \in SS(s, x_i)} Q(s'', a)

    After N updates with the learning rate α, Q(s, a) still is, to the part (1 − α)^N, the zero that it began with. The
    bias stands in for that zero, and goes as it goes: for α = 0.1 it has half its weight after 7 visits, a tenth
    after 22. In the end it is SR.
    """
    compute_bias(m.q, m.shape, s, m.bias)
    for a in range(m.q.shape[1]):
        m.bias[a] *= math.pow(1.0 - m.parameters.alpha, float(m.visits[s, a]))
    softmax_with_bias(m, s)


FBIASSR = Selection(
    name="FBIASSR", weigh=softmax_with_fading_bias, is_softmax=True, is_biased=True
)


@compiled
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
        add_others(
            m.q,
            s,
            s - way,
            stride,
            m.shape[i],
            1.0 / (m.shape[i] * n * (1.0 + share)),
            m.bias,
        )
    softmax_with_bias(m, s)


TBIASSR = Selection(
    name="TBIASSR",
    weigh=softmax_biased_at_its_temperature,
    is_softmax=True,
    is_biased=True,
)

BIASES = (VBIASSR, OBIASSR, FBIASSR, TBIASSR)
