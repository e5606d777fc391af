"""The titles of the studies' figures are findings: they follow from the numbers, and change with them."""

from types import SimpleNamespace

import baselines
import better_bias_page
import kinematic_arm
import numpy as np
import pytest
import transfer_figure
from paper.experiments import EXPERIMENTS, PRELIMINARIES
from paper.figures import (
    Look,
    differences_title,
    preliminaries_title,
    questions,
    shuttle_title,
)
from paper.outcome import read_outcomes
from test_headlines import DOCS


@pytest.fixture(scope="module")
def outcomes():
    return read_outcomes(DOCS / "reproduction/averages.csv", EXPERIMENTS)


def test_a_difference_is_as_the_papers_the_other_way_or_not_significant():
    assert Look(1, 0.5, 2, 1).sign == 1 and Look(-1, 0.5, -2, 1).sign == 1
    assert Look(1, 0.5, -2, 1).sign == -1
    assert Look(1, 0.5, 0.9, 1).sign == 0
    looks = [Look(1, 0.5, 2, 1), Look(1, 0.5, -2, 1), Look(0.1, 0.5, 2, 1)]
    title = differences_title(looks)
    assert "sure of 2 " in title
    assert "here 1 are significant, too, and 1 the other way" in title


def test_the_title_of_the_preliminary_tests_counts_where_the_papers_choice_is_best(
    outcomes,
):
    hits = {"": 0, "_robot": 0}
    for key, _, _, choice in PRELIMINARIES:
        for end in hits:
            means = outcomes[f"preliminary_{key}{end}"].means()
            hits[end] += means[choice] == max(means.values())
    title = preliminaries_title(questions(outcomes))
    assert f"{hits['']} of {len(PRELIMINARIES)} questions on the model" in title
    assert f"{hits['_robot']} on the robot" in title


def test_the_title_of_the_shuttles_says_the_shares_of_tosl_alone():
    found = {
        "arm_1k": {"TOSL+SR": np.array([2.0, 9.0]), "Q+SR": np.array([2.0, 2.0])},
        "arm_1k, no traces": {"TOSL+SR": np.array([9.0, 9.0])},
    }
    title = shuttle_title(found)
    assert title == "Of TOSL's arms 50 % end at a shuttle; without traces 0 %"


@pytest.mark.parametrize(
    "name", ["differences.png", "preliminaries.png", "shuttle.png"]
)
def test_the_report_says_what_its_figures_find(name):
    text = (DOCS / "reproduction/README.md").read_text(encoding="utf-8")
    alt = text[: text.index(f"]({name})")].rpartition("![")[2]
    assert any(
        alt.startswith(start) for start in ("The paper", "The paper's", "Of TOSL's")
    )


def test_a_transfer_is_called_a_help_only_where_it_is_significantly_better():
    page = (
        "**{}**\n\n| agents | first 100 steps |\n| :--- | :--- |\n| from scratch | 2.00 ± 0.10 |\n"
        "| carried over | {} |\n\n"
    )
    better = "3.00 ± 0.10; p < 0.0001 (significant)"
    worse = "1.00 ± 0.10; p < 0.0001 (significant)"
    alike = "2.10 ± 0.10; p = 0.60"
    text = page.format("a", better) + page.format("b", worse) + page.format("c", alike)
    title = transfer_figure.title_of(transfer_figure.carries_of(text))
    assert title == "What was carried over helps: a; not shown: b and c"


def test_the_figure_of_transfer_shows_the_numbers_of_its_page():
    text = (DOCS / "studies/transfer.md").read_text(encoding="utf-8")
    carries = transfer_figure.carries_of(text)
    assert len(carries) == 5
    assert all(set(ways) <= set(transfer_figure.LOOKS) for ways in carries.values())
    drawn = dict(list(carries.items())[:4])
    assert transfer_figure.title_of(drawn) in text


def test_the_title_of_the_networks_says_where_the_best_of_them_and_the_paper_s_method_end():
    def runs(*high):
        names = ["TOSL+QBIASSR", "Q+SR", "DQN, fitted", "PPO, fitted"]
        ends = dict(zip(names, [-6.0, 20.0, *high], strict=True))
        return {
            method: [{"windows": [0.0, end, end, end]}] for method, end in ends.items()
        }

    title = baselines.curves_title({"a": runs(8.0, 7.0), "b": runs(1.0, 2.0)})
    assert title.endswith(": a: 8.0 and −6.0; b: 2.0 and −6.0")


def test_the_title_of_the_forest_counts_what_is_significant():
    rows = [SimpleNamespace(sign=sign) for sign in (1, 1, 0, -1)]
    title = better_bias_page.forest_title(rows)
    assert "more in 2 of 4 comparisons, and less in 1" in title


def test_the_arms_drift_apart_only_if_all_do():
    states = np.zeros((2, 20))
    states[:, 10:] = 1
    np.testing.assert_array_equal(kinematic_arm.in_tens(states), [0, 100])
    apart, alike = np.array([0.0, 100.0]), np.array([50.0, 50.0])
    assert "drift apart: 0 to 0 % of the states differ at its start, 100 to 100 %" in (
        kinematic_arm.figure_title({"a": apart, "b": apart})
    )
    both = kinematic_arm.figure_title({"a": apart, "b": alike})
    assert both.startswith("The arms do not all drift apart")
