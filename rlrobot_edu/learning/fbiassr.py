"""Fading biased softmax regression (FBIASSR): QBIASSR, but a pair that was tried often needs no advice."""

import math

from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.biased import softmax_with_bias
from rlrobot_edu.learning.jit import compiled_apart
from rlrobot_edu.learning.qbiassr import compute_bias


@compiled_apart
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


FBIASSR = Selection(name="FBIASSR", weigh=softmax_with_fading_bias, is_softmax=True, is_biased=True)
