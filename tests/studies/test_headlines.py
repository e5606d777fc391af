"""What the pages of results and the lessons say of the reproduction: their numbers are compared with the data."""

import csv
import json
import re
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from in_markdown import in_markdown
from made_blocks import BLOCK
from paper import paper, tables, tally, verdicts
from paper.experiments import EXPERIMENTS, PRELIMINARIES, Length
from paper.outcome import Outcome, detectable, read_outcomes, shuttles
from paper.verdicts import AGREES, LEVEL, REVERSED, UNDECIDED

import rlrobot_edu as rl
from rlrobot_course.authoring.lists import lessons

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
RESULTS, REPORT = "docs/results.md", "docs/reproduction/README.md"
QBIASSR, SR, Q = paper.THREE
NUMBER = re.compile(
    r"(?<![\w.])[-−+]?\d+(?:\.\d+)?(?!\w)"
)  # not the digits of a name as wander_1k
COMMENT = re.compile(r"<!--.*?-->", re.S)


def words(text: str) -> str:
    """The text with one blank wherever there is white space."""
    return " ".join(text.split())


def prose(page: str) -> str:
    """What a page says; of a notebook, its cells of text; of the report, what people wrote."""
    text = (ROOT / page).read_text(encoding="utf-8")
    if not page.endswith(".ipynb"):
        return COMMENT.sub("", BLOCK.sub("", text))
    return "\n".join(
        "".join(cell["source"])
        for cell in json.loads(text)["cells"]
        if cell["cell_type"] == "markdown"
    )


def tells(page: str, *numbers: float) -> bool:
    """Whether these numbers follow one another somewhere in what a page says, with no other number between them."""
    found = [float(number.replace("−", "-")) for number in NUMBER.findall(prose(page))]
    return any(found[i : i + len(numbers)] == list(numbers) for i in range(len(found)))


@pytest.fixture(scope="module")
def outcomes() -> dict[str, Outcome]:
    return read_outcomes(DOCS / "reproduction/averages.csv", EXPERIMENTS)


def test_the_reports_tables_follow_from_the_averages_beside_it(outcomes):
    made = tables.tables(outcomes)
    costs = json.loads((DOCS / "reproduction/environment.json").read_text())[
        "seconds a step"
    ]
    made["costs"] = in_markdown(tables.cost_table(costs))
    page = (ROOT / REPORT).read_text(encoding="utf-8")
    blocks = {found[1]: found[0] for found in BLOCK.finditer(page)}
    assert [
        name for name, table in made.items() if table not in blocks.get(name, "")
    ] == []


def test_the_report_is_no_longer_than_one_reads():
    assert len(prose(REPORT).split()) < 3000  # beside its tables


MARKED = re.compile(r"([-−+]?\d+(?:\.\d+)?)(?: ± (\d+\.\d+))?<!--= (.+?) -->")
# the level, what counts as near to a shuttle, the speed of our arm; detectable in SDs; of the benchmarks
CONSTANTS = {"0.05", "0.25", "0.14", "0.83", "0.07", "0.08", "0.17"}


def marked(outcomes: dict[str, Outcome], mark: str) -> tuple[float, float | None]:
    """The number that a mark names, and half of its interval if it has one.

    "key: A" is a mean, "key: A - B" a difference of means, "p key: A - B" its p by Tukey, "gh key: A - B" by Games and
    Howell, "detectable key: A - B" the smallest that Tukey's test would find; "paper task: A - B" is the paper's
    difference. A length may follow the key after a comma; without one it is the longest.
    """
    place, what = mark.split(": ")
    kind = re.match("(p|gh|detectable|paper) |", place)[1]
    first, _, second = what.partition(" - ")
    if kind == "paper":
        task = place.removeprefix("paper ")
        (its,) = (
            pair
            for pair in paper.TUKEY[task]
            if {pair.better, pair.worse} == {first, second}
        )
        return paper.difference(task, its) * (1 if its.better == first else -1), None
    key, _, length = place.removeprefix(f"{kind} ").partition(", ")
    outcome = outcomes[key]
    length = (
        next((n for n in outcome.final if str(n) == length), None)
        if length
        else outcome.longest
    )
    if not second:
        mean, half = tables.mean_and_half(outcome.final[length][first]).split(" ± ")
        return float(mean), float(half)
    if kind == "detectable":
        return detectable(outcome.final[length]), None
    ours = outcome.tested(first, second, length)
    if kind == "gh":
        return ours.games_howell, None
    return ours.p if kind == "p" else outcome.pair(first, second, length)[0], None


