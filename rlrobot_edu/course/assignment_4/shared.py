"""What the exercises of assignment 4 share."""

from __future__ import annotations

import numpy as np


def table(states: int, actions: int, turn: int) -> np.ndarray:
    """A table of Q with no two alike rows."""
    return np.round(np.sin(np.arange(states * actions) * 1.7 + turn).reshape(states, actions) * 6, 2)
