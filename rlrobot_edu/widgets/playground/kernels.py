"""The library's kernels that the playground runs, as one JavaScript program."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rlrobot_edu.learning.memory import trace_steps
from rlrobot_edu.learning.methods import parse_method
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.models.sampling import draw_outcome, draw_start
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.javascript.program import program, rewards_of


def kernels(
    methods: Sequence[str],
    tasks: Mapping[str, Task],
    further: Mapping[str, Callable[..., Any]] | None = None,
) -> str:
    """A program with the kernels of these methods and of all worlds, and the rewards and goals of these tasks.

    Its names: ``select_i`` and ``learn_step_i`` of method i, ``reward_NAME`` and ``goal_NAME`` of a task, and those of
    further kernels.
    """
    shared = (begin_episode, draw_outcome, draw_start, drive, look, trace_steps)
    given = {kernel.__name__: kernel for kernel in shared}
    for i, method in enumerate(methods):
        step = make_step(parse_method(method))
        given |= {f"select_{i}": step.select, f"learn_step_{i}": step.learn_step}
    for name, task in tasks.items():
        given |= rewards_of(task, f"_{name}")
    return program(given | dict(further or {}))
