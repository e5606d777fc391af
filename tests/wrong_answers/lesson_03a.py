"""Typical wrong answers of lesson 03a, written as learners write them, and a word of the hint each must get."""

import numpy as np

WRONG = {
    "temperature_for": [
        (lambda gap, odds: gap / np.log10(odds), "base 10"),
        (lambda gap, odds: np.log(odds) / gap, "found 1 / T"),
        (lambda gap, odds: gap / odds, "both sides"),
        (lambda gap, odds: gap * np.log(odds), "isolated T"),
        (lambda gap, odds: np.log(odds), "One step is left"),
        (lambda gap, odds: np.log(gap / odds), "alone"),
        (lambda gap, odds: round(gap / np.log(odds), 2), "rounded"),
    ],
    "normalise": [
        (lambda q_s, r_max, gamma: [100 * x / max(q_s) for x in q_s], "the largest value of the row"),
        (lambda q_s, r_max, gamma: 100 / r_max * q_s, "reward alone"),
        (lambda q_s, r_max, gamma: q_s * 100 / r_max / (1 - gamma), "brackets missing"),
        (lambda q_s, r_max, gamma: q_s / (r_max / (1 - gamma)), "factor 100"),
        (lambda q_s, r_max, gamma: q_s * (r_max / (1 - gamma)) / 100, "upside down"),
        (lambda q_s, r_max, gamma: q_s * 100 / (r_max / 1 - gamma), "r_max − γ"),
        (lambda q_s, r_max, gamma: q_s * 100 / (r_max / (1 - 0.9)), "in place of the number"),
    ],
}
