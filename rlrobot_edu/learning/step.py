"""One step of learning, whatever the method: the transition goes in, the next action comes out.

The numbers in `u` are drawn by whoever drives the loop, one uniform number in [0, 1) for each selection.
"""

from rlrobot_edu.learning.jit import compiled, literal_unroll
from rlrobot_edu.learning.loop_evasion import forget_loops, watch_for_loops
from rlrobot_edu.learning.methods import ALGORITHMS, SELECTIONS
from rlrobot_edu.learning.traces import forget

UPDATES = tuple(algorithm.update for algorithm in ALGORITHMS.values())
WEIGHINGS = tuple(selection.weigh for selection in SELECTIONS.values())

NO_ACTION = -1  # after a terminal state there is nothing to choose


@compiled
def begin_episode(m):
    """Forget the traces and the recent states: what happened before has nothing to do with what comes."""
    forget(m)
    forget_loops(m)


@compiled
def select(m, s, u):
    """Draw an action in state `s`: its probabilities are written to the memory, `u` picks one."""
    number = 0  # of the selections, the agent's own writes its probabilities
    for weigh in literal_unroll(WEIGHINGS):
        if number == m.parameters.selection:
            weigh(m, s)
        number += 1

    n_actions = m.probabilities.shape[0]
    below = 0.0
    for a in range(n_actions):
        below += m.probabilities[a]
        if u < below:
            return a
    return m.probabilities.argmax()  # u reached the sum, which rounding left a hair below 1


@compiled
def learn_step(m, s, a, r, s_next, terminated, u):
    """Learn from (s, a, r, s') and select a'; returns (a', TD error).

    SARSA and its relatives learn from the action they will take, so they select it first. Q-learning learns first.
    """
    on_policy = m.parameters.on_policy
    m.visits[s, a] += 1
    if not terminated:
        watch_for_loops(m, s_next, r)

    a_next = NO_ACTION
    if not terminated and on_policy:
        a_next = select(m, s_next, u)

    delta, number = 0.0, 0  # of the updates, the agent's own learns
    for update in literal_unroll(UPDATES):
        if number == m.parameters.algorithm:
            delta = update(m, s, a, r, s_next, a_next, terminated)
        number += 1

    if not terminated and not on_policy:
        a_next = select(m, s_next, u)
    return a_next, delta
