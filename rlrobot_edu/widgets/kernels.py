"""The library's kernels as functions that return their result, so that it can be examined outside the loop."""

from collections.abc import Sequence

import numpy as np

from rlrobot_edu.learning.selections.qbiassr import compute_bias
from rlrobot_edu.learning.selections.softmax import softmax


def probabilities(x: Sequence[float] | np.ndarray, temperature: float) -> np.ndarray:
    """The softmax of the preferences `x`, array (n_actions,), as a new array."""
    p = np.empty(len(x))
    softmax(np.asarray(x, dtype=float), temperature, p)
    return p


def bias_of(q: np.ndarray, shape: Sequence[int], s: int) -> np.ndarray:
    """QBIASSR's bias of state `s` as a new array (n_actions,). `shape`: bins of each input."""
    bias = np.zeros(q.shape[1])
    compute_bias(q, np.array(shape), s, bias)
    return bias
