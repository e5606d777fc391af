"""A method that sees little, two bins an input, beside the one that sees nothing (rlrobot_edu/tools/blind.py)."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.algorithms.true_online_sarsa import update
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.selections.softmax import softmax_regression


@compiled
def near_or_not(m, s):
    """The state whose inputs are in their lowest bins where those of `s` are, and in their second ones elsewhere."""
    seen, stride, rest = 0, m.q.shape[0], s
    for i in range(m.shape.shape[0]):
        stride //= m.shape[i]
        if rest // stride > 0:
            seen += stride
        rest %= stride
    return seen


@compiled
def update_nearby(m, s, a, r, s_next, a_next, terminated):
    """True online SARSA(λ) with two bins an input, the lowest and the rest."""
    return update(
        m, near_or_not(m, s), a, r, near_or_not(m, s_next), a_next, terminated
    )


@compiled
def weigh_nearby(m, s):
    """Softmax regression with two bins an input."""
    softmax_regression(m, near_or_not(m, s))


# TOSL+SR with two bins an input, for lasers: near or not; take it with loop_evasion=False, which looks at states.
COARSE = Method(
    Algorithm("COARSE-TOSL", update_nearby, has_traces=True),
    Selection("SR", weigh_nearby, is_softmax=True),
)