def test_a_marked_number_is_what_its_mark_names(outcomes):
    found = MARKED.findall(words((ROOT / REPORT).read_text(encoding="utf-8")))
    assert len(found) > 30
    for number, half, mark in found:
        value, width = marked(outcomes, mark)
        digits = len(number.partition(".")[2])
        assert float(number.replace("−", "-")) == pytest.approx(
            value, abs=0.5001 * 10.0**-digits
        ), mark
        assert not half or float(half) == width, mark


def test_every_result_in_the_text_has_a_mark():
    """A result is a number with two decimals or more, a mean with its interval, or a p."""
    text = MARKED.sub(
        "", words(BLOCK.sub("", (ROOT / REPORT).read_text(encoding="utf-8")))
    )
    text = re.sub(r"!\[[^\]]*\]", "", text)  # a picture's text has a test of its own
    assert (
        set(re.findall(r"\d+\.\d\d+|± ?\d[\d.]*|p = [\d.]+", text)) - CONSTANTS == set()
    )


def verdicts_on_pairs(outcomes):
    """The verdicts on each pair that the paper tests, one for each length; by task and pair."""
    found = defaultdict(list)
    for key, outcome in outcomes.items():
        if key.startswith("robot_"):
            for length in outcome.final:
                for one in outcome.judged(length):
                    found[outcome.experiment.task, one.pair].append(one.verdict)
    return found


def test_the_report_counts_the_papers_pairs_as_several_tests_do(outcomes):
    rows = tally.tally_table(outcomes).rows
    counts = {(row[0], row[1]): row[2:6] for row in rows}
    ours = [counts["SR and QBIASSR", test] for test in list(tally.TESTS)]
    assert ours[0] != ours[1] and ours[2] == ours[3]
    assert tells(REPORT, 14, 21, *ours[0], *ours[1], *ours[2])
    looks = tally.looks(outcomes)
    significant = [look for look in looks if look[2].p < LEVEL]
    lost = tally.lost_by_holm(outcomes)
    assert tells(REPORT, len(looks), len(significant), len(significant) - len(lost))
    assert all(
        len(its) == 57 for its in (looks, tally.looks(outcomes, ["cause_evasion"]))
    )
    # those of which the text says so, and arm_4k after one episode, on which the tests disagree
    assert lost == {
        ("wander_1k", "3600 steps", f"{QBIASSR} over {Q}"),
        ("arm_1k", "3 episodes", f"{QBIASSR} over {Q}"),
        ("arm_1k", "3 episodes", f"{SR} over {Q}"),
        ("arm_4k", "1 episode", f"{SR} over {Q}"),
        ("arm_4k", "30 episodes", f"{QBIASSR} over {Q}"),
        ("navigation_1k", "5 episodes", f"{SR} over {Q}"),
        ("navigation_1k", "10 episodes", f"{SR} over {Q}"),
    }


def test_the_report_names_each_look_on_which_the_two_tests_disagree(outcomes):
    apart = [
        (task, length, judged.pair.name)
        for task, length, judged in tally.looks(outcomes)
        if judged.ours.tests_disagree
    ]
    assert apart == [
        ("wander_simple", "300 steps", f"{SR} over {QBIASSR}"),
        ("arm_4k", "1 episode", f"{SR} over {Q}"),
        ("arm_4k", "30 episodes", f"{SR} over {Q}"),
        ("navigation_1k", "1 episode", f"{QBIASSR} over {SR}"),
        ("giraff_wander_1k", "1800 steps", f"{QBIASSR} over {SR}"),
    ]


