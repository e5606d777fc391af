"""Every number of QBIASSR in one state: the sets, their means, the bias, and how it changes the choice."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.kernels import bias_of, probabilities


class BiasNumbers(NamedTuple):
    """How QBIASSR chooses in state `s`, compared with SR (paper algorithm 2).

    s: the state; sets: for each input, the states that share all other inputs with `s`, `s` included
    means: array (inputs, n_actions), the mean of Q over each set; bias: array (n_actions,), their mean
    sr, qbiassr: arrays (n_actions,), the probabilities of the actions without and with the bias
    """

    s: int
    sets: dict[str, np.ndarray]
    means: np.ndarray
    bias: np.ndarray
    sr: np.ndarray
    qbiassr: np.ndarray

    @property
    def most_changed(self) -> int:
        """The action whose probability the bias changes most."""
        return int(np.abs(self.qbiassr - self.sr).argmax())


def bias_numbers(
    task: Task, q: np.ndarray, s: int, scale: float, temperature: float
) -> BiasNumbers:
    """Choose in state `s` with and without the bias, and keep all intermediate results.

    q: array (n_states, n_actions); scale: normalises both softmaxes, see `Parameters.q_scale`
    temperature: Boltzmann temperature > 0. Raises ValueError if there is no such state.
    """
    sets = task.states.siblings(s)
    means = np.array([q[states].mean(axis=0) for states in sets.values()])
    bias = bias_of(q, task.states.shape, s)
    sr = probabilities(q[s] * scale, temperature)
    qbiassr = probabilities((q[s] + bias) * scale, temperature)
    return BiasNumbers(s, sets, means, bias, sr, qbiassr)
