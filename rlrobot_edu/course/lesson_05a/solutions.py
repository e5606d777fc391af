"""Solutions of lesson 05a, as a learner writes them."""

import math


def n_traces(gamma, lam, threshold):
    return math.floor(math.log(threshold) / math.log(gamma * lam))


def lam_for(gamma, steps, threshold):
    decay = threshold ** (1 / steps)
    return min(1.0, decay / gamma)
