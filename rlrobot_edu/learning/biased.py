"""What the biased selections beside the paper's share: the walk through the sets of similar states, and the softmax."""

from rlrobot_edu.learning.jit import compiled
from rlrobot_edu.learning.softmax import softmax


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
