"""Typical wrong answers of lesson 05a, written as learners write them, and words of the hint each must get."""

import math

import numpy as np


def n_counts_one_too_far(gamma, lam, threshold):
    n, trace = 0, 1.0
    while trace > threshold:
        trace *= gamma * lam
        n += 1
    return n


def n_rounds(gamma, lam, threshold):
    return int(np.log(threshold) / np.log(gamma * lam) + 0.5)


def n_exact(gamma, lam, threshold):
    return np.log10(threshold) / np.log10(gamma * lam)


def n_without_lam(gamma, lam, threshold):
    return int(math.log(threshold, gamma))


def n_without_gamma(gamma, lam, threshold):
    return int(math.log(threshold, lam))


def n_upside_down(gamma, lam, threshold):
    return int(math.log(gamma * lam) / math.log(threshold))


def n_product(gamma, lam, threshold):
    return math.log(threshold) // (math.log(gamma) * math.log(lam))


def n_straight_line(gamma, lam, threshold):
    n, trace = 0, 1.0
    while trace - (1 - gamma * lam) >= threshold:
        trace -= 1 - gamma * lam
        n += 1
    return n


def lam_above_one(gamma, steps, threshold):
    return math.exp(math.log(threshold) / steps) / gamma


def lam_without_gamma(gamma, steps, threshold):
    return math.exp(math.log(threshold) / steps)


def lam_times_gamma(gamma, steps, threshold):
    return gamma * math.exp(math.log(threshold) / steps)


def lam_power(gamma, steps, threshold):
    return math.pow(threshold, steps) / gamma


def lam_evenly(gamma, steps, threshold):
    return threshold / (gamma * steps)


def lam_logarithm(gamma, steps, threshold):
    return np.log(threshold) / steps


def lam_max(gamma, steps, threshold):
    lam = math.exp(math.log(threshold) / steps) / gamma
    return lam if lam > 1 else 1


def n_brackets(gamma, lam, threshold):
    n = 0
    while gamma * lam**n > threshold:
        n += 1
    return n - 1


def n_one_short(gamma, lam, threshold):
    n, trace = 0, gamma * lam
    while trace * gamma * lam > threshold:
        trace *= gamma * lam
        n += 1
    return n


def n_below_hundred(gamma, lam, threshold):
    return max(n for n in range(100) if (gamma * lam) ** n > threshold)


def lam_no_root(gamma, steps, threshold):
    return min(1.0, threshold / gamma**steps)


def lam_whole_division(gamma, steps, threshold):
    return min(1.0, threshold ** (1 // steps) / gamma)


WRONG = {
    "n_traces": [
        (n_counts_one_too_far, "one too many"),
        (n_rounds, "nearest"),
        (n_exact, "bound itself"),
        (n_without_lam, "forgot λ"),
        (n_without_gamma, "forgot γ"),
        (n_upside_down, "changed places"),
        (n_product, "not their product"),
        (n_straight_line, "same share"),
        (n_brackets, "before a product"),
        (n_one_short, "one too few"),
        (n_below_hundred, "ends too soon"),
    ],
    "lam_for": [
        (lam_above_one, "above 1"),
        (lam_without_gamma, "whole decay"),
        (lam_times_gamma, "not multiplied"),
        (lam_power, "power where a root"),
        (lam_evenly, "evenly"),
        (lambda gamma, steps, threshold: min(1, (threshold / gamma) ** (1 / steps)), "once for each step"),
        (lam_logarithm, "exponential"),
        (lam_max, "smaller: min"),
        (lam_no_root, "root is missing"),
        (lam_whole_division, "always returns 1"),
        (lambda gamma, steps, threshold: min(1.0, math.log(threshold) / steps / gamma), "turns it back"),
        (lambda gamma, steps, threshold: min(1.0, threshold**1 / steps / gamma), "needs its brackets"),
    ],
}
