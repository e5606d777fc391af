"""Lesson 15's figures, against every possible deal."""

from itertools import combinations

import numpy as np
import pytest
from paper import paper

from rlrobot_course.lesson_15.figures import (
    distance,
    draws_of_few,
    few_finding,
    plot_shuffled,
    shuffled_distances,
    shuffled_finding,
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
    a, b = GROUPS.values()
    everything = np.concatenate([a, b])
    exact = []
    for chosen in combinations(range(8), 4):
        rest = [i for i in range(8) if i not in chosen]
        exact.append(distance(everything[list(chosen)], everything[rest]))
    observed = distance(a, b) - 1e-9
    p = np.mean(shuffled_distances(a, b, times=4000) >= observed)
    assert p == pytest.approx(np.mean(np.array(exact) >= observed), abs=0.02)


def test_few_agents_scatter_as_the_formula_says():
    rng = np.random.default_rng(1)
    a, b = rng.normal(2.0, 3.0, 400), rng.normal(1.0, 3.0, 400)
    for n in (10, 100):
        x, y = draws_of_few(a, b, n, times=4000)
        found = x.mean(axis=1) - y.mean(axis=1)
        assert found.std() == pytest.approx(np.sqrt((a.var() + b.var()) / n), rel=0.05)
        assert found.mean() == pytest.approx(a.mean() - b.mean(), abs=0.1)


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
    a, b = GROUPS.values()
    share = np.mean(shuffled_distances(a, b, 200) >= distance(a, b))
    assert f"{share:.1%}" in plot_shuffled(GROUPS, times=200).finding
    found = {10: np.array([-1.0, 3.0, 3.0, 3.0]), 100: np.array([1.0, 2.0])}
    said = few_finding(found, ("good", "bad"))
    assert said == "bad is ahead in 25% of the draws of 10, in 0% of the draws of 100"
