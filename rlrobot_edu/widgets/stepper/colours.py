"""The colours of values: blue above 0, red below, nothing at 0; the other values decide only how strong."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from rlrobot_edu.show.palette import BLUE, ORANGE, RED

# Opacities. Black letters on a white page, and white ones on a black page, can be read on all of them.
FAINTEST = 0.18
STRONGEST = 0.68
STRONGEST_TRACE = 0.5  # light letters can be read on it, too


def scale_limit(q: np.ndarray, r_max: float) -> float:
    """The value that gets the strongest colour: the least 1, 2 or 5 × 10^k that no |Q| exceeds, nor `r_max`.

    It changes rarely, so a value mostly keeps its colour.
    """
    largest = max(float(q.max()), -float(q.min()), r_max)
    power = 10.0 ** math.floor(math.log10(largest))
    return next(power * leap for leap in (1, 2, 5, 10) if power * leap >= largest)


@lru_cache(8192)
def tint(x: float, limit: float) -> tuple[str, float]:
    """Colour and opacity of the value `x`, at its strongest from `limit` on.

    Opacity grows with the square root of |x|, so that −0.9 can be seen next to 25.
    """
    if x == 0:
        return BLUE, 0.0
    colour = BLUE if x > 0 else RED
    strength = math.sqrt(min(abs(x) / limit, 1.0))
    opacity = FAINTEST + (STRONGEST - FAINTEST) * strength
    return colour, round(opacity, 2)


def trace_tint(e: float) -> tuple[str, float]:
    """Colour and opacity of the trace `e`."""
    return ORANGE, round(STRONGEST_TRACE * min(e, 1.0), 2)
