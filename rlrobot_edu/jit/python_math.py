"""Python's `math` for somebody's own kernels: where it raises, numba's returns NaN, infinity or any whole number."""

import math
from collections.abc import Callable
from math import *  # noqa: F403 - all that is not replaced below
from typing import Any

from rlrobot_edu.jit.dispatcher import compiled

OF_ONE_NUMBER = (
    "sqrt exp expm1 log log2 log10 log1p gamma lgamma sin cos tan asin acos atan "
    "sinh cosh tanh asinh acosh atanh"
)
TO_WHOLE_NUMBERS = "floor ceil trunc"
LARGEST = 2.0**63  # of numba's whole numbers


def _raising(function: Any) -> Callable[..., Any]:
    @compiled
    def checked(x):
        y = function(x)
        if math.isnan(y) and not math.isnan(x):
            raise ValueError("math domain error")
        if math.isinf(y) and not math.isinf(x):
            raise ValueError("math domain error")
        return y

    return checked


def _whole(function: Any) -> Callable[..., Any]:
    @compiled
    def checked(x):
        if not abs(x) < LARGEST:
            raise OverflowError("cannot convert the number to a whole one")
        return function(x)

    return checked


# by Python's function, the one in its place
INSTEAD = {
    getattr(math, name): _raising(getattr(math, name)) for name in OF_ONE_NUMBER.split()
}
INSTEAD |= {
    getattr(math, name): _whole(getattr(math, name))
    for name in TO_WHOLE_NUMBERS.split()
}
globals().update({function.__name__: checked for function, checked in INSTEAD.items()})
