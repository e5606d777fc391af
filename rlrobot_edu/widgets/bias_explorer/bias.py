"""QBIASSR in one state, every number of it: the sets, their means, the bias, and what it does to the choice."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.kernels import bias_of, probabilities


class BiasNumbers(NamedTuple):
    """How QBIASSR chooses in state `s`, beside how SR would choose (paper algorithm 2).

    s: the state; sets: for each input, the states that share all other inputs with `s`, `s` included
    means: array (inputs, n_actions), the mean of Q over each set; bias: array (n_actions,), their mean
    q, biased: arrays (n_actions,), Q(s) and Q(s) + bias(s)
    sr, qbiassr: arrays (n_actions,), the probabilities of the actions without and with the bias
    """

    s: int
    sets: dict[str, np.ndarray]
    means: np.ndarray
    bias: np.ndarray
    q: np.ndarray
    biased: np.ndarray
    sr: np.ndarray
    qbiassr: np.ndarray

    @property
    def members(self) -> list[tuple[int, str | None]]:
        """`s` itself, with None, and then every other state of the sets with the one input in which it differs."""
        others = [(int(k), name) for name, states in self.sets.items() for k in states if k != self.s]
        return [(self.s, None), *others]


def bias_numbers(task: Task, q: np.ndarray, s: int, scale: float, temperature: float) -> BiasNumbers:
    """Choose in state `s` with and without the bias, and keep what was computed on the way.

    q: array (n_states, n_actions); scale: normalises both softmaxes alike, see `Parameters.q_scale`
    temperature: Boltzmann temperature > 0. Raises ValueError if there is no such state.
    """
    sets = task.states.siblings(s)
    bias = bias_of(q, task.states.shape, s)
    means = np.array([q[states].mean(axis=0) for states in sets.values()])
    own, biased = q[s].copy(), q[s] + bias
    return BiasNumbers(
        s, sets, means, bias, own, biased, *(probabilities(x * scale, temperature) for x in (own, biased))
    )
