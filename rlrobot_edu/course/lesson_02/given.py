"""What the loop of lesson 02 is given: what it calls to choose and to update, without chance."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.tapes import in_order


class Chooser:
    """What the loop of the exercise calls to choose: the best action, or another one, always without chance."""

    def __init__(self, rank: int) -> None:
        self.rank = rank

    def __call__(self, *arguments: Any) -> int:
        """An action. Raises TypeError for other arguments than (q, s)."""
        return self._action(*in_order("choose", ("q", "s"), arguments))

    def _action(self, q: np.ndarray, s: int) -> int:
        """The action of this rank, 0 for the worst."""
        return int(q[s].argsort(kind="stable")[self.rank])


class Wavering(Chooser):
    """A choice that the smallest change of the table changes: it tells who chooses before the update."""

    def _action(self, q: np.ndarray, s: int) -> int:
        return (super()._action(q, s) + int(1000 * q.sum())) % 3


def learner(alpha: float, gamma: float) -> Callable[..., None]:
    """The update that the loop of the exercise calls."""

    def update(*arguments: Any) -> None:
        learn_from(*in_order("update", ("q", "s", "a", "r", "s_next", "terminated"), arguments))

    def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
        q[s, a] += alpha * (r + (0.0 if terminated else gamma * q[s_next].max()) - q[s, a])

    return update
