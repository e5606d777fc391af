"""What README and docs say of results is what the files of results say."""

import csv
import re
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import tukey_hsd

ROOT = Path(__file__).parents[1]
PAPERS, SR, Q = "TOSL+QBIASSR", "TOSL+SR", "Q+SR"


def words(path):
    """A page as one line, without its tables' bars and line ends."""
    return " ".join((ROOT / path).read_text(encoding="utf-8").split())


def averages(path, *keys):
    """The final average rewards of a file, by these columns."""
    groups = defaultdict(list)
    with open(ROOT / path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            groups[tuple(row[key] for key in keys)].append(float(row["final_average_reward"]))
    return {key: np.array(values) for key, values in groups.items()}


@pytest.fixture(scope="module")
def report():
    return averages("docs/reproduction/averages.csv", "experiment", "length", "method")


@pytest.fixture(scope="module")
def doubts():
    return averages("docs/doubts.csv", "part", "method")


def three(report, experiment, length="3600 steps"):
    return [report[experiment, length, method] for method in (PAPERS, SR, Q)]


def is_ahead(better, worse, *others):
    """Whether the first group is significantly above the second, by Tukey's test of all of them."""
    return better.mean() > worse.mean() and tukey_hsd(better, worse, *others).pvalue[0, 1] < 0.05


def said(pattern, text, n):
    """The numbers that a sentence of the text says, which must be there."""
    number = r"([+−-]?\d+(?:\.\d+)?)"
    found = re.search(pattern.replace("#", number), text)
    assert found, f"no sentence is like {pattern!r}"
    assert len(found.groups()) == n
    return [float(x.replace("−", "-")) for x in found.groups()]


def test_the_readme_counts_as_the_report_counts():
    counts = said(r"all set-ups in # and in some in # more", words("README.md"), 2)
    told = words("docs/reproduction/README.md")
    assert counts == said(r"in every set-up in # \(.*?\), and in some set-ups in # \(", told, 2)
    assert said(r"of the # pairs of methods", words("README.md"), 1) == said(r"Of the # pairs of methods", told, 1)


def test_the_readmes_differences_and_means_are_those_of_the_averages(report):
    text = words("README.md")
    ours, sr, q = (group.mean() for group in three(report, "cause_walls_wander_1k"))
    assert said(r"the paper's signs: #, # and #,", text, 3) == pytest.approx([ours - sr, ours - q, sr - q], abs=0.005)
    ours, sr, _ = (group.mean() for group in three(report, "robot_wander_simple", "60 steps"))
    assert said(r"ahead of the paper's method \(# against #\)", text, 2) == pytest.approx([sr, ours], abs=0.005)


def test_the_readmes_picture_shows_the_reports_repetitions(report):
    numbers = said(r"TOSL\+QBIASSR ends at #, Q\+SR at #, TOSL\+SR at #\.", words("README.md"), 3)
    ours, sr, q = (group.mean() for group in three(report, "robot_wander_1k"))
    assert numbers == pytest.approx([ours, q, sr], abs=0.005)


def test_what_the_readme_calls_significant_is(report):
    for experiment in ("robot_wander_1k", "robot_wander_4k"):
        ours, sr, q = three(report, experiment)
        assert is_ahead(ours, sr, q) and is_ahead(ours, q, sr)
    ours, sr, q = three(report, "cause_walls_wander_1k")
    assert is_ahead(ours, sr, q) and is_ahead(ours, q, sr) and is_ahead(sr, q, ours)
    ours, sr, q = three(report, "robot_wander_simple", "60 steps")
    assert is_ahead(sr, ours, q)
    for episodes in (3, 10, 30):
        ours, sr, q = three(report, "robot_arm_1k", f"{episodes} episodes")
        assert is_ahead(q, ours, sr) and is_ahead(q, sr, ours)
    ours, sr, q = three(report, "robot_arm_4k", "30 episodes")
    assert q.mean() > max(ours.mean(), sr.mean())
    ours, sr, q = three(report, "robot_wander_1k")
    assert is_ahead(q, sr, ours)


def test_the_doubts_are_what_the_pages_say(doubts):
    blind, sighted = doubts["blind", "SR, blind"], [doubts["blind", s] for s in ("QBIASSR", "VBIASSR", "SR")]
    assert all(is_ahead(blind, group, *sighted) for group in (sighted[0], sighted[2]))
    assert not is_ahead(sighted[1], blind, sighted[0], sighted[2])  # VBIASSR, docs/bias.md
    blind, *sighted = (doubts["blind_1k", s] for s in ("SR, blind", "VBIASSR", "QBIASSR", "SR"))
    assert all(is_ahead(group, blind, *sighted) for group in sighted)
    assert is_ahead(sighted[0], sighted[1], sighted[2], blind)
    ours, sr, sr_without = (doubts["evasion", method] for method in (PAPERS, SR, f"{SR}, no loop evasion"))
    assert is_ahead(ours, sr, sr_without) and is_ahead(sr_without, ours, sr)


@pytest.mark.parametrize("lesson, name, form", [
    ("05", "05_eligibility_traces", "{value:.2f} ± {half:.2f}"),
    ("06", "06_true_online_sarsa", "{value:.1f}"),
    ("07", "07_qbiassr", "{value:.2f} ±{half:.2f}"),
])  # fmt: skip
def test_lessons_quote_what_was_computed_for_them(lesson, name, form):
    text = (ROOT / "notebooks" / f"{name}.ipynb").read_text(encoding="utf-8")
    with open(ROOT / "docs/lesson_numbers.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["lesson"] == lesson]
    for row in rows:
        assert form.format(value=float(row["value"]), half=float(row["half_interval"])) in text, row
    assert rows
