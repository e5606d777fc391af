"""Bins of one input as bins of another: by how far their physical intervals overlap."""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from scipy import sparse

from rlrobot_edu.task.variables import InputVariable

SLIVER = 1e-9  # part of the whole range; what is narrower comes from rounding


def overlap(target: InputVariable, source: InputVariable) -> sparse.csr_array:
    """How much of each bin of `target` lies in each bin of `source`, sparse array (bins of target, bins of source).

    The range is cut at the limits of both, so that each piece lies in one bin of either; a bin's row holds the lengths
    of its pieces, as parts of what `source` knows of the bin. So a row sums to 1, or to 0 if `source` knows nothing of
    it. Angles are cut on the circle. If an input is a list of values, each value is a piece of the same weight.

    Raises ValueError if the units differ.
    """
    if target.unit != source.unit:
        raise ValueError(
            f"input {target.name!r}: the source has it in {source.unit!r}, the target in {target.unit!r}; "
            "give both the same unit"
        )
    rows, columns, lengths = [], [], []
    for reading, length in _pieces(target, source):
        try:
            row, column = target.bin(reading), source.bin(reading)
        except ValueError:
            continue  # a reading that one of the two does not know
        rows.append(row)
        columns.append(column)
        lengths.append(length)
    shares = (
        np.array(lengths) / np.bincount(rows, lengths, target.n_bins)[rows]
        if rows
        else np.zeros(0)
    )
    return sparse.csr_array(
        (shares, (rows, columns)), shape=(target.n_bins, source.n_bins)
    )


def _pieces(
    target: InputVariable, source: InputVariable
) -> Iterator[tuple[float, float]]:
    """A reading within each piece, and the piece's length."""
    for variable in (target, source):
        if variable.values is not None:
            yield from ((value, 1.0) for value in variable.values)
            return
    low, high = _ends(target, source)
    limits = {
        limit
        for variable in (target, source)
        for limit in _limits(variable)
        if low < limit < high
    }
    for left, right in pairwise(sorted({low, high} | limits)):
        if right - left > SLIVER * (high - low):
            yield left + (right - left) / 2, right - left


def _limits(variable: InputVariable) -> list[float]:
    """Where bins meet."""
    if variable.sectors is None:
        return list(variable.cuts or ())
    turn, n = 2 * math.pi, variable.sectors
    return [math.remainder((k + 0.5) * turn / n, turn) for k in range(n)]


def _ends(target: InputVariable, source: InputVariable) -> tuple[float, float]:
    """The range that both inputs know. One without an end is closed, as far from the outermost cut as all cuts span."""
    low, high = max(target.low, source.low), min(target.high, source.high)
    limits = [limit for variable in (target, source) for limit in _limits(variable)]
    beyond = max(limits) - min(limits) or 1.0
    return (min(limits) - beyond if math.isinf(low) else low), (
        max(limits) + beyond if math.isinf(high) else high
    )
