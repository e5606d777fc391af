"""The page of results is what its template and the data say; its counts are so; one reads it in five minutes."""

import re

import pytest
import results_page
from paper import paper, tally
from paper.experiments import EXPERIMENTS
from paper.outcome import Outcome, read_outcomes
from test_headlines import CONSTANTS, DOCS, RESULTS, prose

QBIASSR, SR, Q = paper.THREE
OURS, PROGRAMS = results_page.OURS, results_page.PROGRAMS


@pytest.fixture(scope="module")
def outcomes() -> dict[str, Outcome]:
    return read_outcomes(DOCS / "reproduction/averages.csv", EXPERIMENTS)


def test_the_page_is_what_its_template_and_the_data_say():
    assert results_page.PAGE.read_text(encoding="utf-8") == results_page.page()


def test_no_result_is_typed_into_the_template():
    """A result is a number with two decimals or more, a mean with its interval, or a p."""
    template = results_page.TEMPLATE.read_text(encoding="utf-8")
    typed = results_page.NAME.sub("", results_page.NOTE.sub("", template))
    assert set(re.findall(r"\d+\.\d\d+|± ?\d[\d.]*|p = [\d.]+", typed)) <= CONSTANTS


def test_the_page_reads_in_five_minutes():
    """Of 240 words each; the tables are looked at, not read."""
    text = [line for line in prose(RESULTS).splitlines() if line[:1] not in ("|", "!")]
    assert len(" ".join(text).split()) < 5 * 240


def test_a_name_that_means_nothing_is_refused(outcomes):
    for name in (
        "robot_wander_1k: TOSL",
        "robot_moon: Q+SR",
        "paper arm_1k: Q+SR - TOSL+SR",
    ):
        with pytest.raises((KeyError, StopIteration, ValueError)):
            results_page.number(outcomes, name)


def test_a_number_is_the_mean_the_difference_or_its_p(outcomes):
    outcome = outcomes["robot_arm_1k"]
    final = outcome.final[outcome.longest]
    first, second = final[SR], final[Q]
    place = f"robot_arm_1k, {outcome.longest}"
    assert results_page.number(outcomes, f"{place}: {Q}").startswith(
        f"{second.mean():.2f} ± "
    )
    gain = results_page.number(outcomes, f"robot_arm_1k: {SR} - {Q}")
    assert gain == f"−{second.mean() - first.mean():.2f}"
    p = results_page.number(outcomes, f"p robot_arm_1k: {SR} - {Q}")
    assert float(p) == pytest.approx(outcome.pair(SR, Q)[1], rel=0.05)


def test_the_text_says_of_the_giraff_what_the_marks_say(outcomes):
    pair = "giraff_wander_1k", f"{QBIASSR} over {SR}"
    marks = {
        (rule, test): results_page.marks(outcomes, rule, test)[pair]
        for rule in (OURS, PROGRAMS)
        for test in results_page.TESTS
    }
    assert marks == {
        (OURS, "Tukey"): "~", (OURS, "Games-Howell"): "✔",
        (PROGRAMS, "Tukey"): "✘", (PROGRAMS, "Games-Howell"): "✘",
    }  # fmt: skip
    changed = outcomes["cause_evasion_giraff_wander_1k"]
    assert changed.pair(SR, QBIASSR)[0] > 0 and changed.pair(SR, QBIASSR)[1] < 0.05


def test_the_program_s_rule_was_run_where_the_text_says(outcomes):
    run = {task for task in paper.TUKEY if f"cause_evasion_{task}" in outcomes}
    significant = {
        task for task, pairs in paper.TUKEY.items() if any(x.p < 0.05 for x in pairs)
    }
    assert significant - run == {"arm_1k", "arm_4k"}


def test_what_the_paper_prints_is_not_what_follows_from_it():
    slips = results_page.slips()
    assert slips["slip q right"] != slips["slip q printed"]
    assert float(slips["slip F right"]) != float(slips["slip F printed"])
    simple = paper.TUKEY["wander_simple"]
    assert simple[0].better == SR and simple[0].q + simple[2].q == pytest.approx(
        simple[1].q
    )


def test_the_text_names_the_other_pairs_that_are_significant(outcomes):
    found = {test: set() for test in results_page.TESTS}
    for task, pairs in paper.TUKEY.items():
        outcome = outcomes[f"robot_{task}"]
        for pair in pairs:
            for length in outcome.final:
                ours = outcome.tested(pair.better, pair.worse, length)
                for test, p in {
                    "Tukey": ours.p,
                    "Games-Howell": ours.games_howell,
                }.items():
                    if pair.p >= 0.05 > p:
                        gain, _ = outcome.pair(pair.better, pair.worse, length)
                        found[test].add((task, str(length), pair.name, gain > 0))
    simple, ahead, nav = f"{SR} over {QBIASSR}", f"{SR} over {Q}", "navigation_1k"
    by_tukey = {
        ("wander_simple", "60 steps", simple, True),
        ("wander_4k", "3600 steps", ahead, True),
    } | {
        (nav, f"{n} episodes", f"{x} over {Q}", True) for n in (5, 10) for x in (SR, QBIASSR)
    }  # fmt: skip
    assert found["Tukey"] == by_tukey
    assert found["Games-Howell"] - by_tukey == {
        ("wander_simple", "300 steps", simple, True),
        (nav, "1 episode", f"{QBIASSR} over {SR}", True),
    }
    assert by_tukey <= found["Games-Howell"]


def test_the_lead_that_holm_takes_away_is_named(outcomes):
    lost = tally.lost_by_holm(outcomes)
    assert ("wander_1k", "3600 steps", f"{QBIASSR} over {Q}") in lost
    assert not [pair for task, _, pair in lost if task == "wander_4k"]
