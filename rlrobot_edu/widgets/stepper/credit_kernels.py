"""Kernels by which a page finds the rewards behind a value (credit.js) and the states behind a bias (advice.js)."""

from __future__ import annotations

import ast
import json
from typing import Any

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.methods import ALGORITHMS
from rlrobot_edu.widgets.javascript.program import program
from rlrobot_edu.widgets.stepper.page_data import algorithms_for
from rlrobot_edu.widgets.stepper.symbols import SYMBOLS

ARITHMETIC = {
    ast.Add: "$plus",
    ast.Sub: "$minus",
    ast.Mult: "$times",
    ast.USub: "$negative",
}


def update_kernels(agent: Agent, parameters: dict[str, Any]) -> str:
    """A JavaScript expression for credit.js: the updates of the algorithms, or the reason why there are none.

    parameters: those of the first step, as memory.py names them
    """
    own = agent.method.algorithm
    reason = None
    if agent.method.planner:
        reason = "an agent that plans learns from imagined steps, too"
    elif own.name not in SYMBOLS or own != ALGORITHMS[own.name]:
        reason = (
            f"the values of the toolkit's {', '.join(SYMBOLS)} are sums of rewards; "
            f"of {own.name} this is not known"
        )
    if reason is not None:
        return json.dumps({"reason": f"No answer here: {reason}."}, ensure_ascii=False)
    updates = {
        f"update_{i}": algorithm.update
        for i, algorithm in enumerate(algorithms_for(agent))
    }
    kernels = program(updates, ARITHMETIC)
    return f"{{parameters: {json.dumps(parameters)}, kernels: {kernels}}}"


def selection_kernel(agent: Agent) -> str:
    """A JavaScript expression for advice.js: the selection of `agent`; null if it has no bias, or no translation."""
    selection = agent.method.selection
    if not selection.is_biased:
        return "null"
    try:
        kernels = program({"compute_probabilities": selection.compute_probabilities})
    except ValueError:  # a selection of one's own may contain anything
        return "null"
    return f"{kernels}.compute_probabilities"
