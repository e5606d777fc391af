"""How a page can tell of what a value and a bias are made: the kernels once more, see credit.js and advice.js."""

from __future__ import annotations

import ast
import json
from types import SimpleNamespace
from typing import Any

import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.step import NO_ACTION
from rlrobot_edu.widgets.javascript.program import program
from rlrobot_edu.widgets.stepper.linear import Linear, plain
from rlrobot_edu.widgets.stepper.told import algorithms_for

ARITHMETIC = {
    ast.Add: "$plus",
    ast.Sub: "$minus",
    ast.Mult: "$times",
    ast.USub: "$negative",
}


def updates(agent: Agent, parameters: dict[str, Any]) -> str:
    """A JavaScript expression for credit.js: the updates of the algorithms, or the reason why there are none.

    parameters: those by which it learned the first of the steps, as memory.py names them
    """
    try:
        if agent.method.planner:
            raise ValueError("an agent that plans learns from imagined steps, too")
        _check_sums(agent)
        algorithms = {
            f"update_{i}": algorithm.update
            for i, algorithm in enumerate(algorithms_for(agent))
        }
        text = program(algorithms, ARITHMETIC)
    except (
        AttributeError,
        TypeError,
        ValueError,
    ) as error:  # what an algorithm of one's own may meet
        return json.dumps({"reason": f"No answer here: {error}."}, ensure_ascii=False)
    return f"{{parameters: {json.dumps(parameters)}, kernels: {text}}}"


def choice(agent: Agent) -> str:
    """A JavaScript expression for advice.js: the selection of `agent`; null where it has no bias, or no translation."""
    selection = agent.method.selection
    if not selection.is_biased:
        return "null"
    try:
        return f"{program({'weigh': selection.weigh})}.weigh"
    except ValueError:  # a selection of one's own may hold anything
        return "null"


def _check_sums(agent: Agent) -> None:
    """Raise TypeError if the update of `agent` is no sum of rewards; all in it must be known to `Linear`."""
    memory = agent.memory
    m = SimpleNamespace(
        **{**memory._asdict(), "q": memory.q.astype(object), "e": memory.e.copy()}
    )
    m.register, m.now = (
        memory.register.copy(),
        SimpleNamespace(q_old=0.0, register_size=0),
    )
    m.q[:] = Linear(0.0, np.zeros(1))
    for terminated in (False, True):
        plain(agent.method.algorithm.update)(
            m,
            0,
            0,
            Linear(1.0, np.ones(1)),
            0,
            NO_ACTION if terminated else 0,
            terminated,
        )
