"""The kernels of one method: its step, with what it is made of in the places of the templates' parts."""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from rlrobot_edu.jit.building import Build, build, build_in_python, for_python
from rlrobot_edu.jit.dispatcher import compiled, is_ours
from rlrobot_edu.learning.loop_evasion import forget_loops
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.templates import checked, planned_step, step
from rlrobot_edu.learning.traces import forget


class StepKernels(NamedTuple):
    """The kernels of one method.

    update: (memory, s, a, r, s', a', terminated) -> TD error, the algorithm's own
    select: (memory, s, u) -> action
    learn_step: (memory, s, a, r, s', terminated, u) -> (a', TD error)
    plan: (memory, experience, s, a, r, s', a', terminated, rng), keeps in mind what happened, and imagines steps
    planned_step: (memory, experience, s, a, r, s', terminated, u, rng) -> (a', TD error), `learn_step` with planning
        between its update and what Q-learning selects

    Without a planner, the last two are None.
    """

    update: Callable[..., Any]
    select: Callable[..., Any]
    learn_step: Callable[..., Any]
    plan: Callable[..., Any] | None = None
    planned_step: Callable[..., Any] | None = None


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
    """The kernels of `method`, put together from its algorithm, its selection and its planner."""
    return _step_of(method, build)


def _step_of(method: Method, build: Build) -> StepKernels:
    update = method.algorithm.update
    compute_probabilities = method.selection.compute_probabilities
    if not is_ours(update):
        update = build(checked, update=update).checked_update
    if not is_ours(compute_probabilities):
        parts = {"compute_probabilities": compute_probabilities}
        compute_probabilities = build(checked, **parts).checked_probabilities
    on_policy = method.algorithm.on_policy
    one = build(
        step,
        update=update,
        compute_probabilities=compute_probabilities,
        ON_POLICY=on_policy,
    )
    plain = for_python(one.update), one.select, one.learn_step
    if method.planner is None:
        return StepKernels(*plain)
    planned = build(
        planned_step,
        imagine=method.planner.plan,
        select=one.select,
        learn_step=one.learn_step,
        ON_POLICY=on_policy,
    )
    return StepKernels(*plain, for_python(planned.plan), planned.planned_step)


def plain_step(method: Method) -> StepKernels:
    """The kernels of `method` as plain Python."""
    return _step_of(method, build_in_python)


@cache
def own_parts(method: Method) -> dict[str, Any]:
    """Those functions of a method that are not the toolkit's, by what they are called in an error."""
    algorithm, selection, planner = method.algorithm, method.selection, method.planner
    functions = {
        f"the update of {algorithm.name}": algorithm.update,
        f"the selection {selection.name}": selection.compute_probabilities,
    }
    if planner is not None:
        functions[f"the planner {planner.name}"] = planner.plan
    return {
        what: getattr(function, "py_func", function)
        for what, function in functions.items()
        if not is_ours(function)
    }
