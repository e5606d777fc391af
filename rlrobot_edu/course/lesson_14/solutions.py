"""Solutions of lesson 14, as a learner writes them."""

import numpy as np

agents_needed = 2 * (3 / (0.5 / 3)) ** 2


def f_ratio(groups):
    everyone = np.concatenate(groups)
    between = sum(len(g) * (np.mean(g) - everyone.mean()) ** 2 for g in groups)
    within = sum(np.sum((g - np.mean(g)) ** 2) for g in groups)
    return (between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))


def p_value(observed, shuffled):
    return sum(f >= observed for f in shuffled) / len(shuffled)
