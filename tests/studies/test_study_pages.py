"""What the pages of the studies say: as their scripts would write it, and as the tables and data beside it."""

import json
import re

import better_bias
import better_bias_page
import better_bias_worlds
import blind_study
import intervals
import kinematic_arm
import numpy as np
import planning
import planning_figure
import pytest
import transfer
import vrep_comparison
from scipy import stats
from test_headlines import ROOT, tells, words

from rlrobot_edu.robots.arm.arm_body import joints

DOCS = ROOT / "docs"


@pytest.mark.parametrize(
    ("page", "template"),
    [
        ("planning.md", planning.PAGE), ("transfer.md", transfer.PAGE),
        ("kinematic_arm.md", kinematic_arm.PAGE), ("kinematic_arm.md", kinematic_arm.TEXT),
        ("kinematic_arm.md", kinematic_arm.CHOICE), ("kinematic_arm.md", kinematic_arm.ENDS),
        ("vrep_comparison.md", vrep_comparison.PAGE), ("blind.md", blind_study.PAGE),
        ("intervals.md", intervals.PAGE),
    ],
)  # fmt: skip
def test_a_page_says_what_its_script_would_write(page, template):
    text = words((DOCS / "studies" / page).read_text(encoding="utf-8"))
    assert [
        part for part in re.split(r"\{[^{}]*\}", template) if words(part) not in text
    ] == []


@pytest.mark.long
def test_the_intervals_hold_the_mean_as_often_as_their_page_says():
    name = "arm_1k, robot, 30 episodes, Q+SR"
    population = intervals.populations()[name]
    found = [intervals.coverage(name, population, n) for n in intervals.SIZES]
    row = " | ".join(map(str, intervals.worst(found).rows[0][2:]))
    text = (DOCS / "studies/intervals.md").read_text(encoding="utf-8")
    assert f"| {row} |" in text


def test_the_intervals_of_a_bell_curve_hold_its_mean():
    population = np.random.default_rng(0).normal(3.0, 2.0, 2000)
    held = intervals.coverage("bell curve", population, 30).held
    assert all(0.9 < share < 0.98 for share in held.values())


def test_the_intervals_of_equal_numbers_are_that_number():
    found = intervals.coverage("one number", np.full(20, 0.1), 5)
    assert set(found.held.values()) == {1.0}


INDEX = (DOCS / "studies/index.md").read_text(encoding="utf-8")


def test_the_index_has_every_study():
    pages = {path.name for path in (DOCS / "studies").glob("*.md")} - {"index.md"}
    assert set(re.findall(r"^\| \[.*?\]\((\w+\.md)\)", INDEX, re.M)) == pages


@pytest.mark.parametrize(
    "page, verdict", re.findall(r"^\| \[.*?\]\((\w+\.md)\).* \| (.*) \|$", INDEX, re.M)
)
def test_a_verdict_of_the_index_has_its_numbers_from_its_page(page, verdict):
    text = (DOCS / "studies" / page).read_text(encoding="utf-8")
    numbers = re.findall(r"[-−+]?\d+\.\d+", verdict)
    assert [number for number in numbers if number not in text] == []


def test_the_page_of_the_blind_robot_is_what_its_numbers_say():
    found = json.loads((ROOT / "studies/blind.json").read_text(encoding="utf-8"))
    assert (DOCS / "studies" / "blind.md").read_text(
        encoding="utf-8"
    ) == blind_study.page(found)


def test_the_registered_page_is_what_its_numbers_say():
    found = json.loads((ROOT / "studies/better_bias.json").read_text(encoding="utf-8"))
    assert (DOCS / "studies" / "a_better_bias.md").read_text(
        encoding="utf-8"
    ) == better_bias_page.page(found)
    assert {name: {label: len(values) for label, values in its.items() if ", T = " not in label or "tuning" in label}
            for name, its in found.items()} == {
        name: {label: better_bias.repetitions(name, label) for label in better_bias.first_labels(name)}
        for name in better_bias_worlds.worlds()
    }  # fmt: skip


def plans() -> dict[tuple[int, str, str, str], tuple[float, float, float, str]]:
    """Of planning.md, by steps, world, method and planner: mean with and without, p (0 for < 0.001), bold or italic."""
    text = (DOCS / "studies" / "planning.md").read_text(encoding="utf-8")
    return {
        (gain.steps, gain.world, gain.method, gain.planner): (gain.mean, gain.without, gain.p, gain.stars)
        for gain in planning_figure.gains_of(text)
    }  # fmt: skip


def test_the_figure_of_planning_counts_what_its_page_marks():
    text = (DOCS / "studies" / "planning.md").read_text(encoding="utf-8")
    gains = planning_figure.gains_of(text)
    marked = {
        stars: sum(gain.stars == stars for gain in gains) for stars in ("**", "*")
    }
    title = planning_figure.title_of(gains)
    assert f"helps significantly in {marked['**']} of {len(gains)} cases" in title
    assert f"harms in {marked['*']}" in title and title in text
    worse = [gain._replace(mean=gain.without - 1, p=0.01) for gain in gains]
    assert f"harms in {len(gains)}" in planning_figure.title_of(worse)


