"""The colours of values: blue above 0, vermilion below, and nothing at 0, whatever the other values are."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from rlrobot_edu.show.palette import BLUE, ORANGE, VERMILION

FAINTEST, STRONGEST = (
    0.10,
    0.68,
)  # opacities; black on a white page and white on a black one stand out on all of them


def largest(q: np.ndarray, r_max: float) -> float:
    """The value of the strongest colour: 1, 2 or 5 times a power of ten, no less than any |Q| and than `r_max`.

    In such leaps, so that a value keeps its colour from one step to the next.
    """
    most = max(float(q.max()), -float(q.min()), r_max)
    power = 10.0 ** math.floor(math.log10(most))
    return next(power * leap for leap in (1, 2, 5, 10) if power * leap >= most)


@lru_cache(8192)
def tint(x: float, most: float) -> tuple[str, float]:
    """Colour and opacity of the value `x`. By its root, so that −0.9 shows next to 25."""
    if x == 0:
        return BLUE, 0.0
    strength = math.sqrt(min(abs(x) / most, 1.0))
    return (BLUE if x > 0 else VERMILION), round(
        FAINTEST + (STRONGEST - FAINTEST) * strength, 2
    )


def trace_tint(e: float) -> tuple[str, float]:
    """Colour and opacity of the trace `e`."""
    return ORANGE, round(STRONGEST * min(e, 1.0), 2)
