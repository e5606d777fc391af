"""Further wrong answers of lesson 03a: errors far from their cause, and mistakes that once had no hint."""

# what is wrong stays as learners write it

import numpy as np


def temperature_subtracts(gap, odds):
    return gap - np.log(odds)


def temperature_base_argument(gap, odds):
    return gap / np.log(odds, np.e)


def normalise_brackets(q_s, r_max, gamma):
    return q_s * 100 / r_max * 1 - gamma


def normalise_adds(q_s, r_max, gamma):
    return q_s + 100 * (1 - gamma) / r_max


WRONG = {
    "temperature_for": [
        (temperature_subtracts, "log(odds) is gap /"),
        (temperature_base_argument, "this function of numpy"),
    ],
    "normalise": [
        (normalise_brackets, "brackets are missing around 1"),
        (normalise_adds, "the row is multiplied"),
    ],
}