def test_what_planning_calls_better_or_worse_is_so_and_what_is_not_shown_is_not():
    found = plans()
    assert tells("docs/studies/planning.md", len(found))
    for mean, base, p, style in found.values():
        assert style == ("" if p >= 0.05 else "**" if mean > base else "*")

    def style(steps, world, method, planner="sweeping"):
        return found[steps, world, method, planner][3]

    nav, giraff, one, arm = (
        f"{name}, model"
        for name in ("navigation_1k", "giraff_wander_1k", "wander_1k", "arm_1k")
    )
    robot, simple = "wander_1k, robot", "wander_simple, model"
    better = {
        (n, nav, f"Q+{x}", "sweeping") for n in (300, 3600) for x in ("SR", "QBIASSR")
    }
    better |= {(3600, nav, "Q+QBIASSR", "dyna"), (3600, giraff, "Q+EG", "sweeping")}
    assert {key for key in found if key[1] in (nav, giraff) and found[key][3]} == better
    assert {found[key][3] for key in better} == {"**"} and not any(
        found[key][3] for key in found if key[1] == one
    )
    assert {
        key: its[3] for key, its in found.items() if key[1] == robot and its[3]
    } == {(3600, robot, "Q+SR", "sweeping"): "*"}
    p = found[3600, robot, "Q+EG", "dyna"][2]
    assert (
        tells("docs/studies/planning.md", p)
        and p <= found[3600, robot, "Q+EG", "sweeping"][2]
    )
    ends = [found[3600, arm, "Q+SR", planner] for planner in ("dyna", "sweeping")]
    assert tells("docs/studies/planning.md", ends[0][1], *(mean for mean, *_ in ends))
    assert [end[3] for end in ends] == ["*", "*"]
    loss = 1.9  # as the page says
    losses = [
        found[3600, simple, f"{x}+QBIASSR", y]
        for x in ("Q", "TOSL")
        for y in ("dyna", "sweeping")
    ]
    assert all(base - mean > loss and mark == "*" for mean, base, _, mark in losses)
    assert all(
        style(3600, arm, "Q+EG", planner) == "**" for planner in ("dyna", "sweeping")
    )
    assert not any(its[3] == "*" for key, its in found.items() if key[2] == "Q+EG")


def test_what_transfer_calls_significant_is_so_by_the_limit_of_its_page():
    text = (DOCS / "studies" / "transfer.md").read_text(encoding="utf-8")
    limit, tests = map(float, re.search(r"p <\s([\d.]+) / (\d+)", text).groups())
    called = re.findall(r"p [=<] ([\d.]+)( \(significant\))?; better in", text)
    assert len(called) == tests
    assert all((float(p) < limit / tests) == bool(mark) for p, mark in called)
    rows = text[
        text.index("**Pioneer to Giraff**") : text.index("**wander_1k to wander_4k**")
    ].splitlines()
    plain, halved = (
        next(row for row in rows if row.startswith(f"| {way} |"))
        for way in transfer.WAYS[1:3]
    )
    significant = [
        ["(significant)" in cell for cell in row.split("|")[2:6]]
        for row in (plain, halved)
    ]
    assert significant == [
        [False, True, True, False],
        [False, False, True, True],
    ]  # as the page sums them up


def test_a_page_tells_the_limits_of_the_arms_joints():
    limits = [joints()[name].limits for name in ("arm", "biceps", "forearm")]
    assert tells(
        "docs/studies/kinematic_arm.md", *(angle for pair in limits for angle in pair)
    )


def test_no_difference_between_the_arms_engines_is_significant():
    text = (DOCS / "studies" / "kinematic_arm.md").read_text(encoding="utf-8")
    p = [
        float(x)
        for x in re.findall(
            r"^\| `arm_\dk` \| [\w+]+ \| .* \| ([\d.]+) \|$", text, re.M
        )
    ]
    assert len(p) == 4 and min(p) >= 0.05


def test_what_the_study_of_networks_says_of_goals_is_what_its_runs_show():
    runs = json.loads((ROOT / "studies/baselines.json").read_text(encoding="utf-8"))[
        "runs"
    ]["navigation_1k"]
    goals = {label: [run["goals"] for run in its] for label, its in runs.items()}

    def p(one, other):
        return stats.ttest_ind(goals[one], goals[other], equal_var=False).pvalue

    told = round(p("DQN, as it comes", "Q+RANDOM"), 2)
    assert told < 0.05 and tells("docs/studies/baselines.md", told)
    assert np.mean(goals["DQN, as it comes"]) < np.mean(goals["Q+RANDOM"])
    assert max(goals, key=lambda label: np.mean(goals[label])) == "DQN, fitted"
    assert (
        min(
            p("DQN, fitted", other)
            for other in ("PPO, fitted", "DQN, fitted, sees readings")
        )
        >= 0.05
    )
