"""What the loop of lesson 02 is given to update, without chance."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from rlrobot_edu.course.tapes import in_order


def learner(alpha: float, gamma: float) -> Callable[..., None]:
    """The update that the loop of the exercise calls."""

    def update(*arguments: Any) -> None:
        learn_from(*in_order("update", ("q", "s", "a", "r", "s_next", "terminated"), arguments))

    def learn_from(q: np.ndarray, s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
        q[s, a] += alpha * (r + (0.0 if terminated else gamma * q[s_next].max()) - q[s, a])

    return update
