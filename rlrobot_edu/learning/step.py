"""The kernels of one method: its step, with what it is made of in the places of the templates' parts."""

import math
from collections.abc import Callable
from functools import cache
from types import ModuleType
from typing import Any, NamedTuple

from rlrobot_edu.jit.building import build, for_python
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.loop_evasion import forget_loops
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.templates import planned_step, step
from rlrobot_edu.learning.traces import forget


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
    """The kernels of `method`, put together from its algorithm and its selection."""
    update = compiled(method.algorithm.update)
    built = build(
        step,
        update=update,
        weigh=compiled(method.selection.weigh),
        ON_POLICY=method.algorithm.on_policy,
    )
    return StepKernels(for_python(update), built.select, built.learn_step)


@cache
def make_plan(method: Method) -> Callable[..., Any]:
    """The kernel that keeps in mind what happened, and imagines steps as the planner of `method` does."""
    return for_python(_planning(method).plan)


@cache
def make_planned_step(method: Method) -> Callable[..., Any]:
    """`learn_step` of `method`, with planning between its update and what Q-learning selects."""
    return _planning(method).planned_step


def _planning(method: Method) -> ModuleType:
    assert method.planner is not None
    built = make_step(method)
    return build(
        planned_step,
        imagine=compiled(method.planner.plan),
        select=built.select,
        learn_step=built.learn_step,
        ON_POLICY=method.algorithm.on_policy,
    )
