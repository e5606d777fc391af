"""A method that sees nothing: where it earns much, the reward does not ask for what was meant."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import Algorithm, Selection
from rlrobot_edu.learning.algorithms.true_online_sarsa import update
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.selections.softmax import softmax_regression


@compiled
def update_anywhere(m, s, a, r, s_next, a_next, terminated):
    """True online SARSA(λ) with one state for all places, number 0."""
    return update(m, 0, a, r, 0, a_next, terminated)


@compiled
def weigh_blind(m, s):
    """Softmax regression in the one state."""
    softmax_regression(m, 0)


# TOSL+SR that sees nothing; take it with loop_evasion=False, because loop evasion looks at states.
BLIND = Method(
    Algorithm("BLIND-TOSL", update_anywhere, has_traces=True),
    Selection("SR", weigh_blind, is_softmax=True),
)
