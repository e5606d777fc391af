"""Solutions of lesson 15, as a learner writes them."""

from math import hypot


def follow_reward(before, after):
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    moved = hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -0.6
    beside = 0.10 < after["laser_right"] <= 0.40
    return 10 if beside and moved > 0.07 else -0.4


size = [3 * 4 * 2 * 8, 3600 / (3 * 4 * 2 * 8)]

faults = [3, 1, 4]