def test_not_significant_stands_beside_what_so_many_robots_would_have_shown():
    results = prose(REPORT).partition("## The count")[2]
    said = re.compile("not (differ )?significant|no (difference|value|pair) is signif")
    parts = [words(part) for part in re.split(r"\n\n|\n- ", results)]
    unshown = [part for part in parts if said.search(part)]
    assert len(unshown) > 10
    for part in unshown:
        assert "detectable" in part or "(see above)" in part, part


def test_the_order_of_costs_is_no_more_than_the_benchmarks_say():
    page = (ROOT / "studies/benchmarks/README.md").read_text(encoding="utf-8")
    row = re.search(r"^\| a step on the wander_1k model, compiled.*$", page, re.M)[0]
    times = dict(re.findall(r"([\w+]+SR) (\d\.\d+)", row))
    plain_ones = {float(times[name]) for name in (SR, Q, "SL+SR", "SARSA+SR")}
    assert plain_ones == {0.07, 0.08}
    assert tells(REPORT, 0.07, 0.08, float(times[QBIASSR]))


def test_the_results_page_says_which_of_the_other_pairs_are_significant_here(outcomes):
    rest = {
        (task, pair.name): {v.name for v in its}
        for (task, pair), its in verdicts_on_pairs(outcomes).items() if pair.p >= LEVEL
    }  # fmt: skip
    assert len(rest) == 7
    shown = {name for name, its in rest.items() if its != {UNDECIDED}}
    assert shown == {("wander_simple", f"{SR} over {QBIASSR}"), ("wander_4k", f"{SR} over {Q}"),
                     *(("navigation_1k", f"{x} over {Q}") for x in (QBIASSR, SR))}  # fmt: skip
    assert significant(outcomes["robot_navigation_1k"], QBIASSR, Q) == [
        "5 episodes",
        "10 episodes",
    ]
    assert significant(outcomes["robot_navigation_1k"], SR, Q) == [
        "5 episodes",
        "10 episodes",
    ]


def significant(outcome: Outcome, better: str, worse: str) -> list[str]:
    """The lengths at which the first of two methods is significantly ahead."""
    tested = {
        str(length): outcome.pair(better, worse, length) for length in outcome.final
    }
    return [length for length, (gain, p) in tested.items() if gain > 0 and p < LEVEL]


def test_the_pages_say_who_is_ahead_where_the_tests_do(outcomes):
    for key in (
        "robot_wander_1k",
        "robot_wander_4k",
        "cause_walls_wander_1k",
        "cause_walls_wander_4k",
    ):
        assert all(significant(outcomes[key], QBIASSR, other) for other in (SR, Q))
    assert significant(outcomes["robot_wander_simple"], SR, QBIASSR) == ["60 steps"]
    assert significant(outcomes["robot_wander_simple"], QBIASSR, Q) == ["300 steps"]
    late = ["3 episodes", "10 episodes", "30 episodes"]
    assert (
        significant(outcomes["robot_arm_1k"], Q, QBIASSR)
        == late
        == significant(outcomes["robot_arm_1k"], Q, SR)
    )
    assert all(outcomes["robot_arm_1k"].pair(x, Q, n)[0] > 0 for x in (QBIASSR, SR)
               for n in list(outcomes["robot_arm_1k"].final)[:2])  # fmt: skip
    arm = outcomes["robot_arm_4k"]
    assert (
        significant(arm, QBIASSR, Q) == ["3 episodes", "10 episodes"]
        and significant(arm, Q, SR) == []
    )
    assert significant(arm, SR, Q) == ["1 episode", "10 episodes"] and significant(
        arm, Q, QBIASSR
    ) == ["30 episodes"]
    for task in ("giraff_wander_simple", "giraff_wander_4k"):
        assert all(
            pair.p >= LEVEL
            for its in outcomes[f"robot_{task}"].pairs.values()
            for pair in its
        )
    nav = outcomes["robot_navigation_1k"]
    for length in list(nav.final)[1:]:
        assert nav.means(length)[QBIASSR] > nav.means(length)[SR] > nav.means(length)[Q]


