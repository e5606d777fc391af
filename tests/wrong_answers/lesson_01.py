"""Typical wrong answers of lesson 01, written as learners write them, and a word of the hint each must get."""

import numpy as np


def bin_side_right(x, cuts):
    return int(np.searchsorted(cuts, x, side="right"))


def bin_from_1(x, cuts):
    return int(np.digitize(x, cuts, right=True)) + 1


def bin_from_above(x, cuts):
    return int((np.array(cuts) >= x).sum())


def bin_without_the_last(x, cuts):
    for i, cut in enumerate(cuts):
        if x <= cut:
            return i
    return len(cuts) - 1


def bin_no_return(x, cuts):
    for i, cut in enumerate(cuts):
        if x <= cut:
            return i


def bin_near_or_far(x, cuts):
    return 0 if x <= cuts[0] else 1


def bin_is_a_cut(x, cuts):
    above = [cut for cut in cuts if cut >= x]
    return above[0] if above else cuts[-1]


def bin_pops(x, cuts):
    number = 0
    while cuts and x > cuts.pop(0):
        number += 1
    return number


def bin_argmax(x, cuts):
    return int(np.argmax(x <= np.array(cuts)))


def bin_by_number(x, cuts):
    return sum(x > cut for cut in range(len(cuts)))


def bin_of_the_laser(x, cuts):
    return 0 if x <= 0.27 else 1 if x <= 0.53 else 2 if x <= 0.80 else 3


def bin_without_a_sign(x, cuts):
    return sum(abs(x) > cut for cut in cuts)


def number_pops(bins, shape):
    s = 0
    while bins:
        s = s * shape.pop(0) + bins.pop(0)
    return s


def number_skips_zeros(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        if b:
            s = s * n + b
    return s


def number_returns_early(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        s = s * n + b
        return s


def number_neighbour(bins, shape):
    s = bins[0]
    for i in range(1, len(bins)):
        s = s * shape[i - 1] + bins[i]
    return s


def number_fortran(bins, shape):
    return int(np.ravel_multi_index(bins, shape, order="F"))


def number_own_size(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        s = (s + b) * n
    return s


def number_sum(bins, shape):
    return int(np.sum(bins))


def number_decimal(bins, shape):
    return int("".join(str(b) for b in bins))


def number_first_size(bins, shape):
    return sum(b * shape[0] ** i for i, b in enumerate(reversed(bins)))


def number_from_1(bins, shape):
    return int(np.ravel_multi_index(bins, shape)) + 1


def number_dot(bins, shape):
    return int(np.dot(bins, shape))


def way(before, after):
    return ((after["x"] - before["x"]) ** 2 + (after["y"] - before["y"]) ** 2) ** 0.5


def touches(readings):
    return readings["laser_front_left"] < 0.1 or readings["laser_front_right"] < 0.1


def reward_alive(before, after):
    return -100 if touches(after) else 5


def reward_open_space(before, after):
    return 3 * min(after["laser_front_right"], after["laser_front_left"])


def reward_forward_x(before, after):
    if touches(after):
        return -10
    return 1 if after["x"] > before["x"] + 0.07 else 0


def reward_x_alone(before, after):
    if touches(after):
        return -10
    return 1 if (after["x"] - before["x"]) ** 2 > 0.07**2 else 0


def reward_either_axis(before, after):
    if touches(after):
        return -10
    return 1 if abs(after["x"] - before["x"]) > 0.07 or abs(after["y"] - before["y"]) > 0.07 else 0


def reward_fearful(before, after):
    if after["laser_front_left"] < 0.3 or after["laser_front_right"] < 0.3:
        return -10
    return 1 if way(before, after) > 0.07 else 0


def reward_careless(before, after):
    return 10 if way(before, after) > 0.07 else -0.02


def reward_wrong_sign(before, after):
    return 10 if touches(after) else 10 if way(before, after) > 0.07 else -0.02


def reward_and(before, after):
    if after["laser_front_left"] < 0.1 and after["laser_front_right"] < 0.1:
        return -10
    return 10 if way(before, after) > 0.07 else -0.02


def reward_left_only(before, after):
    if after["laser_front_left"] < 0.1:
        return -10
    return 10 if way(before, after) > 0.07 else -0.02


def reward_scraping(before, after):
    total = 10 if way(before, after) > 0.07 else -0.02
    if touches(after):
        total -= 2
    return total


def reward_driving_first(before, after):
    if way(before, after) > 0.07:
        return 10
    return -2 if touches(after) else -0.02


def reward_of_before(before, after):
    if touches(before):
        return -10
    return 10 if way(before, after) > 0.07 else -0.02


def reward_any_motion(before, after):
    return -2 if touches(after) else 10 if way(before, after) > 0.01 else -0.02


def reward_manhattan(before, after):
    if touches(after):
        return -2
    return 10 if abs(after["x"] - before["x"]) + abs(after["y"] - before["y"]) > 0.07 else -0.02


def reward_place(before, after):
    return -2 if touches(after) else 10 if after["x"] > 0.07 else -0.02


def reward_text(before, after):
    return "-2" if touches(after) else "10" if way(before, after) > 0.07 else "0"


def reward_way_alone(before, after):
    return way(before, after)


def reward_no_return(before, after):
    if touches(after):
        return -10
    if way(before, after) > 0.07:
        return 10


WRONG = {
    "bin_of": [
        (bin_side_right, "bin below"),
        (bin_from_1, "from 0"),
        (bin_from_above, "above x"),
        (bin_without_the_last, "last bin is missing"),
        (bin_no_return, "returns nothing"),
        (bin_near_or_far, "every one of them"),
        (bin_is_a_cut, "number of the bin"),
        (bin_pops, "copy"),
        (bin_argmax, "argmax"),
        (bin_by_number, "not with the cut points"),
        (bin_of_the_laser, "list cuts"),
        (bin_without_a_sign, "negative"),
    ],
    "state_number": [
        (number_fortran, "fastest"),
        (number_own_size, "Multiply first"),
        (number_sum, "different states share"),
        (number_decimal, "decimal"),
        (number_first_size, "as the first one"),
        (number_from_1, "from 0"),
        (number_dot, "own input alone"),
        (number_pops, "copy"),
        (number_skips_zeros, "bin of 0"),
        (number_returns_early, "inside the loop"),
        (number_neighbour, "before this one"),
    ],
    "reward": [
        (reward_alive, "stands still touches nothing"),
        (reward_open_space, "open space"),
        (reward_forward_x, "one direction"),
        (reward_x_alone, "along y"),
        (reward_either_axis, "Pythagoras"),
        (reward_fearful, "0.11 m"),
        (reward_careless, "costs nothing"),
        (reward_wrong_sign, "wrong sign"),
        (reward_and, "one laser is enough"),
        (reward_left_only, "only the left"),
        (reward_scraping, "scraping"),
        (reward_driving_first, "Scraping"),
        (reward_of_before, "after the step"),
        (reward_no_return, "returns nothing"),
        (reward_any_motion, "paid alike"),
        (reward_manhattan, "Pythagoras, again"),
        (reward_place, "where the robot is"),
        (reward_text, "one number"),
        (reward_way_alone, "costs nothing"),
    ],
}
