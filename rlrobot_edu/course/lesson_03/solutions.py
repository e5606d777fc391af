"""Solutions of lesson 03, as a learner writes them."""

import numpy as np

by_hand = [0.3 / 3 + 0.7 / 2, 0.3 / 3, 0.3 / 3 + 0.7 / 2]


def epsilon_greedy(q_s, epsilon):
    best = q_s == q_s.max()
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


def draw(p, u):
    total = 0.0
    for a in range(len(p)):
        total += p[a]
        if u < total:
            return a


def softmax(x, temperature):
    powers = np.exp((x - x.max()) / temperature)
    return powers / powers.sum()