def test_walls_and_the_programs_fault_bring_the_papers_order_back_and_lucky_rows_do_not(
    outcomes,
):
    for key in (
        "robot_wander_1k",
        "model_wander_1k",
        "cause_lag_wander_1k",
        "cause_evasion_wander_1k",
    ):
        assert significant(outcomes[key], Q, SR)
    assert {one.verdict.name for one in outcomes["cause_walls_wander_1k"].judged()} == {
        AGREES
    }
    assert significant(outcomes["cause_friction_wander_1k"], SR, Q)
    assert significant(outcomes["cause_fault"], SR, "Q+SR with the fault")
    ahead = {
        cut: bool(significant(outcomes[f"cause_loops_{cut}"], Q, SR))
        for cut in ("uniform", "siblings", "stay")
    }
    assert ahead == {"uniform": False, "siblings": True, "stay": True}
    assert all(
        significant(outcomes[f"cause_recording_{seed}"], Q, SR) for seed in (1, 2, 3)
    )
    about = rl.SampleModel.from_recording(rl.read_recording("wander_1k")).diagnose()
    seen_once = round(100 * about.pairs_seen_once / about.pairs_seen)
    assert tells(
        REPORT, seen_once, round(100 * paper.SEEN_ONCE_IN_VREP), len(about.loops)
    )


def test_the_pages_count_the_arms_pairs_that_turn_round_and_the_arms_that_shuttle(
    outcomes,
):
    for kind in ("contact", "traces"):
        bad = signs = turned = 0
        for arm in ("arm_1k", "arm_4k"):
            for length in outcomes[f"robot_{arm}"].final:
                both = (
                    outcomes[f"{name}_{arm}"].judged(length)
                    for name in ("robot", f"cause_{kind}")
                )
                for before, after in zip(*both, strict=True):
                    if before.verdict.is_opposite:
                        bad += 1
                        signs += not after.verdict.is_opposite
                        turned += after.gain > 0 and after.p < LEVEL
        assert (
            tells(REPORT, bad, 7, 4, 3, 0)
            and (signs, turned) == {"contact": (7, 4), "traces": (3, 0)}[kind]
        )
    assert tells(RESULTS, 7, 8, 4)
    final = outcomes["robot_arm_1k"].final[outcomes["robot_arm_1k"].longest]
    assert tells(
        REPORT, 30, *(round(100 * shuttles(final[x])) for x in (SR, QBIASSR)), 0.25
    )
    assert shuttles(final[Q]) == 0
    contact, traces = (
        outcomes[f"cause_{kind}_arm_1k"] for kind in ("contact", "traces")
    )
    assert significant(contact, QBIASSR, Q) == [
        "60 steps",
        "3 episodes",
    ] and significant(contact, SR, Q)
    assert all(
        significant(traces, x, QBIASSR) == ["10 episodes", "30 episodes"]
        for x in (SR, Q)
    )


def test_the_report_says_which_verdicts_depend_on_loop_evasion(outcomes):
    same, other = 0, set()
    for key, changed in outcomes.items():
        task = changed.experiment.task
        if key.startswith("cause_evasion_"):
            for length in changed.final:
                for ours, its in zip(
                    outcomes[f"robot_{task}"].judged(length),
                    changed.judged(length),
                    strict=True,
                ):
                    same += ours.verdict.name == its.verdict.name
                    if ours.verdict.name != its.verdict.name:
                        other.add((task, its.pair.name, its.verdict.name))
    assert other == {("giraff_wander_1k", f"{QBIASSR} over {SR}", REVERSED),
                     ("giraff_wander_1k", f"{QBIASSR} over {Q}", verdicts.OPPOSITE)}  # fmt: skip
    assert tells(REPORT, same + len(other), same)


