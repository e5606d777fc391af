"""Everything a learning agent remembers, as arrays that compiled and plain kernels can share."""

import math
from copy import deepcopy
from dataclasses import fields
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.jit.dispatcher import IS_PLAIN
from rlrobot_edu.learning.parameters import SMALLEST_REDUCED_TRACE, Parameters

_NUMBERS: list[Any] = [
    (p.name, p.type) for p in fields(Parameters) if p.type in (float, bool, int)
]
# See Parameters
SETTINGS = np.dtype([*_NUMBERS, ("q_scale", float), ("smallest_trace", float)])
NOW = np.dtype(
    [
        ("temperature", float),
        ("q_old", float),
        ("register_size", int),
        ("queue_size", int),
        ("queue_unique", int),
        ("queue_end", int),
    ]
)


class Memory(NamedTuple):
    """The arrays of one agent; S states, A actions.

    q, e: arrays (S, A), the action values and their eligibility traces
    visits: array (S, A) of int, how often each pair was tried
    register: array (n + 1,) of int, states with a trace, the most recently visited first
    queue_states, queue_rewards, queue_count: LRLE's ring of recent states and rewards; times each state is in it (S,)
    shape: array (inputs,) of int, bins of each input variable
    probabilities, bias: arrays (A,), what the last selection computed
    parameters, now: records of the dtypes above. Of `now`:

    temperature: what the last selection used; LRLE raises it
    q_old: TOSL: Q(s', a') as it was before the last update
    register_size: number of states in the register of traces
    queue_size, queue_unique: LRLE: number of states, and of different states, in the queue
    queue_end: LRLE: where in the ring the next state goes
    """

    q: np.ndarray
    e: np.ndarray
    visits: np.ndarray
    register: np.ndarray
    queue_states: np.ndarray
    queue_rewards: np.ndarray
    queue_count: np.ndarray
    shape: np.ndarray
    probabilities: np.ndarray
    bias: np.ndarray
    parameters: np.record
    now: np.record


def trace_steps(
    gamma: float, lam: float, threshold: float = SMALLEST_REDUCED_TRACE
) -> float:
    """Number of steps after which a trace of 1 has decayed below `threshold` (paper equation 8); inf if it never does.

    γ = λ = 0.9 gives 21 (the bound is 21.85).
    """
    decay = gamma * lam
    if decay == 0.0:
        return 0
    if decay >= 1.0:
        return math.inf
    return math.floor(math.log(threshold) / math.log(decay))


def new_memory(
    shape: tuple[int, ...], n_actions: int, parameters: Parameters
) -> Memory:
    """A memory in which nothing has been learned yet."""
    n_states = math.prod(shape)
    n = trace_steps(parameters.gamma, parameters.lam)
    kept = n_states if parameters.traces == "full" else min(n + 1, n_states)
    # LRLE: as many as there are traces, within [4, states/4]
    queue = int(max(4, min(n, n_states // 4)))
    memory = Memory(
        q=np.zeros((n_states, n_actions)),
        e=np.zeros((n_states, n_actions)),
        visits=np.zeros((n_states, n_actions), dtype=np.int64),
        register=np.zeros(int(kept), dtype=np.int64),
        queue_states=np.zeros(queue, dtype=np.int64),
        queue_rewards=np.zeros(queue),
        queue_count=np.zeros(n_states, dtype=np.int64),
        shape=np.array(shape, dtype=np.int64),
        probabilities=np.full(n_actions, 1 / n_actions),
        bias=np.zeros(n_actions),
        parameters=new_record(SETTINGS),
        now=new_record(NOW),
    )
    set_parameters(memory, parameters)
    memory.now.temperature = parameters.temperature
    return memory


def set_parameters(memory: Memory, parameters: Parameters) -> None:
    """Let the kernels see these parameters from now on."""
    for name in SETTINGS.names or ():
        value = getattr(parameters, name)
        setattr(memory.parameters, name, SETTINGS[name].type(value))


def new_record(dtype: np.dtype) -> Any:
    """Numbers with these names, all zero. Compiled kernels know numpy's records, which plain Python reads slowly."""
    if IS_PLAIN:
        zeros = {name: dtype[name].type(0) for name in dtype.names or ()}
        return SimpleNamespace(**zeros)
    return np.zeros(1, dtype).view(np.recarray)[0]


def copies(arrays: tuple[Any, ...]) -> tuple[Any, ...]:
    """Copies of what is in a named tuple of arrays, records and such tuples."""
    return tuple(
        copies(each) if isinstance(each, tuple) else deepcopy(each) for each in arrays
    )


def copy_into(arrays: tuple[Any, ...], source: tuple[Any, ...]) -> None:
    """Give the arrays the values of others of the same kinds: of their copies, for example."""
    for each, other in zip(arrays, source, strict=True):
        if isinstance(each, tuple):
            copy_into(each, other)
        elif isinstance(each, np.ndarray):
            each[...] = other
        elif isinstance(each, SimpleNamespace):
            for name, value in vars(other).items():
                setattr(each, name, value)
        else:
            each.setfield(other, each.dtype)  # the whole record at once
