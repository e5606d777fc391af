"""Typical wrong answers of lesson 13, written as learners write them, and a word of the hint each must get."""

from collections import Counter

import numpy as np


def outcomes(rows, s, a):
    return [(row[3], row[2]) for row in rows if row[0] == s and row[1] == a]


def estimate_of_all_rows(rows, s, a):
    mine = outcomes(rows, s, a)
    return {
        after: (sum(x == after for x, _ in mine) / len(rows), np.mean([r for x, r in mine if x == after]))
        for after in {x for x, _ in mine}
    }


def estimate_counts(rows, s, a):
    mine, result = outcomes(rows, s, a), {}
    for after, n in Counter(x for x, _ in mine).items():
        result[after] = (n, np.mean([r for x, r in mine if x == after]))
    return result


def estimate_of_the_state(rows, s, a):
    mine = [(row[3], row[2]) for row in rows if row[0] == s]
    return {
        after: (sum(x == after for x, _ in mine) / len(mine), np.mean([r for x, r in mine if x == after]))
        for after, _ in mine
    }


def estimate_swapped(rows, s, a):
    mine, result = outcomes(rows, s, a), {}
    for after, n in Counter(x for x, _ in mine).items():
        result[after] = (np.mean([r for x, r in mine if x == after]), n / len(mine))
    return result


def estimate_sums(rows, s, a):
    mine, result = outcomes(rows, s, a), {}
    for after, n in Counter(x for x, _ in mine).items():
        result[after] = (n / len(mine), sum(r for x, r in mine if x == after))
    return result


def estimate_last_reward(rows, s, a):
    mine = outcomes(rows, s, a)
    counts = Counter(x for x, _ in mine)
    return {after: (counts[after] / len(mine), r) for after, r in mine}


def estimate_one_reward(rows, s, a):
    mine = outcomes(rows, s, a)
    mean = np.mean([r for _, r in mine]) if mine else 0
    return {after: (n / len(mine), mean) for after, n in Counter(x for x, _ in mine).items()}


def estimate_probabilities_alone(rows, s, a):
    mine = outcomes(rows, s, a)
    return {after: n / len(mine) for after, n in Counter(x for x, _ in mine).items()}


def sample_reward_first(rows, s, a, u):
    mine = [row[2:] for row in rows if row[:2] == (s, a)]
    return mine[int(u * len(mine))] if mine else None


def sample_any_action(rows, s, a, u):
    mine = [(row[3], row[2]) for row in rows if row[0] == s]
    return mine[int(len(mine) * u)] if mine else None


def sample_never_the_last(rows, s, a, u):
    mine = outcomes(rows, s, a)
    if not mine:
        return None
    return mine[int((len(mine) - 1) * u)]


def sample_most_frequent(rows, s, a, u):
    mine = Counter(outcomes(rows, s, a)).most_common(1)
    return mine[0][0] if mine else None


def sample_of_different_ones(rows, s, a, u):
    mine = []
    for outcome in outcomes(rows, s, a):
        if outcome not in mine:
            mine.append(outcome)
    return mine[int(len(mine) * u)] if mine else None


def sample_first(rows, s, a, u):
    return next(iter(outcomes(rows, s, a)), None)


def sample_next_state_alone(rows, s, a, u):
    mine = outcomes(rows, s, a)
    return mine[int(len(mine) * u)][0] if mine else None


def sample_rounds(rows, s, a, u):
    mine = outcomes(rows, s, a)
    return mine[round((len(mine) - 1) * u)] if mine else None


WRONG = {
    "estimate": [
        (estimate_of_all_rows, "number of all rows"),
        (estimate_counts, "these are counts"),
        (estimate_of_the_state, "other actions"),
        (estimate_swapped, "changed places"),
        (estimate_sums, "added up"),
        (estimate_last_reward, "last reward"),
        (estimate_one_reward, "a mean of its own"),
        (estimate_probabilities_alone, "only the probability"),
    ],
    "sample": [
        (sample_reward_first, "changed places"),
        (sample_any_action, "other actions"),
        (sample_never_the_last, "never drawn"),
        (sample_most_frequent, "most frequent"),
        (sample_of_different_ones, "three times"),
        (sample_first, "always the first"),
        (sample_next_state_alone, "only s′"),
        (sample_rounds, "round"),
    ],
    "enough": [(10, "What is n"), (25, "one standard error"), (97, "1.96"), (400, "either side"), (50, "squared")],
    "second_look": [
        (100, "first sample alone"),
        (67.99, "never ends"),
        (22.99, "comes on top"),
        (45.44, "0.9 times"),
        (229.9, "half of the cases"),
        (45.98, "discounted, too"),
    ],
}