def test_the_report_counts_what_models_do_as_the_averages_do(outcomes):
    models = {key: o for key, o in outcomes.items() if key.startswith("model_")}
    ahead = [key for key, o in models.items() if o.pair(QBIASSR, SR)[0] > 0]
    assert ahead == ["model_wander_1k"] and significant(
        models["model_wander_1k"], QBIASSR, SR
    )
    assert significant(models["model_wander_simple"], SR, QBIASSR) == [
        "60 steps",
        "300 steps",
    ]
    assert significant(models["model_navigation_1k"], SR, QBIASSR) == ["10 episodes"]
    worse = [(label, mean < outcomes[key.replace("model", "robot")].means(length)[label])
             for key, o in models.items() for length in o.final for label, mean in o.means(length).items()]  # fmt: skip
    q = [x for label, x in worse if label == Q]
    assert tells(REPORT, sum(x for _, x in worse), len(worse), sum(q), len(q))


def test_the_report_says_of_the_preliminary_tests_what_they_show(outcomes):
    values = {key: outcomes[f"preliminary_{key}"].value()[:2] for key in (
        "lambda", "lambda_robot", "alpha", "alpha_robot", "gamma", "gamma_robot", "gamma_alone", "gamma_alone_robot",
        "temperature", "temperature_robot")}  # fmt: skip
    assert values == {
        "lambda": (verdicts.AS_GOOD, "λ = 0.7"), "lambda_robot": (verdicts.BEATEN, "λ = 0.5"),
        "alpha": (verdicts.BEATEN, "α = 0.5"), "alpha_robot": (verdicts.AS_GOOD, "α = 0.3"),
        "gamma": (verdicts.BEATEN, "γ = 0.5"), "gamma_robot": (verdicts.BEATEN, "γ = 0.5"),
        "gamma_alone": (verdicts.BEST, "γ = 0.9"), "gamma_alone_robot": (verdicts.BEATEN, "γ = 0.8"),
        "temperature": (verdicts.BEATEN, "T = 0.3"), "temperature_robot": (verdicts.BEST, "T = 1"),
    }  # fmt: skip
    walls = {key: outcomes[f"cause_walls_{key}"].value()[:2] for key in (
        "lambda", "lambda_qbiassr", "alpha", "gamma", "temperature")}  # fmt: skip
    assert walls == {
        "lambda": (verdicts.AS_GOOD, "λ = 0.7"), "lambda_qbiassr": (verdicts.AS_GOOD, "λ = 0.7"),
        "alpha": (verdicts.BEATEN, "α = 0.3"), "gamma": (verdicts.BEATEN, "γ = 0.5"),
        "temperature": (verdicts.BEST, "T = 1"),
    }  # fmt: skip
    for key in ("lambda", "lambda_qbiassr"):
        assert significant(outcomes[f"cause_walls_{key}"], "λ = 0.9", "λ = 0")
        assert {
            len(x) for x in outcomes[f"cause_walls_{key}"].final[Length(3600)].values()
        } == {12}
    for key, better, worse in (
        ("preliminary_algorithms", "Q+SR", "SL+SR SARSA+SR"), ("preliminary_algorithms_robot", "Q+SR SARSA+SR", ""),
        ("cause_walls_algorithms", "", "Q+SR SARSA+SR"),
        ("preliminary_exploration", "", "TOSL+EG"), ("preliminary_exploration_robot", "", "TOSL+EG"),
    ):  # fmt: skip
        others = [label for label in outcomes[key].experiment.methods if label != SR]
        assert {x for x in others if significant(outcomes[key], x, SR)} == set(
            better.split()
        ), key
        assert {x for x in others if significant(outcomes[key], SR, x)} == set(
            worse.split()
        ), key
    assert len(PRELIMINARIES) == 7


def test_the_report_says_how_many_pairs_few_repetitions_would_miss(outcomes):
    rows = tables.few_table(outcomes).rows
    shares = [(task, int(share.rstrip("%"))) for task, *_, share in rows]
    assert (
        len(rows) == 5
        and [task for task, share in shares if share < 12] == ["navigation_1k"] * 4
    )
    assert [share > 50 for task, share in shares if task == "wander_4k"] == [True]
    *_, reduced, _, full = json.loads(
        (DOCS / "reproduction/environment.json").read_text()
    )["seconds a step"]
    assert 5 < full / reduced < 20  # "about ten times"


