"""The colours of values: blue above 0, vermilion below, and nothing at 0, whatever the other values are."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from rlrobot_edu.show.palette import BLUE, ORANGE, VERMILION

# Opacities. Black letters on a white page, and white ones on a black page, can be read on all of them.
FAINTEST = 0.10
STRONGEST = 0.68


def largest(q: np.ndarray, r_max: float) -> float:
    """The value of the strongest colour: 1, 2 or 5 times a power of ten, no less than any |Q| and than `r_max`.

    It grows in such leaps, so that a value keeps its colour from one step to the next.
    """
    most = max(float(q.max()), -float(q.min()), r_max)
    power = 10.0 ** math.floor(math.log10(most))
    return next(power * leap for leap in (1, 2, 5, 10) if power * leap >= most)


@lru_cache(8192)
def tint(x: float, most: float) -> tuple[str, float]:
    """Colour and opacity of the value `x`. They depend on its root, so that −0.9 can be seen next to 25."""
    if x == 0:
        return BLUE, 0.0
    colour = BLUE if x > 0 else VERMILION
    strength = math.sqrt(min(abs(x) / most, 1.0))
    opacity = FAINTEST + (STRONGEST - FAINTEST) * strength
    return colour, round(opacity, 2)


def trace_tint(e: float) -> tuple[str, float]:
    """Colour and opacity of the trace `e`."""
    return ORANGE, round(STRONGEST * min(e, 1.0), 2)
