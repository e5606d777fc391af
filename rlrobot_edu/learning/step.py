"""One step of learning, whatever the method: the transition goes in, the next action comes out.

The numbers in `u` are drawn by whoever drives the loop, one uniform number in [0, 1) for each selection.
"""

from rlrobot_edu.learning import methods, q_learning, sarsa, sarsa_lambda, true_online_sarsa
from rlrobot_edu.learning.greedy import epsilon_greedy, epsilon_greedy_least_explored
from rlrobot_edu.learning.jit import compiled
from rlrobot_edu.learning.loop_evasion import forget_loops, watch_for_loops
from rlrobot_edu.learning.qbiassr import biased_softmax_regression
from rlrobot_edu.learning.softmax import softmax_regression
from rlrobot_edu.learning.traces import forget

# numba compiles a module's functions, not its attributes, so the updates get names of their own here
update_q_learning, update_sarsa = q_learning.update, sarsa.update
update_sarsa_lambda, update_true_online_sarsa = sarsa_lambda.update, true_online_sarsa.update

NO_ACTION = -1  # after a terminal state there is nothing to choose


@compiled
def begin_episode(m):
    """Forget the traces and the recent states: what happened before has nothing to do with what comes."""
    forget(m)
    forget_loops(m)


@compiled
def select(m, s, u):
    """Draw an action in state `s`: its probabilities are written to the memory, `u` picks one."""
    selection = m.parameters.selection
    if selection == methods.SR:
        softmax_regression(m, s)
    elif selection == methods.QBIASSR:
        biased_softmax_regression(m, s)
    elif selection == methods.EG:
        epsilon_greedy(m, s, m.parameters.epsilon)
    elif selection == methods.EGLE:
        epsilon_greedy_least_explored(m, s, m.parameters.epsilon)
    elif selection == methods.GREEDY:
        epsilon_greedy(m, s, 0.0)
    else:
        epsilon_greedy(m, s, 1.0)

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
    algorithm = m.parameters.algorithm
    m.visits[s, a] += 1
    if not terminated:
        watch_for_loops(m, s_next, r)

    a_next = NO_ACTION
    if not terminated and algorithm != methods.Q:
        a_next = select(m, s_next, u)

    if algorithm == methods.Q:
        delta = update_q_learning(m, s, a, r, s_next, a_next, terminated)
    elif algorithm == methods.SARSA:
        delta = update_sarsa(m, s, a, r, s_next, a_next, terminated)
    elif algorithm == methods.SL:
        delta = update_sarsa_lambda(m, s, a, r, s_next, a_next, terminated)
    else:
        delta = update_true_online_sarsa(m, s, a, r, s_next, a_next, terminated)

    if not terminated and algorithm == methods.Q:
        a_next = select(m, s_next, u)
    return a_next, delta
