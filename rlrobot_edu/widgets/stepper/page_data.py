"""The data of a stepper for its page: names, looks and steps, as numbers and words for JSON."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.algorithm import Algorithm
from rlrobot_edu.learning.methods import ALGORITHMS
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.widgets.stepper.code_view import code_html
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.symbols import SYMBOLS, in_symbols
from rlrobot_edu.widgets.stepper.tape import Frame, Tape

Data = dict[str, Any]
DIGITS = 6  # of probabilities and biases, of which three are shown


def feed(tape: Tape, names: Names, at: int) -> Data:
    """All that a page needs: what does not change, the steps that are kept, and the tables before the first of them."""
    return {
        "about": _about(tape, names),
        "start": start_of(tape),
        "frames": [frame_data(frame, tape) for frame in tape.since(0)],
        "at": at,
    }


def start_of(tape: Tape) -> Data:
    """The tables before the earliest step that is kept, without their zeros. The tape ends where it was."""
    shown = tape.t
    dropped = max(tape.first - 1, 0)
    tape.go(tape.first)
    q = tape.q.copy()
    visits = tape.visits.copy()
    if dropped and tape.frame is not None:  # the tape stands after its first step
        change = tape.frame.q_change
        step = tape.frame.step
        q.flat[change.where] = change.old
        visits[step.s, step.a] -= 1
    tape.go(shown)
    return {"q": sparse(q), "visits": sparse(visits), "dropped": dropped}


def sparse(table: np.ndarray) -> list[list[Any]]:
    """Flat positions of what is not 0, and the values there."""
    where = np.flatnonzero(table)
    return [where.tolist(), table.flat[where].tolist()]


def frame_data(frame: Frame, tape: Tape) -> Data:
    """One step, for tape.js."""
    step = frame.step
    look_data = tape.view.look_data
    start = None if frame.start is None else look_data(frame.start)
    trace_where, trace_values = frame.traces
    data = {
        "t": step.t,
        "s": step.s,
        "a": step.a,
        "r": step.r,
        "s2": step.s_next,
        "a2": step.a_next,
        "delta": step.delta,
        "terminated": step.terminated,
        "truncated": step.truncated,
        "episode": frame.episode,
        "n": frame.number,
        "p": np.round(step.probabilities, DIGITS).tolist(),
        "temperature": step.temperature,
        "bias": None if step.bias is None else _rounded(step.bias),
        "start": start,
        "look": look_data(frame.look),
        "qNext": frame.q_next,
        "e": frame.e_sa,
        "qOld": frame.q_old,
        "traces": [trace_where.tolist(), trace_values.tolist()],
        "q": [frame.q_change.where.tolist(), frame.q_change.new.tolist()],
    }
    algorithm = tape.agent.method.algorithm.name
    if algorithm not in SYMBOLS or SYMBOLS[algorithm].next == "mean":
        data["pNext"] = frame.p_next.tolist()
    return data


def _rounded(bias: np.ndarray) -> list[float]:
    return [float(f"{x:.{DIGITS}g}") for x in bias.tolist()]


def _about(tape: Tape, names: Names) -> Data:
    """What does not change from step to step."""
    agent = tape.agent
    method, parameters = agent.method, agent.parameters
    n_states, n_actions = agent.q.shape
    where, code = code_html(agent)
    summary = f"<summary>Code of the update (▶ changes Q): {where}</summary>"
    others = [_symbols(algorithm, parameters) for algorithm in algorithms_for(agent)]
    return {
        "nStates": n_states,
        "nActions": n_actions,
        "rMax": parameters.r_max,
        "keep": tape.keep,
        "parameters": asdict(parameters),
        "isSoftmax": method.selection.is_softmax,
        "isBiased": agent.bias is not None,
        **_symbols(method.algorithm, parameters),
        "methods": others,
        "code": f'<details class="code">{summary}{code}</details>',
        "view": {"heading": tape.view.heading, **tape.view.constant_data()},
        "names": _names_data(names, range(n_actions)),
    }


def _names_data(names: Names, actions: range) -> Data:
    """The names of states and actions."""
    readings = []
    if names.task is not None:
        for variable in names.task.inputs:
            bins = [str(variable.decode(i)) for i in range(variable.n_bins)]
            readings.append([text.replace("-", "−") for text in bins])
    return {
        "inputs": names.inputs,
        "shape": names.shape,
        "outputs": names.outputs,
        "readings": readings,
        "actions": [names.action(a) for a in actions],
        "columns": [names.column(a) for a in actions],
        "rows": [names.row(a) for a in actions],
        "told": [names.told(a) for a in actions],
    }


def algorithms_for(agent: Agent) -> list[Algorithm]:
    """The agent's own algorithm, and the others by which the page can go on."""
    own = agent.method.algorithm
    others = [ALGORITHMS[name] for name in SYMBOLS if name != own.name]
    return [own, *others]


def _symbols(algorithm: Algorithm, parameters: Parameters) -> Data:
    symbols = in_symbols(algorithm.name, parameters)
    return {
        "algorithm": algorithm.name,
        "hasTraces": algorithm.has_traces,
        "next": symbols.next,
        "equation": symbols.equation,
        "trace": symbols.trace,
    }
