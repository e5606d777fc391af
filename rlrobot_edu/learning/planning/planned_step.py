"""One step of an agent that plans: the step as it is without, and then some that are only imagined."""

from collections.abc import Callable
from functools import cache
from typing import Any

from rlrobot_edu.jit.dispatcher import borrowed, compiled
from rlrobot_edu.learning.algorithm import Planner
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.planning.experience import count_outcome
from rlrobot_edu.learning.step import make_step


@cache
def make_plan(planner: Planner) -> Callable[..., Any]:
    """The kernel that keeps in mind what happened, and imagines steps as `planner` does, compiled for it alone."""
    imagine = compiled(planner.plan)

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

    return plan


@cache
def make_planned_step(method: Method) -> Callable[..., Any]:
    """`learn_step` of `method` with planning between its update and what Q-learning selects, compiled for it alone."""
    select, learn_step = make_step(method)[1:]
    assert method.planner is not None
    plan, on_policy = make_plan(method.planner), method.algorithm.on_policy

    @compiled
    def planned_step(m, x, s, a, r, s_next, terminated, u, rng):
        """Learn, imagine, select; returns (a', TD error).

        Q-learning selects after it has learned. Planning changes Q, so it selects again, with the same number `u`.
        """
        m, x = borrowed(m), borrowed(x)
        a_next, delta = learn_step(m, s, a, r, s_next, terminated, u)
        plan(m, x, s, a, r, s_next, a_next, terminated, rng)
        if not terminated and not on_policy:
            a_next = select(m, s_next, u)
        return a_next, delta

    return planned_step
