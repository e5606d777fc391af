"""Solutions of lesson 01, as a learner writes them."""

from math import hypot


def bin_of(x, cuts):
    number = 0
    for cut in cuts:
        if x > cut:
            number += 1
    return number


def state_number(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        s = s * n + b
    return s


def reward(before, after):
    left, right = after["laser_front_left"], after["laser_front_right"]
    dx, dy = after["x"] - before["x"], after["y"] - before["y"]
    if min(left, right) < 0.10:
        return -2
    return 10 if hypot(dx, dy) > 0.07 else -0.02
