"""Two methods that see nothing, and little: where they earn much, the reward does not ask for what was meant."""

from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.jit import compiled
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.softmax import softmax_regression
from rlrobot_edu.learning.true_online_sarsa import update


@compiled
def update_anywhere(m, s, a, r, s_next, a_next, terminated):
    """True online SARSA(λ) with one state for all places, number 0."""
    return update(m, 0, a, r, 0, a_next, terminated)


@compiled
def weigh_anywhere(m, s):
    """Softmax regression in the one state."""
    softmax_regression(m, 0)


# TOSL+SR of who sees nothing; take it with loop_evasion=False, which looks at states.
seeing_nothing = Selection("SR", weigh_anywhere, is_softmax=True)
BLIND = Method(Algorithm("BLIND-TOSL", update_anywhere, has_traces=True), seeing_nothing)


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
    return update(m, near_or_not(m, s), a, r, near_or_not(m, s_next), a_next, terminated)


@compiled
def weigh_nearby(m, s):
    """Softmax regression with two bins an input."""
    softmax_regression(m, near_or_not(m, s))


# TOSL+SR with two bins an input, for lasers: near or not; it too without loop evasion.
COARSE = Method(
    Algorithm("COARSE-TOSL", update_nearby, has_traces=True), Selection("SR", weigh_nearby, is_softmax=True)
)
