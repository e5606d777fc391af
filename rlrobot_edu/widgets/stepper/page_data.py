"""What the page gets of a stepper: names, looks and steps, as numbers and words that JSON knows."""

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
    about = _about(tape, names)
    frames = [frame_data(frame, tape) for frame in tape.since(0)]
    return {"about": about, "start": start_of(tape), "frames": frames, "at": at}


def start_of(tape: Tape) -> Data:
    """The tables before the earliest step that is kept, without their zeros; the tape then stands where it stood."""
    shown, dropped = tape.t, max(tape.first - 1, 0)
    tape.go(tape.first)
    q, visits = tape.q.copy(), tape.visits.copy()
    if (
        dropped and tape.frame
    ):  # the first that can be shown is what a step has made of them
        change, step = tape.frame.q_change, tape.frame.step
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
    step, q, view = frame.step, frame.q_change, tape.view
    where, values = frame.traces
    algorithm = tape.agent.method.algorithm.name
    learns_from_p = algorithm not in SYMBOLS or in_symbols(algorithm).next == "mean"
    return {
        "t": step.t, "s": step.s, "a": step.a, "r": step.r, "s2": step.s_next, "a2": step.a_next, "delta": step.delta,
        "terminated": step.terminated, "truncated": step.truncated, "episode": frame.episode, "n": frame.number,
        "p": np.round(step.probabilities, DIGITS).tolist(), "temperature": step.temperature,
        "bias": None if step.bias is None else [float(f"{x:.{DIGITS}g}") for x in step.bias.tolist()],
        "start": None if frame.start is None else view.look_data(frame.start), "look": view.look_data(frame.look),
        "qNext": frame.q_next, "e": frame.e_sa, "qOld": frame.q_old, "traces": [where.tolist(), values.tolist()],
        "q": [q.where.tolist(), q.new.tolist()], **({"pNext": frame.p_next.tolist()} if learns_from_p else {}),
    }  # fmt: skip


def _about(tape: Tape, names: Names) -> Data:
    agent = tape.agent
    n_states, n_actions = agent.q.shape
    actions = range(n_actions)
    bins = (
        [
            [str(v.decode(i)).replace("-", "−") for i in range(v.n_bins)]
            for v in names.task.inputs
        ]
        if names.task
        else []
    )
    where, code = code_html(agent)
    summary = f"<summary>Code of the update (▶ changes Q): {where}</summary>"
    return {
        "nStates": n_states, "nActions": n_actions, "rMax": agent.parameters.r_max, "keep": tape.keep,
        "parameters": asdict(agent.parameters),
        "isSoftmax": agent.method.selection.is_softmax, "isBiased": agent.bias is not None,
        **_symbols(agent.method.algorithm, agent.parameters),
        "methods": [_symbols(algorithm, agent.parameters) for algorithm in algorithms_for(agent)],
        "code": f'<details class="code">{summary}{code}</details>',
        "view": {"heading": tape.view.heading, **tape.view.constant_data()},
        "names": {
            "inputs": names.inputs, "shape": names.shape, "outputs": names.outputs,
            "readings": bins,
            "actions": [names.action(a) for a in actions], "columns": [names.column(a) for a in actions],
            "rows": [names.row(a) for a in actions],
        },
    }  # fmt: skip


def algorithms_for(agent: Agent) -> list[Algorithm]:
    """The agent's own algorithm, and those that the page offers for going on by another one."""
    own = agent.method.algorithm
    others = [ALGORITHMS[name] for name in SYMBOLS if name != own.name]
    return [own, *others]


def _symbols(algorithm: Algorithm, parameters: Parameters) -> Data:
    symbols = in_symbols(algorithm.name)
    return {
        "algorithm": algorithm.name, "hasTraces": algorithm.has_traces, "next": symbols.next,
        "equation": symbols.equation(parameters), "trace": symbols.trace(parameters),
    }  # fmt: skip
