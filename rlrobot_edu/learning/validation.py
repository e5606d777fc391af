"""Checks, made once in Python, of the numbers that go to compiled code, which looks up no bounds."""

from typing import Any

import numpy as np

from rlrobot_edu.learning.memory import Memory
from rlrobot_edu.task.messages import LARGEST_NUMBER, check_between, existing


def check_pair(memory: Memory, s: int, a: int = 0) -> tuple[int, int]:
    """(s, a) as ints. Raises ValueError for a state or an action that there is not."""
    n_states, n_actions = memory.q.shape
    return existing("state", s, n_states), existing("action", a, n_actions)


def check_transition(
    memory: Memory, s: int, a: int, r: Any, s_next: int
) -> tuple[int, int, float, int]:
    """The transition in Python's own numbers, which kernels know. Raises ValueError for one that cannot be."""
    s, a = check_pair(memory, s, a)
    s_next = existing("state", s_next, len(memory.q))
    if isinstance(r, np.generic | np.ndarray) and r.ndim == 0:
        r = r.item()
    check_between("a reward", r, -LARGEST_NUMBER, LARGEST_NUMBER)
    return s, a, float(r), s_next
