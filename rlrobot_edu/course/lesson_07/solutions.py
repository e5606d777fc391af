"""Solutions of lesson 07, as a learner writes them."""

import numpy as np

by_hand = ((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 - 1) / 3 + (5 - 8) / 2) / 4


def siblings(shape, s, i):
    bins = list(np.unravel_index(s, shape))
    numbers = []
    for k in range(shape[i]):
        bins[i] = k
        numbers.append(int(np.ravel_multi_index(bins, shape)))
    return numbers


def bias(q, shape, s):
    total = np.zeros(q.shape[1])
    for i in range(len(shape)):
        total += q[siblings(shape, s, i)].mean(axis=0)
    return total / len(shape)


def own_share(shape):
    return np.mean([1 / n for n in shape])
