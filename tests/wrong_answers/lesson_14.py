"""Typical wrong answers of lesson 14, written as learners write them, and a word of the hint each must get."""

import numpy as np


def p_value_smaller(observed, shuffled):
    return sum(f < observed for f in shuffled) / len(shuffled)


def p_value_larger(observed, shuffled):
    return sum(f > observed for f in shuffled) / len(shuffled)


def p_value_count(observed, shuffled):
    return len([f for f in shuffled if f >= observed])


def p_value_per_cent(observed, shuffled):
    return 100 * sum(f >= observed for f in shuffled) / len(shuffled)


def p_value_other_side(observed, shuffled):
    return sum(f <= observed for f in shuffled) / len(shuffled)


def p_value_of_2000(observed, shuffled):
    return (shuffled >= observed).sum() / 2000


def p_value_equal(observed, shuffled):
    return np.mean(shuffled == observed)


def p_value_plus_one(observed, shuffled):
    return (shuffled >= observed).sum() / (len(shuffled) + 1)


def squares(groups):
    everyone = np.concatenate(groups)
    between = sum(len(g) * (g.mean() - everyone.mean()) ** 2 for g in groups)
    within = sum(((g - g.mean()) ** 2).sum() for g in groups)
    return between, within, len(groups), len(everyone)


def f_without_df(groups):
    between, within, _, _ = squares(groups)
    return between / within


def f_upside_down(groups):
    between, within, k, n = squares(groups)
    return within / (n - k) / (between / (k - 1))


def f_k(groups):
    between, within, k, n = squares(groups)
    return between / k / (within / (n - k))


def f_n_less_one(groups):
    between, within, k, n = squares(groups)
    return between / (k - 1) / (within / (n - 1))


def f_eta(groups):
    between, within, _, _ = squares(groups)
    return between / (between + within)


def f_unweighted(groups):
    _, within, k, n = squares(groups)
    grand = np.concatenate(groups).mean()
    return sum((g.mean() - grand) ** 2 for g in groups) / (k - 1) / (within / (n - k))


def f_mean_of_means(groups):
    _, within, k, n = squares(groups)
    grand = np.mean([g.mean() for g in groups])
    return sum(len(g) * (g.mean() - grand) ** 2 for g in groups) / (k - 1) / (within / (n - k))


WRONG = {
    "p_value": [
        (p_value_smaller, "is smaller"),
        (p_value_larger, "equal the observed"),
        (p_value_count, "how many they are"),
        (p_value_other_side, "at most as large"),
        (p_value_per_cent, "between 0 and 1"),
        (p_value_of_2000, "need not be 2000"),
        (p_value_equal, "larger count, too"),
        (p_value_plus_one, "not among the shuffled"),
    ],
    "f_ratio": [
        (f_without_df, "degrees of freedom first"),
        (f_upside_down, "upside down"),
        (f_k, "one less than"),
        (f_n_less_one, "a mean of its own"),
        (f_eta, "η²"),
        (f_unweighted, "as often as"),
        (f_mean_of_means, "mean of the means"),
    ],
    "agents_needed": [
        (324, "two means"),
        (72, "third of it"),
        (18, "squared"),
        (1296, "both methods together"),
        (36, "one mean"),
    ],
}