def test_the_page_of_differences_says_how_long_the_processes_are(outcomes):
    runs = {
        (task, unit): [
            n.number for n in outcomes[f"robot_{task}"].final if n.unit == unit
        ]
        for task in (
            "wander_simple",
            "giraff_wander_1k",
            "giraff_wander_simple",
            "arm_1k",
            "navigation_1k",
        )
        for unit in ("steps", "episodes")
    }
    (giraff,), (its_small,) = (
        runs["giraff_wander_1k", "steps"],
        runs["giraff_wander_simple", "steps"],
    )
    ends = [
        runs[task, "episodes"][i]
        for task in ("arm_1k", "navigation_1k")
        for i in (0, -1)
    ]
    assert tells(
        "docs/differences.md",
        *runs["wander_simple", "steps"],
        giraff / 60,
        its_small,
        *ends,
    )


def test_the_pages_tell_how_fast_the_arms_turn():
    ours = max(x for output in rl.load_task("arm_1k").outputs for x in output.values)
    assert tells(RESULTS, ours, 1) and tells("docs/differences.md", 1, ours)


PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", *(str(path.relative_to(ROOT)) for path in (
    *sorted(DOCS.glob("*.md")), *sorted(DOCS.glob("howto/*.md")), *sorted(DOCS.glob("studies/*.md")), ROOT / REPORT,
    ROOT / "studies/benchmarks/README.md", ROOT / "datasets/README.md", ROOT / "tasks/README.md"))]  # fmt: skip


@pytest.mark.parametrize("page", PAGES)
def test_every_link_of_a_page_leads_to_what_is_in_the_repository(page):
    """On GitHub, where nothing is there that `make docs` makes."""
    text = re.sub(
        r"^```.*?^```", "", (ROOT / page).read_text(encoding="utf-8"), flags=re.M | re.S
    )
    targets = [
        target
        for target in re.findall(r"\]\(([^)\s]+)\)", text)
        if not re.match(r"https?:|mailto:|#", target)
    ]
    assert [
        target
        for target in targets
        if not ((ROOT / page).parent / target.split("#")[0]).exists()
    ] == []


@pytest.mark.parametrize("lesson, name, form", [
    ("07", "07_eligibility_traces", "{value:.2f} ± {half:.2f}"),
    ("11", "11_wandering_robot", "{value:.2f} ± {half:.2f}"),
    ("11, waits", "11_wandering_robot", "{value:.1f} ± {half:.1f}"),
])  # fmt: skip
def test_lessons_quote_what_was_computed_for_them(lesson, name, form):
    text = (ROOT / "notebooks" / f"{name}.ipynb").read_text(encoding="utf-8")
    rows = computed(lesson)
    for of, row in rows.items():
        assert form.format(value=row[0], half=row[1]) in text, of
    assert rows


def computed(lesson: str) -> dict[str, tuple[float, float]]:
    """What lesson_numbers.csv has for a lesson: value and half interval, by what they are of and the steps."""
    rows = [
        row for row in table("studies/lesson_numbers.csv") if row["lesson"] == lesson
    ]
    return {
        f"{row['of']}, {row['steps']}": (
            float(row["value"]),
            float(row["half_interval"]),
        )
        for row in rows
    }


def table(path: str) -> list[dict[str, str]]:
    """The rows of a CSV file."""
    with open(ROOT / path, encoding="utf-8") as file:
        return [*csv.DictReader(file)]


PLUS_MINUS = re.compile(r"([-−]?\d+\.\d+) ?± ?(\d*\.\d+)")


