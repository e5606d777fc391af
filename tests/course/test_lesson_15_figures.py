"""Lesson 15's figures, against every possible deal."""

from itertools import combinations

import numpy as np
import pytest
from paper import paper
from scipy import stats

from rlrobot_course.lesson_15.figures import (
    draws_of_few,
    few_finding,
    plot_shuffled,
    plot_two_tests,
    shuffled_f,
    shuffled_finding,
    two_intervals,
)
from rlrobot_course.lesson_15.whole_paper import (
    PAPER,
    Difference,
    differences,
    plot_report,
    set_ups,
)

GROUPS = {"a": np.array([1.0, 2.0, 3.0, 2.5]), "b": np.array([2.0, 3.5, 4.0, 3.0])}


def test_shuffled_groups_give_the_p_value_of_all_possible_deals():
    """Oracle: every one of the 70 ways to deal eight numbers to two groups of four."""
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
        x, y = draws_of_few(a, b, n, times=4000)
        found = x.mean(axis=1) - y.mean(axis=1)
        assert found.std() == pytest.approx(np.sqrt((a.var() + b.var()) / n), rel=0.05)
        assert found.mean() == pytest.approx(a.mean() - b.mean(), abs=0.1)


def test_the_two_intervals_are_those_of_the_formulas():
    """Oracle: critical range times the uncertainty, from one mean square for all pairs or from the pair's variances."""
    groups = set_ups()["wander_simple, 300 steps"][1]
    n = 100
    variances = {method: x.var(ddof=1) for method, x in groups.items()}
    for a, b in combinations(groups, 2):
        found = two_intervals(groups, a, b)
        uncertain = np.sqrt(sum(variances.values()) / 3 / n)
        half = stats.studentized_range.ppf(0.95, 3, 3 * n - 3) * uncertain
        u, v = variances[a] / n, variances[b] / n
        df = (u + v) ** 2 * (n - 1) / (u**2 + v**2)
        own = stats.studentized_range.ppf(0.95, 3, df) * np.sqrt((u + v) / 2)
        difference = groups[a].mean() - groups[b].mean()
        for test, expected in (("Tukey", half), ("Games and Howell", own)):
            low, high = found[test]
            assert (high - low) / 2 == pytest.approx(expected, rel=1e-3)
            assert (high + low) / 2 == pytest.approx(difference)


def test_the_picture_of_two_tests_names_the_pair_on_which_they_disagree():
    groups = set_ups()["wander_simple, 300 steps"][1]
    picture = plot_two_tests(groups)
    assert picture.finding.endswith("disagree on TOSL+QBIASSR and TOSL+SR")
    assert "TOSL+QBIASSR less TOSL+SR: -0.73 to 0.13 by Tukey" in picture.alt
    two = {method: groups[method] for method in ("TOSL+SR", "Q+SR")}
    assert "Both tests say the same" in plot_two_tests(two).finding


def test_the_papers_differences_are_those_of_the_report_and_each_set_up_is_drawn():
    for task, numbers in PAPER.items():
        theirs = {
            frozenset((p.better, p.worse)): (p.better, paper.difference(task, p))
            for p in paper.TUKEY[task]
        }
        for (first, second), number in zip(
            combinations(paper.THREE, 2), numbers, strict=True
        ):
            better, difference = theirs[frozenset((first, second))]
            assert number == pytest.approx(
                difference if better == first else -difference, rel=0.01
            )
    picture = plot_report()
    assert len(picture.axes[0].get_yticks()) == len(set_ups()) == 20
    assert "14 of 60 are opposite to it, and significantly so 8" in picture.alt
    assert picture.finding.startswith("22 of 60 differences are clearly as the paper")
    assert "8 clearly the other way; 30 are too uncertain" in picture.finding


def test_a_difference_is_turned_to_the_papers_direction_and_judged():
    found = differences()["wander_simple, 300 steps"]
    groups = set_ups()["wander_simple, 300 steps"][1]
    ours = groups["TOSL+SR"].mean() - groups["TOSL+QBIASSR"].mean()
    turned = found["TOSL+QBIASSR less TOSL+SR"]
    assert turned.ours == pytest.approx(ours), "the paper's own is below 0 here"
    assert turned.theirs > 0
    for p, ours, verdict in (
        (0.04, 1.0, "as the paper"),
        (0.04, -1.0, "other way"),
        (0.06, 1.0, "cannot tell"),
    ):
        assert Difference(ours, 0.5, 1.0, p).verdict == verdict


def test_the_titles_of_shuffles_and_of_few_agents_are_shares():
    shuffled = np.array([1.0, 2.0, 3.0, 4.0])
    assert shuffled_finding(shuffled, 3.0).endswith("in 50.0% of the shuffles")
    assert shuffled_finding(shuffled, 9.0).startswith("None of 4")
    share = np.mean(
        shuffled_f(GROUPS, 200) >= stats.f_oneway(*GROUPS.values()).statistic
    )
    assert f"{share:.1%}" in plot_shuffled(GROUPS, times=200).finding
    found = {10: np.array([-1.0, 3.0, 3.0, 3.0]), 100: np.array([1.0, 2.0])}
    said = few_finding(found, ("good", "bad"))
    assert said == "bad is ahead in 25% of the draws of 10, in 0% of the draws of 100"
