"""A table of values, split by the inputs that its parts need: the functional analysis of variance.

docs/when_similarity_helps.md says what the split is for.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

Parts = dict[tuple[int, ...], np.ndarray]


def split(q: np.ndarray, shape: Sequence[int]) -> Parts:
    """Q_U by U, the inputs (from 0) that the part depends on; the parts sum to Q.

    q: array (n_states, n_actions); shape: bins of each input. A part is an array of n + 1 axes, the inputs and the
    actions; it has length 1 along each input that is not in U.
    """
    parts: Parts = {(): q.reshape(*shape, -1)}
    for i in range(len(shape)):
        finer: Parts = {}
        for inputs, part in parts.items():
            mean = part.mean(axis=i, keepdims=True)
            finer[inputs] = mean
            finer[*inputs, i] = part - mean
        parts = finer
    return parts


def of_order(q: np.ndarray, shape: Sequence[int], k: int) -> np.ndarray:
    """The sum of all parts of `q` that need exactly `k` inputs, array (n_states, n_actions)."""
    total = np.zeros((*shape, q.shape[1]))
    for inputs, part in split(q, shape).items():
        if len(inputs) == k:
            total += part
    return total.reshape(q.shape)


def spectrum(q: np.ndarray, shape: Sequence[int]) -> np.ndarray:
    """Which share of the variance of `q` each order has, array (n + 1,), which sums to 1.

    Only differences between actions count, since softmax sees no others. All states count alike, as in the bias.
    Raises ValueError if no state prefers any action.
    """
    preferences = q - q.mean(axis=1, keepdims=True)
    if not preferences.any():
        raise ValueError("all actions have the same value in every state")
    shares = np.zeros(len(shape) + 1)
    for inputs, part in split(preferences, shape).items():
        shares[len(inputs)] += np.mean(part**2)
    return shares / shares.sum()


def spectrum_of_noise(shape: Sequence[int]) -> np.ndarray:
    """The mean spectrum of a table whose values are independent random numbers, array (n + 1,).

    Order k has as many of the table's dimensions as the polynomial of all (1 + (b - 1) x) has at x^k, b bins each.
    """
    dimensions = np.ones(1)
    for bins in shape:
        dimensions = np.convolve(dimensions, [1, bins - 1])
    return dimensions / np.prod(shape)


def factors(n: int) -> np.ndarray:
    """By which number Q + bias multiplies the parts of order 0 to n, array (n + 1,): 2 - k / n."""
    return 2 - np.arange(n + 1) / n
