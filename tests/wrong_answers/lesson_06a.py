"""Typical wrong answers of appendix 06a, written as learners write them, and a word of the hint each must get."""

import numpy as np


def n_step_returns(rewards, values, gamma):
    powers = gamma ** np.arange(len(rewards) + 1)
    return np.cumsum(powers[:-1] * rewards) + powers[1:] * values


def lambda_all_weights_alike(rewards, values, gamma, lam):
    return (1 - lam) * lam ** np.arange(len(rewards)) @ n_step_returns(rewards, values, gamma)


def lambda_longest(rewards, values, gamma, lam):
    g = values[-1]
    for r in reversed(rewards):
        g = r + gamma * g
    return g


def lambda_one_step(rewards, values, gamma, lam):
    return rewards[0] + gamma * values[0]


def lambda_starts_at_zero(rewards, values, gamma, lam):
    g = 0
    for r, v in zip(rewards[::-1], values[::-1], strict=True):
        g = r + gamma * ((1 - lam) * v + lam * g)
    return g


def lambda_without_values(rewards, values, gamma, lam):
    g = 0
    for r in rewards[::-1]:
        g = r + gamma * lam * g
    return g


def lambda_without_gamma(rewards, values, gamma, lam):
    g = values[-1]
    for r, v in zip(rewards[::-1], values[::-1], strict=True):
        g = r + (1 - lam) * v + lam * g
    return g


def lambda_value_one_gamma_short(rewards, values, gamma, lam):
    g = n_step_returns(rewards, np.array(values) / gamma, gamma)
    weights = (1 - lam) * lam ** np.arange(len(g))
    weights[-1] = 1 - weights[:-1].sum()
    return weights @ g


def lambda_last_weight(rewards, values, gamma, lam):
    n, g, total = len(rewards), 0, 0
    for k in range(1, n + 1):
        g = sum(gamma**i * rewards[i] for i in range(k)) + gamma**k * values[k - 1]
        total += (1 - lam) * lam ** (k - 1) * g if k < n else lam**n * g
    return total


def lambda_swapped(rewards, values, gamma, lam):
    g = values[-1]
    for r, v in zip(reversed(rewards), reversed(values), strict=True):
        g = r + lam * ((1 - gamma) * v + gamma * g)
    return g


def lambda_normalised(rewards, values, gamma, lam):
    weights = lam ** np.arange(len(rewards))
    return weights @ n_step_returns(rewards, values, gamma) / weights.sum()


def lambda_sum(rewards, values, gamma, lam):
    return sum(n_step_returns(rewards, values, gamma))


def lambda_pops(rewards, values, gamma, lam):
    g = values[-1]
    while rewards:
        g = rewards.pop() + gamma * ((1 - lam) * values.pop() + lam * g)
    return g


def weighted(rewards, gamma, lam, values):
    g = n_step_returns(rewards, values, gamma)
    return np.append((1 - lam) * lam ** np.arange(len(g) - 1), lam ** (len(g) - 1)), g


def lambda_weights_reversed(rewards, values, gamma, lam):
    weights, g = weighted(rewards, gamma, lam, values)
    return weights[::-1] @ g


def lambda_value_one_too_far(rewards, values, gamma, lam):
    weights, g = weighted(rewards, gamma, lam, [*values[1:], 0.0])
    return weights @ g


def lambda_value_in_full(rewards, values, gamma, lam):
    weights, g = weighted(rewards, gamma, lam, np.array(values) / gamma ** np.arange(1, len(values) + 1))
    return weights @ g


def lambda_gamma_for_one_only(rewards, values, gamma, lam):
    g = values[-1]
    for r, v in zip(reversed(rewards), reversed(values), strict=True):
        g = r + gamma * lam * g + (1 - lam) * v
    return g


def lambda_forward(rewards, values, gamma, lam):
    g = values[-1]
    for r, v in zip(rewards, values, strict=True):
        g = r + gamma * ((1 - lam) * v + lam * g)
    return g


WRONG = {
    "lambda_return": [
        (lambda_all_weights_alike, "do not sum to 1"),
        (lambda_longest, "longest return alone"),
        (lambda_one_step, "one-step return alone"),
        (lambda_starts_at_zero, "not with 0"),
        (lambda_without_values, "values are missing"),
        (lambda_without_gamma, "γ is missing"),
        (lambda_last_weight, "not λⁿ"),
        (lambda_value_one_gamma_short, "one step further off"),
        (lambda_swapped, "changed places"),
        (lambda_normalised, "divided by their sum"),
        (lambda_sum, "weights that sum to 1"),
        (lambda_pops, "work on a copy"),
        (lambda_weights_reversed, "do not go together"),
        (lambda_value_one_too_far, "not values[k]"),
        (lambda_value_in_full, "not discounted"),
        (lambda_gamma_for_one_only, "γ is for both"),
        (lambda_forward, "runs forward"),
        (lambda rewards, values, gamma, lam: n_step_returns(rewards, values, gamma), "one number"),
    ],
    "largest_alpha": [
        (0.81, "share of a trace"),
        (1 / (1 - 0.81), "how high the trace climbs"),
        (0.1, "1 − 0.9"),
        (1, "climbs above 1"),
        (1 / 1.81, "two visits"),
        (1 / 4.47, "nine steps"),
        (1 / 4.263, "has faded"),
        (1 / 5.26, "is rounded"),
        (0.2, "a digit more"),
        (0.81 / 0.19, "before the next visit"),
        (5, "rounded, how high"),
        (0.21, "does overshoot"),
        ("1 - 0.81", "without quotation marks"),
    ],
}
