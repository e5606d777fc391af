"""Solutions of lesson 05, as a learner writes them."""

import math

by_hand = 2 + 0.1 * (-10) * (0.9 * 0.5) ** 2


def sarsa_lambda_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


def n_traces(gamma, lam, threshold):
    return math.floor(math.log(threshold) / math.log(gamma * lam))


def lam_for(gamma, steps, threshold):
    decay = threshold ** (1 / steps)
    return min(1.0, decay / gamma)
