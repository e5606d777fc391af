"""Q-biased softmax regression (QBIASSR): similar states have a say in the choice of an action."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Selection
from rlrobot_edu.learning.selections.softmax import softmax


@compiled
def compute_bias(q, shape, s, bias):
    r"""Write into `bias`, array (A,), what the states that share all inputs but one with `s` think of each action.

    .. math:: bias(s) = \frac{1}{n} \sum_{i=1}^{n} \operatorname{mean}_{s'' \in SS(s, x_i)} Q(s'')

    SS(s, x_i) are the states that differ from s at most in input i. With q seen as an array of n + 1 axes (the bins of
    input 1, …, the bins of input n, the actions), each mean runs along one axis: these states are one stride apart, and
    no table of sets is needed. `shape`: array (n,), bins of each input. Source: paper algorithm 2.
    """
    bias[:] = 0.0
    stride = q.shape[0]
    rest = s
    for i in range(shape.shape[0]):
        stride //= shape[i]
        bin_of_s = rest // stride
        first = s - bin_of_s * stride  # the state of SS whose input i is in bin 0
        rest %= stride
        weight = 1.0 / (shape[i] * shape.shape[0])
        for k in range(shape[i]):
            row = first + k * stride
            for a in range(q.shape[1]):
                bias[a] += weight * q[row, a]


@compiled
def biased_softmax_regression(m, s):
    r"""QBIASSR: softmax over the normalised :math:`(Q(s) + bias(s)) \cdot 100 / Q_{max}`.

    `m` is the agent's memory, see memory.py. Source: paper equations 9 to 11 and algorithm 2.
    """
    q = m.q
    bias = m.bias
    p = m.probabilities
    compute_bias(q, m.shape, s, bias)
    for a in range(q.shape[1]):
        p[a] = (q[s, a] + bias[a]) * m.parameters.q_scale
    softmax(p, m.now.temperature, p)  # in place


QBIASSR = Selection(
    name="QBIASSR",
    compute_probabilities=biased_softmax_regression,
    is_softmax=True,
    is_biased=True,
)
