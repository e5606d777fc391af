"""One step of an agent that plans: the step as it is without, and then some that are only imagined. A template."""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.planning.dyna import plan as imagine
from rlrobot_edu.learning.planning.experience import count_outcome
from rlrobot_edu.learning.templates.step import learn_step, select

ON_POLICY = False


@compiled
def plan(m, x, s, a, r, s_next, a_next, terminated, rng):
    """Keep in mind what happened after (s, a), and imagine as many steps as the agent's parameters say.

    True online SARSA(λ) corrects by what its own last update changed in Q(s', a'), so its Q_old goes along with
    what planning changes there.
    """
    before = 0.0 if terminated else m.q[s_next, a_next]
    count_outcome(x, s * m.q.shape[1] + a, s_next, r, terminated)
    imagine(m, x, s, a, m.parameters.planning_steps, rng)
    if not terminated:
        m.now.q_old += m.q[s_next, a_next] - before


@compiled
def planned_step(m, x, s, a, r, s_next, terminated, u, rng):
    """Learn, imagine, select; returns (a', TD error).

    Q-learning selects after it has learned. Planning changes Q, so it selects again, with the same number `u`.
    """
    a_next, delta = learn_step(m, s, a, r, s_next, terminated, u)
    plan(m, x, s, a, r, s_next, a_next, terminated, rng)
    if not terminated and not ON_POLICY:
        a_next = select(m, s_next, u)
    return a_next, delta
