"""One step of learning: the transition goes in, the next action comes out.

A template: it stands here for Q+SR. For another method jit/building.py puts that method's `update`,
`compute_probabilities` and `ON_POLICY` in the place of these.

The numbers `u` are drawn by the caller of the loop, one uniform number in [0, 1) for each selection.
"""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithm import NO_ACTION
from rlrobot_edu.learning.algorithms.q_learning import update
from rlrobot_edu.learning.loop_evasion import watch_for_loops
from rlrobot_edu.learning.selections.softmax import (
    softmax_regression as compute_probabilities,
)

ON_POLICY = False


@compiled
def select(m, s, u):
    """Draw an action in state `s`: its probabilities are written to the memory, `u` picks one."""
    compute_probabilities(m, s)
    probabilities = m.probabilities
    cumulative = 0.0
    possible = 0
    for a in range(probabilities.shape[0]):
        cumulative += probabilities[a]
        if u < cumulative:
            return a
        if probabilities[a] > 0.0:
            possible = a
    return possible  # u reached the sum, which rounding left a hair below 1


@compiled
def learn_step(m, s, a, r, s_next, terminated, u):
    """Learn from (s, a, r, s') and select a'; returns (a', TD error). At an end a' is NO_ACTION.

    SARSA and its relatives learn from the action they will take, so they select it first. Q-learning learns first.
    """
    m.visits[s, a] += 1
    if not terminated:
        watch_for_loops(m, s_next, r)

    a_next = NO_ACTION
    if not terminated and ON_POLICY:
        a_next = select(m, s_next, u)
    delta = update(m, s, a, r, s_next, a_next, terminated)
    if not terminated and not ON_POLICY:
        a_next = select(m, s_next, u)
    return a_next, delta
