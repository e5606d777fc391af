"""How much one column of numbers tells about another: mutual information, and whether it is more than chance."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

SHIFTS = 99  # more than all of them: this happens by chance once in a hundred times

Column = NDArray[np.integer]


class Information(NamedTuple):
    """What x tells about y, given z.

    bits: mutual information less what comes about by chance [bit], at least 0
    is_real: whether it is larger than in each of SHIFTS trials with columns that have nothing to do with one another
    """

    bits: float
    is_real: bool


def information(x: Column, y: Column, z: Column, rng: np.random.Generator) -> Information:
    """The conditional mutual information I(x; y | z) = H(x, z) + H(y, z) − H(x, y, z) − H(z).

    x, y, z: arrays (n,) of int, n steps of one process in their order
    Few samples of many kinds seem to tell something even where nothing is to be told. Chance is
    measured by shifting x in time against y and z, all around: x itself goes on as it does.
    Source: Cover & Thomas, Elements of Information Theory, chapter 2.
    """
    n = len(x)
    yz, z = _codes(y, z), _codes(z)
    known = _entropy(yz) - _entropy(z)

    def told(x: Column) -> float:
        return _entropy(_codes(x, z)) + known - _entropy(_codes(x, yz))

    by_chance = [told(np.roll(x, shift)) for shift in rng.integers(n // 10, n - n // 10, size=SHIFTS)]
    bits = told(x)
    return Information(max(0.0, bits - float(np.mean(by_chance))), bits > max(by_chance) + 1e-12)


def _codes(*columns: Column) -> Column:
    """One number for each different row of the columns."""
    code = np.zeros(len(columns[0]), dtype=np.int64)
    for column in columns:
        values, kind = np.unique(column, return_inverse=True)
        code = np.unique(code * len(values) + kind, return_inverse=True)[1]
    return code


def _entropy(codes: Column) -> float:
    """The entropy of how often each code occurs [bit]."""
    p = np.unique(codes, return_counts=True)[1] / len(codes)
    return float(-(p * np.log2(p)).sum())
