"""How the bins of one robot lie in those of another one."""

import numpy as np

from rlrobot_edu.task.variables import InputVariable


def edges(variable: InputVariable) -> list[float]:
    """The edges of an input's bins, with the ends of what its sensor can read."""
    return [variable.low, *(variable.cuts or ()), variable.high]


def overlap(target: InputVariable, source: InputVariable) -> np.ndarray:
    """Which part of each bin of `target` lies in each bin of `source`.

    Parameters
    ----------
    target, source : InputVariable
        Two inputs with cuts, in the same unit.

    Returns
    -------
    array (bins of target, bins of source)
        Each row sums to 1.
    """
    ours, theirs = np.array(edges(target)), np.array(edges(source))
    left = np.maximum.outer(ours[:-1], theirs[:-1])
    right = np.minimum.outer(ours[1:], theirs[1:])
    common = np.maximum(right - left, 0.0)
    return common / common.sum(axis=1, keepdims=True)
