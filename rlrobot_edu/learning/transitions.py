"""Transitions: the one record of experience that histories, kept repetitions and recordings share."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Transitions(NamedTuple):
    """Columns of experience: arrays (n,), one entry a step.

    s, a, r, s_next: state, action, reward and next state; without states, s, a and s_next have no entries
    terminated, truncated: whether an episode ended with that step, for good or by running out of time
    """

    s: NDArray[np.integer]
    a: NDArray[np.integer]
    r: NDArray[np.float64]
    s_next: NDArray[np.integer]
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]

    @classmethod
    def empty(cls, n: int) -> "Transitions":
        """Room for `n` steps."""
        s, a, s_next = np.zeros((3, n), dtype=np.int32)
        return cls(
            s,
            a,
            np.zeros(n),
            s_next,
            np.zeros(n, dtype=np.bool_),
            np.zeros(n, dtype=np.bool_),
        )

    @classmethod
    def of_rows(cls, rows: Sequence[Sequence[Any]]) -> "Transitions":
        """The columns of rows (s, a, r, s', terminated, truncated)."""
        return cls._make(np.array(column) for column in zip(*rows, strict=True))

    def part(self, rows: slice) -> "Transitions":
        """These rows, the same numbers and not copies."""
        return Transitions._make(column[rows] for column in self)

    def without_states(self) -> "Transitions":
        """The rewards and how the episodes ended; the other columns are left empty."""
        nothing = np.zeros(0, dtype=np.int32)
        return self._replace(s=nothing, a=nothing, s_next=nothing)
