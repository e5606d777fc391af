"""Solutions of lesson 15, as a learner writes them."""

from math import hypot


def follow_reward(before, after):
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    dx, dy = after["x"] - before["x"], after["y"] - before["y"]
    if near < 0.05:
        return -2
    if hypot(dx, dy) <= 0.07:
        return -0.02
    return 10 if 0.10 < after["laser_right"] <= 0.40 else 1


size = [3 * 4 * 2 * 8, 3600 / (3 * 4 * 2 * 8)]

faults = [3, 1, 4]
