"""The verdicts with two seeds: the file has both, and each verdict follows from its numbers."""

import pytest
import results_page
import seeds
from paper import paper, verdicts
from paper.experiments import by_key
from paper.run import run_experiment, shortened


def test_both_seeds_have_the_same_pairs_and_other_numbers():
    first, second = (
        [x for x in seeds.read() if x.seed == seed] for seed in seeds.SEEDS
    )
    assert [x[1:5] for x in first] == [x[1:5] for x in second] and len(first) > 30
    assert all(a.gain != b.gain for a, b in zip(first, second, strict=True))


def test_a_verdict_follows_from_its_numbers():
    for row in seeds.read():
        (its,) = (
            pair
            for pair in paper.TUKEY[row.task]
            if (pair.better, pair.worse) == (row.better, row.worse)
        )
        assert verdicts.verdict(row.gain, row.p, its.p).name == row.verdict


def test_the_page_counts_the_verdicts_that_stay():
    counts = results_page.counts_of_seeds()
    by_pair = {}
    for row in seeds.read():
        by_pair.setdefault(row[1:5], set()).add(row.verdict)
    stay = [place[0] for place, its in by_pair.items() if len(its) == 1]
    assert counts["stay in all"] == f"{len(stay)} of {len(by_pair)}"
    arms = [place for place in by_pair if place[0] in ("arm_1k", "arm_4k")]
    assert (
        counts["stay in arms"]
        == f"{sum('arm' in task for task in stay)} of {len(arms)}"
    )


@pytest.mark.long
def test_a_seed_is_what_the_comparison_is_given(tmp_path):
    experiment = by_key("robot_wander_simple")
    rows = [x for x in seeds.read() if x.seed == 1 and x.task == "wander_simple"]
    result = run_experiment(experiment, False, tmp_path, "kinematic", 1)
    length = experiment.lengths[-1]
    means = {label: x.mean() for label, x in shortened(result, length).final.items()}
    for row in rows:
        if row.length == str(length):
            assert means[row.better] - means[row.worse] == pytest.approx(
                row.gain, abs=1e-4
            )