@pytest.mark.parametrize(
    "lesson", [path.relative_to(ROOT).as_posix() for path in lessons(ROOT).values()]
)
def test_a_mean_with_its_interval_stands_in_an_output_of_its_lesson_or_was_computed_for_one(
    lesson,
):
    """Or it is the difference of two that do."""
    number = Path(lesson).name[:2]
    of_lesson = {
        (row["lesson"][:2], row["value"], row["half_interval"])
        for row in table("studies/lesson_numbers.csv")
    }
    rows = of_lesson | {
        ("", row["mean"], row["half"])
        for row in table("rlrobot_course/play/scoreboard.csv")
    }
    known = {
        (f"{float(x):.{digits}f}", f"{float(half):.{digits}f}")
        for _, x, half in rows
        for digits in (1, 2)
    }
    cells = json.loads((ROOT / lesson).read_text(encoding="utf-8"))["cells"]
    shown = PLUS_MINUS.findall(
        json.dumps([c.get("outputs") for c in cells], ensure_ascii=False).replace(
            "−", "-"
        )
    )
    quoted = set(PLUS_MINUS.findall(prose(lesson).replace("−", "-"))) - set(shown)
    here = [
        *shown,
        *(quoted & known),
        *((x, half) for of, x, half in of_lesson if of == number),
    ]
    values, halves = np.array(here or [(0, 0)], dtype=float).T
    for value, half in quoted - known:
        rounding = 1.1 * 10.0 ** -len(value.partition(".")[2])
        found = np.isclose(values[:, None] - values, float(value), atol=rounding)
        found &= np.isclose(
            np.hypot(halves[:, None], halves), float(half), atol=rounding
        )
        assert found.any(), f"{value} ± {half}"


def test_lessons_count_the_robots_that_were_counted():
    for n in (value for value, _ in computed("11, forward in state 15").values()):
        assert tells("notebooks/11_wandering_robot.ipynb", n, 15)
    arrived = [value for value, _ in computed("12").values()]
    assert tells("notebooks/12_navigation.ipynb", 36, sum(arrived))


def test_readme_says_where_no_difference_to_q_learning_is_shown(outcomes):
    model = outcomes["model_wander_1k"]
    means = model.means()
    p = model.pair(QBIASSR, Q)[1]
    assert tells("README.md", round(means[QBIASSR], 2), round(means[Q], 2), round(p, 2))
    assert {len(x) for final in model.final.values() for x in final.values()} == {1000}
    assert "a thousand agents" in prose("README.md")


def test_lessons_quote_the_report(outcomes):
    wander = "notebooks/11_wandering_robot.ipynb"
    for world in ("robot", "cause_walls"):
        o = outcomes[f"{world}_wander_1k"]
        assert tells(
            wander, *(round(o.means()[label], 2) for label in (Q, SR, QBIASSR))
        )
        assert all(
            o.pair(*pair)[1] < 0.05 for pair in ((Q, SR), (Q, QBIASSR), (SR, QBIASSR))
        )

    final = outcomes["robot_arm_1k"].final
    at = next(n for n in final if n.unit == "episodes" and n.number == 10)
    low = [int((final[at][label] < 3).sum()) for label in (SR, QBIASSR)]
    assert low == [10, 8]  # as lesson 13 has them


@pytest.mark.parametrize("page, heading, lines", [
    ("README.md", "## Ten lines of Python", 10), ("docs/real_robot.md", "## In five lines", 7),  # and its imports
])  # fmt: skip
def test_a_heading_counts_its_lines(page, heading, lines):
    code = re.search(rf"^{heading}$.*?^```python$(.*?)^```$", prose(page), re.M | re.S)[
        1
    ]
    assert len([line for line in code.splitlines() if line]) == lines


def test_the_first_hour_tells_the_minutes_of_the_table_of_lessons():
    table = dict(
        re.findall(
            r"notebooks/(\w+)\.ipynb\).*\| (\d+) \|",
            (ROOT / "docs/lessons.md").read_text(encoding="utf-8"),
        )
    )
    told = re.findall(
        r"notebooks/(\w+)\.ipynb\), (\d+) minutes",
        words(prose("docs/howto/install.md")),
    )
    assert told and all(table[lesson] == minutes for lesson, minutes in told)
