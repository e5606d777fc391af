"""Further wrong answers of lesson 01: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it
# ruff: noqa: B007, B905, F821, SIM108

import numpy as np


def bin_while_beyond_end(x, cuts):
    i = 0
    while x > cuts[i]:
        i += 1
    return i


def bin_fixed_cuts_with_elif(x, cuts):
    if x <= cuts[0]:
        return 0
    elif x <= cuts[1]:
        return 1
    elif x <= cuts[2]:
        return 2
    else:
        return 3


def bin_list_as_index(x, cuts):
    number = 0
    for cut in cuts:
        if x > cuts[cut]:
            number += 1
    return number


def bin_float_text(x, cuts):
    return f"bin {sum(x > cut for cut in cuts)}"


def bin_returns_from_else(x, cuts):
    for i in range(len(cuts)):
        if x > cuts[i]:
            number = i + 1
        else:
            number = 0
    return number


def bin_last_wins(x, cuts):
    number = len(cuts)
    for i, cut in enumerate(cuts):
        if x <= cut:
            number = i
    return number


def number_four_hard_coded(bins, shape):
    return ((bins[0] * shape[1] + bins[1]) * shape[2] + bins[2]) * shape[3] + bins[3]


def number_for_b_n_in_bins(bins, shape):
    s = 0
    for b, n in bins, shape:
        s = s * n + b
    return s


def number_next_shape_index(bins, shape):
    s = 0
    for i in range(len(bins)):
        s = (s + bins[i]) * shape[i + 1]
    return s


def number_power(bins, shape):
    s = 0
    for i, b in enumerate(bins):
        s += b * shape[i] ** (len(bins) - 1 - i)
    return s


def number_for_i_in_bins(bins, shape):
    s = 0
    for i in bins:
        s = s * shape[i] + bins[i]
    return s


def number_index_of_shape_from_bins(bins, shape):
    s = bins[0]
    for i in range(1, len(bins)):
        s = s * shape[i] + bins[i - 1]
    return s


def number_loop_variable_typo(bins, shape):
    s = 0
    for b, n in zip(bins, shape):
        s = s * N + b
    return s


def reward_sqrt_without_import(before, after):
    d = sqrt((after["x"] - before["x"]) ** 2 + (after["y"] - before["y"]) ** 2)
    return 10 if d > 0.07 else -0.02


def reward_product_with_distance_to_wall(before, after):
    d = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    return d * min(after["laser_front_left"], after["laser_front_right"])


def reward_brackets_of_key_missing(before, after):
    d = np.hypot(after[x] - before[x], after[y] - before[y])
    return 10 if d > 0.07 else -2


WRONG = {
    "bin_of": [
        (bin_while_beyond_end, "cuts has 3 entries, numbered"),
        (bin_fixed_cuts_with_elif, "cuts has one entry"),
        (bin_list_as_index, "cut is 0.27, and an"),
        (bin_float_text, "the bin is text"),
        (bin_returns_from_else, "a later cut point"),
        (bin_last_wins, "the loop goes on"),
    ],
    "state_number": [
        (number_four_hard_coded, "shape has 2 entries, numbered"),
        (number_for_b_n_in_bins, "two lists are gone"),
        (number_next_shape_index, "shape has 4 entries, numbered"),
        (number_power, "the weight of a"),
        (number_for_i_in_bins, "for i in bins"),
        (number_index_of_shape_from_bins, "size and bin belong"),
        (number_loop_variable_typo, "N is not known"),
    ],
    "reward": [
        (reward_sqrt_without_import, "sqrt is one of"),
        (reward_product_with_distance_to_wall, "who runs into a"),
        (reward_brackets_of_key_missing, "a key of a"),
    ],
}
