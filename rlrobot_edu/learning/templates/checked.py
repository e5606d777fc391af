"""Somebody's own update and selection, and a look at what they leave. A template, with the parts of Q+SR."""

import math

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.algorithms.q_learning import update
from rlrobot_edu.learning.selections.softmax import (
    softmax_regression as compute_probabilities,
)

ROUNDING = 1e-6  # how far from 1 a sum of probabilities may be


@compiled
def checked_update(m, s, a, r, s_next, a_next, terminated):
    """Learn, and return the TD error, which must be a number. Raises ValueError."""
    delta = update(m, s, a, r, s_next, a_next, terminated)
    if not abs(delta) < math.inf:
        raise ValueError("it must return the TD error, a finite number")
    return delta


@compiled
def checked_probabilities(m, s):
    """Compute the probabilities, which must be finite, not negative, and sum to 1. Raises ValueError."""
    compute_probabilities(m, s)
    probabilities = m.probabilities
    total = 0.0
    for a in range(probabilities.shape[0]):
        p = probabilities[a]
        if not 0.0 <= p < math.inf:
            raise ValueError("it must leave probabilities: none below 0, all finite")
        total += p
    if abs(total - 1.0) > ROUNDING:
        raise ValueError("it must leave probabilities: their sum must be 1")
