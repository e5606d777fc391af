"""Sine and cosine that are the same on every computer, to the last bit."""

import math

from rlrobot_edu.jit.dispatcher import compiled


@compiled
def sine(x):
    """sin x, from its Taylor series, x − x³/3! + …, about the nearest multiple of π.

    For |x| up to some hundreds it is right to 15 digits. The sines of C, of numba and of browsers differ in their last
    bits, so with them one seed would give another run on another platform.
    """
    # Products instead of quotients, here and below: they take a fraction of the time
    half_turns = math.floor(x * (1 / math.pi) + 0.5)
    x -= half_turns * math.pi
    y = x * x
    end = 1 / 6227020800 - y * (
        1 / 1307674368000 - y * (1 / 355687428096000 - y * (1 / 121645100408832000))
    )
    end = 1 / 5040 - y * (1 / 362880 - y * (1 / 39916800 - y * end))
    x *= 1 - y * (1 / 6 - y * (1 / 120 - y * end))
    return x if half_turns % 2 == 0 else -x


@compiled
def cosine(x):
    """cos x, as `sine`."""
    return sine(x + math.pi / 2)
