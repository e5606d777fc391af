"""One step of learning, made for a method: the transition goes in, the next action comes out.

The numbers in `u` are drawn by the caller of the loop, one uniform number in [0, 1) for each selection.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.loop_evasion import forget_loops, watch_for_loops
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.traces import forget

NO_ACTION = -1  # after a terminal state there is nothing to choose


class StepKernels(NamedTuple):
    """The kernels of one method.

    update: (memory, s, a, r, s', a', terminated) -> TD error, the algorithm's own
    select: (memory, s, u) -> action
    learn_step: (memory, s, a, r, s', terminated, u) -> (a', TD error)
    """

    update: Callable[..., Any]
    select: Callable[..., Any]
    learn_step: Callable[..., Any]


@compiled
def begin_episode(m):
    """Forget the traces and the recent states: what happened before has nothing to do with what comes."""
    forget(m)
    forget_loops(m)


@compiled
def no_update(m, s, a, r, s_next, a_next, terminated):
    """The update of an agent that learns no more; there is no TD error."""
    return math.nan


@cache
def make_step(method: Method) -> StepKernels:
    """The kernels of `method`, put together from its algorithm and its selection, and compiled for these two alone."""
    update, weigh = compiled(method.algorithm.update), compiled(method.selection.weigh)
    on_policy = method.algorithm.on_policy

    @compiled
    def select(m, s, u):
        """Draw an action in state `s`: its probabilities are written to the memory, `u` picks one."""
        weigh(m, s)
        below, possible = 0.0, 0
        for a in range(m.probabilities.shape[0]):
            below += m.probabilities[a]
            if u < below:
                return a
            if m.probabilities[a] > 0.0:
                possible = a
        return possible  # u reached the sum, which rounding left a hair below 1

    @compiled
    def learn_step(m, s, a, r, s_next, terminated, u):
        """Learn from (s, a, r, s') and select a'; returns (a', TD error).

        SARSA and its relatives learn from the action they will take, so they select it first. Q-learning learns first.
        """
        m.visits[s, a] += 1
        if not terminated:
            watch_for_loops(m, s_next, r)

        a_next = NO_ACTION
        if not terminated and on_policy:
            a_next = select(m, s_next, u)
        delta = update(m, s, a, r, s_next, a_next, terminated)
        if not terminated and not on_policy:
            a_next = select(m, s_next, u)
        return a_next, delta

    return StepKernels(update, select, learn_step)
