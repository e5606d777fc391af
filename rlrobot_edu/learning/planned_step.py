"""One step of an agent that plans: the step as it is without, and then some that are only imagined."""

from rlrobot_edu.learning.experience import meet
from rlrobot_edu.learning.jit import borrowed, compiled, literal_unroll
from rlrobot_edu.learning.methods import PLANNERS
from rlrobot_edu.learning.step import learn_step, select

PLANS = tuple(planner.plan for planner in PLANNERS.values())


@compiled
def plan(m, x, s, a, r, s_next, a_next, terminated, rng):
    """Keep in mind what happened after (s, a), and imagine as many steps as the agent's parameters say.

    True online SARSA(λ) corrects by what its own last update changed in Q(s', a'), so its Q_old goes along with what
    planning changes there.
    """
    before = 0.0 if terminated else m.q[s_next, a_next]
    meet(x, s * m.q.shape[1] + a, s_next, r, terminated)
    number = 0  # of the planners, the agent's own imagines
    for imagine in literal_unroll(PLANS):
        if number == m.parameters.planner:
            imagine(m, x, s, a, m.parameters.planning_steps, rng)
        number += 1
    if not terminated:
        m.now.q_old += m.q[s_next, a_next] - before


@compiled
def planned_step(m, x, s, a, r, s_next, terminated, u, rng):
    """`learn_step` with the planning between its update and what Q-learning selects: (a', TD error).

    Q-learning selects after it has learned: so it does again, with the same number, once planning has changed Q.
    """
    m, x = borrowed(m), borrowed(x)
    a_next, delta = learn_step(m, s, a, r, s_next, terminated, u)
    plan(m, x, s, a, r, s_next, a_next, terminated, rng)
    if not terminated and not m.parameters.on_policy:
        a_next = select(m, s_next, u)
    return a_next, delta
