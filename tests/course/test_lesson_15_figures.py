"""Lesson 15's figures, against every possible deal."""

import numpy as np
import pytest

from rlrobot_course.lesson_15.figures import differences_of_few, shuffled_f

GROUPS = {"a": np.array([1.0, 2.0, 3.0, 2.5]), "b": np.array([2.0, 3.5, 4.0, 3.0])}


def test_shuffled_groups_give_the_p_value_of_all_possible_deals():
    """Oracle: every one of the 70 ways to deal eight numbers to two groups of four."""
    from itertools import combinations

    from scipy.stats import f_oneway

    everything = np.concatenate(list(GROUPS.values()))
    exact = []
    for chosen in combinations(range(8), 4):
        rest = [i for i in range(8) if i not in chosen]
        exact.append(f_oneway(everything[list(chosen)], everything[rest]).statistic)
    observed = f_oneway(*GROUPS.values()).statistic
    p = np.mean(shuffled_f(GROUPS, times=4000) >= observed - 1e-9)
    assert p == pytest.approx(np.mean(np.array(exact) >= observed - 1e-9), abs=0.02)


def test_few_agents_scatter_as_the_formula_says():
    rng = np.random.default_rng(1)
    a, b = rng.normal(2.0, 3.0, 400), rng.normal(1.0, 3.0, 400)
    for n in (10, 100):
        found = differences_of_few(a, b, n, times=4000)
        assert found.std() == pytest.approx(np.sqrt((a.var() + b.var()) / n), rel=0.05)
        assert found.mean() == pytest.approx(a.mean() - b.mean(), abs=0.1)
