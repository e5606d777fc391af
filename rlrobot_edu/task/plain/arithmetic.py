"""The arithmetic of plain functions: what Python's numbers do, and floats alone would not.

Python, numba and JavaScript all run these few lines. Where they raise, the step is given back to Python, which takes it
with the task's own functions, and raises or goes on as Python does.
"""

import math

# From here on a float no longer knows each whole number, but Python's whole numbers go on
LARGEST = 2.0**53


def exact(x: float) -> float:
    """The result x of a sum, a difference or a product, which is the same for whole numbers and for floats.

    Raises OverflowError from 2**53 on.
    """
    if abs(x) >= LARGEST:
        raise OverflowError("the number is too large for a plain function")
    return x


def divided(a: float, b: float) -> float:
    """a / b. Raises ZeroDivisionError, as Python does and a float's division would not."""
    if b == 0.0:
        raise ZeroDivisionError("division by zero")
    return a / b


def root(x: float) -> float:
    """The square root. Raises ValueError below 0, as `math.sqrt` does."""
    if x < 0.0:
        raise ValueError("there is no square root below 0")
    return math.sqrt(x)


def rounded(x: float) -> float:
    """The nearest whole number, of two equally near ones the even one; never −0.0.

    Raises OverflowError from 2**53 on and for NaN.
    """
    if not abs(x) < LARGEST:
        raise OverflowError("the number is too large to be rounded")
    below = math.floor(x) + 0.0
    half = below / 2.0
    is_odd = math.floor(half) != half
    rest = x - below
    if rest > 0.5 or (rest == 0.5 and is_odd):
        return below + 1.0
    return below


def smaller(a: float, b: float) -> float:
    """``min(a, b)``, also for NaN: the second only if it is smaller."""
    return b if b < a else a


def larger(a: float, b: float) -> float:
    """``max(a, b)``, also for NaN: the second only if it is larger."""
    return b if b > a else a
