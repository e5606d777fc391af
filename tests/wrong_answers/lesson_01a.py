"""Typical wrong answers of lesson 01a, written as learners write them, and a word of the hint each must get."""

import numpy as np


def return_from_1(rewards, gamma):
    return sum(r * gamma**k for k, r in enumerate(rewards, start=1))


def return_without_gamma(rewards, gamma):
    return float(np.sum(rewards))


def return_same_factor(rewards, gamma):
    g = 0
    for k, r in enumerate(rewards):
        g += r if k == 0 else gamma * r
    return g


def return_wrong_end(rewards, gamma):
    g = 0
    for r in rewards:
        g = gamma * g + r
    return g


def return_times_k(rewards, gamma):
    return float(np.dot(rewards, gamma * np.arange(len(rewards))))


def return_last(rewards, gamma):
    g = 0
    for k, r in enumerate(rewards):
        g = gamma**k * r
    return g


def return_mean(rewards, gamma):
    return float(np.mean(np.array(rewards) * gamma ** np.arange(len(rewards)))) if rewards else 0


def return_rounded(rewards, gamma):
    return round(sum(gamma**k * r for k, r in enumerate(rewards)), 2)


def return_fixed_gamma(rewards, gamma):
    return sum(0.9**k * r for k, r in enumerate(rewards))


def return_never_negative(rewards, gamma):
    return max(0, sum(gamma**k * r for k, r in enumerate(rewards)))


def return_pops(rewards, gamma):
    g = 0
    while rewards:
        g = rewards.pop() + gamma * g
    return g


def return_not_summed(rewards, gamma):
    return [gamma**k * r for k, r in enumerate(rewards)]


def return_squared_gamma(rewards, gamma):
    g = 0
    for r in rewards:
        g += gamma * r
        gamma *= gamma
    return g


def return_hat(rewards, gamma):
    return sum((gamma ^ k) * r for k, r in enumerate(rewards))


def return_prints(rewards, gamma):
    print(sum(gamma**k * r for k, r in enumerate(rewards)))


WRONG = {
    "discounted_return": [
        (return_from_1, "counts in full"),
        (return_without_gamma, "γ is missing"),
        (return_same_factor, "one more factor"),
        (return_wrong_end, "wrong end"),
        (return_times_k, "multiplied γ by k"),
        (return_last, "Add them all up"),
        (return_mean, "not a mean"),
        (return_rounded, "rounded"),
        (return_fixed_gamma, "argument gamma"),
        (return_never_negative, "may be negative"),
        (return_pops, "copy"),
        (return_not_summed, "Add them up"),
        (return_squared_gamma, "again and again"),
        (return_hat, "two stars"),
        (return_prints, "print"),
    ],
    "far_from_the_goal": [
        (0.4096, "too many"),
        (0.64, "too few"),
        (1, "forgot γ"),
        (0.8, "once for every step"),
        (0, "all that is to come"),
        (2.952, "pay 0"),
        (0.51, "rounded"),
        ("0.512", "quotation marks"),
        ([0.512], "brackets"),
        (3.2, "their number"),
        (0.2, "divided it"),
    ],
}
