"""Solutions of lesson 10, as a learner writes them."""

import math

bins = (1, 2, 3, 0, 3)
still_safe = 0.05 + 2 * 0.0975


def motion(left, right, radius, separation):
    v = radius * (left + right) / 2
    omega = radius * (right - left) / separation
    return v, math.degrees(omega)
