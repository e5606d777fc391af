"""What docs/results.md, the report and lessons say of results: their numbers are compared with the data."""

import csv
import dataclasses
import json
import re
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest
from paper import paper, report
from paper.cause import ahead, of_pairs, opposites
from paper.causes import causes
from paper.experiments import EXPERIMENTS
from paper.outcome import Outcome
from paper.verdicts import AGREES, REVERSED

import rlrobot_edu as rl
from rlrobot_course.authoring.lists import lessons
from rlrobot_edu.experiments.statistics import Tukey

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
QBIASSR, SR, Q = paper.THREE
NUMBER = re.compile(r"(?<![\w.])[-−+]?\d+(?:\.\d+)?(?!\w)")  # not the digits of a name as wander_1k


def words(text: str) -> str:
    """The text with one blank wherever there is white space."""
    return " ".join(text.split())


def prose(page: str) -> str:
    """What a page says; of a notebook, its cells of text."""
    text = (ROOT / page).read_text(encoding="utf-8")
    if not page.endswith(".ipynb"):
        return text
    return "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown")


def tells(page: str, *numbers: float) -> bool:
    """Whether these numbers follow one another somewhere in what a page says, with no other number between them."""
    found = [float(number.replace("−", "-")) for number in NUMBER.findall(prose(page))]
    return any(found[i : i + len(numbers)] == list(numbers) for i in range(len(found)))


@pytest.fixture(scope="module")
def outcomes():
    """What averages.csv holds, as the report's own outcomes."""
    finals = defaultdict(lambda: defaultdict(dict))
    with (DOCS / "reproduction/averages.csv").open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            values = finals[row["experiment"]][row["length"]].setdefault(row["method"], [])
            values.append(float(row["final_average_reward"]))
    made = {}
    for e in EXPERIMENTS:
        final = {n: {label: np.array(x) for label, x in finals[e.key][str(n)].items()} for n in e.lengths}
        made[e.key] = Outcome(e, final, {n: Tukey.of(groups).pairs for n, groups in final.items()}, 0.0)
    model = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    shares = dict.fromkeys((SR, Q), np.zeros(1))  # only the text below the first screen has them
    key = "preliminary_algorithms"
    made[key] = dataclasses.replace(made[key], diagnosis=model.diagnose(), lucky=shares)
    return made


@pytest.fixture(scope="module")
def found_causes(outcomes):
    return causes(outcomes, {})


def test_the_reports_verdicts_follow_from_the_averages_beside_it(outcomes, found_causes):
    page = (DOCS / "reproduction/README.md").read_text(encoding="utf-8")
    short = report.in_short(outcomes, found_causes)
    assert [line for line in short.splitlines() if line not in page] == []
    for table in (report.counts_table(outcomes), report.differences_table(outcomes)):
        assert table.markdown in page


def test_the_results_page_counts_the_pairs_as_the_averages_do(outcomes):
    found = defaultdict(list)
    for outcome, length, _, its in report._tested(outcomes):
        if its.p < 0.05:
            found[outcome.experiment.task, its.name].append(of_pairs(outcome, length)[its.name].name)
    always = sum(set(names) == {AGREES} for names in found.values())
    some = sum(AGREES in names and set(names) != {AGREES} for names in found.values())
    assert tells("docs/results.md", len(found), always, some)


def test_the_results_page_says_who_is_ahead_where_the_tests_do(outcomes):
    for task in ("wander_1k", "wander_4k"):
        o = outcomes[f"robot_{task}"]
        assert all(difference > 0 and p < 0.05 for difference, p in (o.pair(QBIASSR, SR), o.pair(QBIASSR, Q)))
    o = outcomes["robot_wander_simple"]
    gains = {length.number: o.pair(SR, QBIASSR, length) for length in o.final}
    assert all(gain > 0 for gain, _ in gains.values())
    (steps,) = (n for n, (_, p) in gains.items() if p < 0.05)
    assert tells("docs/results.md", steps)
    for key in ("robot_wander_1k", "preliminary_algorithms"):
        gain, p = outcomes[key].pair(Q, SR)
        assert gain > 0 and p < 0.05
    o = outcomes["robot_arm_1k"]
    both = {n: [o.pair(Q, other, n) for other in (QBIASSR, SR)] for n in o.final if n.unit == "episodes"}
    ahead_after = [n.number for n, pairs in both.items() if all(gain > 0 and p < 0.05 for gain, p in pairs)]
    assert len(ahead_after) == 3 and tells("docs/results.md", *ahead_after)


def test_the_readmes_differences_of_wander_1k_are_those_of_the_averages_and_of_the_paper(outcomes):
    held = outcomes["cause_walls_wander_1k"]
    ours = [held.pair(*pair) for pair in ((QBIASSR, SR), (QBIASSR, Q), (SR, Q))]
    theirs = [paper.difference("wander_1k", its) for its in paper.TUKEY["wander_1k"]]
    assert tells("docs/results.md", *(round(x, 2) for x in [*(gain for gain, _ in ours), *theirs]))
    assert all(gain > 0 and p < 0.05 for gain, p in ours)


def test_the_readmes_causes_are_those_of_the_report(outcomes, found_causes):
    bad = signs = significant = 0
    for arm in ("arm_1k", "arm_4k"):
        before, after = outcomes[f"robot_{arm}"], outcomes[f"cause_contact_{arm}"]
        for length in before.final:
            names = opposites(before, length)
            bad += len(names)
            signs += sum(not of_pairs(after, length)[name].is_opposite for name in names)
            significant += len(set(names) & set(ahead(after, length)))
    assert tells("docs/results.md", signs, bad, significant)
    status = {cause.title: cause.status for cause in found_causes}
    assert status["Q-learning on the model: a fault of the paper's program"] == "shown"
    assert status["wander_1k: walls that hold the robot"] == "shown"
    ours, its = (outcomes[f"{kind}_giraff_wander_1k"] for kind in ("robot", "cause_evasion"))
    assert of_pairs(its, its.longest)[f"{QBIASSR} over {SR}"].name == REVERSED
    gain, real = ours.pair(QBIASSR, SR)
    assert gain > 0 and real >= 0.05 and tells("docs/results.md", round(real, 3))


def test_the_page_of_differences_says_how_long_the_processes_are(outcomes):
    runs = {
        (task, unit): [n.number for n in outcomes[f"robot_{task}"].final if n.unit == unit]
        for task in ("wander_simple", "giraff_wander_1k", "giraff_wander_simple", "arm_1k", "navigation_1k")
        for unit in ("steps", "episodes")
    }
    (giraff,), (its_small,) = runs["giraff_wander_1k", "steps"], runs["giraff_wander_simple", "steps"]
    ends = [runs[task, "episodes"][i] for task in ("arm_1k", "navigation_1k") for i in (0, -1)]
    assert tells("docs/differences.md", *runs["wander_simple", "steps"], giraff / 60, its_small, *ends)


def test_the_pages_tell_how_fast_the_arms_turn():
    ours = max(x for output in rl.load_task("arm_1k").outputs for x in output.values)
    assert tells("docs/results.md", ours, 1) and tells("docs/differences.md", 1, ours)


def test_the_pages_picture_is_the_reports(outcomes):
    o = outcomes["robot_wander_1k"]
    n = len(o.final[o.longest][Q])
    assert tells("docs/results.md", n, *(round(o.means()[label], 2) for label in (QBIASSR, Q, SR)))


PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", *(str(path.relative_to(ROOT)) for path in (
    *sorted(DOCS.glob("*.md")), *sorted(DOCS.glob("howto/*.md")), DOCS / "reproduction/README.md",
    ROOT / "benchmarks/README.md"))]  # fmt: skip


@pytest.mark.parametrize("page", PAGES)
def test_every_link_of_a_page_leads_to_what_is_in_the_repository(page):
    """On GitHub, where nothing is there that `make docs` makes."""
    text = re.sub(r"^```.*?^```", "", (ROOT / page).read_text(encoding="utf-8"), flags=re.M | re.S)
    targets = [target for target in re.findall(r"\]\(([^)\s]+)\)", text) if not re.match(r"https?:|mailto:|#", target)]
    assert [target for target in targets if not ((ROOT / page).parent / target.split("#")[0]).exists()] == []


@pytest.mark.parametrize("lesson, name, form", [
    ("07", "07_eligibility_traces", "{value:.2f} ± {half:.2f}"),
    ("05", "05_qbiassr", "{value:.1f} ± {half:.1f}"),
    ("11", "11_wandering_robot", "{value:.2f} ± {half:.2f}"),
    ("11, waits", "11_wandering_robot", "{value:.1f} ± {half:.1f}"),
    ("16", "16_your_own_task", "{value:.2f} ± {half:.2f}"),
    ("16, states met", "16_your_own_task", "{value:.0f} ± {half:.0f}"),
    ("16, bumps in 100 steps", "16_your_own_task", "{value:.1f} ± {half:.1f}"),
    ("18", "18_real_robot", "{value:.1f} ± {half:.1f}"),
])  # fmt: skip
def test_lessons_quote_what_was_computed_for_them(lesson, name, form):
    text = (ROOT / "notebooks" / f"{name}.ipynb").read_text(encoding="utf-8")
    rows = computed(lesson)
    for of, row in rows.items():
        assert form.format(value=row[0], half=row[1]) in text, of
    assert rows


def computed(lesson: str) -> dict[str, tuple[float, float]]:
    """What lesson_numbers.csv has for a lesson: value and half interval, by what they are of and the steps."""
    rows = [row for row in table("studies/lesson_numbers.csv") if row["lesson"] == lesson]
    return {f"{row['of']}, {row['steps']}": (float(row["value"]), float(row["half_interval"])) for row in rows}


def table(path: str) -> list[dict[str, str]]:
    """The rows of a CSV file."""
    with open(ROOT / path, encoding="utf-8") as file:
        return [*csv.DictReader(file)]


PLUS_MINUS = re.compile(r"([-−]?\d+\.\d+) ?± ?(\d*\.\d+)")


@pytest.mark.parametrize("lesson", [path.relative_to(ROOT).as_posix() for path in lessons(ROOT).values()])
def test_a_mean_with_its_interval_stands_in_an_output_of_its_lesson_or_was_computed_for_one(lesson):
    """Or it is the difference of two that do."""
    number = Path(lesson).name[:2]
    of_lesson = {(row["lesson"][:2], row["value"], row["half_interval"]) for row in table("studies/lesson_numbers.csv")}
    rows = of_lesson | {("", row["mean"], row["half"]) for row in table("rlrobot_course/scoreboard.csv")}
    known = {(f"{float(x):.{digits}f}", f"{float(half):.{digits}f}") for _, x, half in rows for digits in (1, 2)}
    cells = json.loads((ROOT / lesson).read_text(encoding="utf-8"))["cells"]
    shown = PLUS_MINUS.findall(json.dumps([c.get("outputs") for c in cells], ensure_ascii=False).replace("−", "-"))
    quoted = set(PLUS_MINUS.findall(prose(lesson).replace("−", "-"))) - set(shown)
    here = [*shown, *(quoted & known), *((x, half) for of, x, half in of_lesson if of == number)]
    values, halves = np.array(here or [(0, 0)], dtype=float).T
    for value, half in quoted - known:
        rounding = 1.1 * 10.0 ** -len(value.partition(".")[2])
        found = np.isclose(values[:, None] - values, float(value), atol=rounding)
        found &= np.isclose(np.hypot(halves[:, None], halves), float(half), atol=rounding)
        assert found.any(), f"{value} ± {half}"


def test_lessons_11_and_16_call_apart_what_does_not_overlap():
    rows = computed("11") | computed("16")

    def below(low: str, high: str) -> bool:
        (a, half_a), (b, half_b) = rows[f"{low}, 1800"], rows[f"{high}, 1800"]
        return a + half_a < b - half_b

    assert below("lasers err by 5 cm", "ideal") and not below("wheels slip by 20 %", "ideal")
    for world in ("ideal", "as in V-REP"):  # the rows of these names have the paper's cuts
        assert below(world, f"5, 10, 15 cm, {world}") and below(f"50, 100, 150 cm, {world}", world)


def test_lessons_count_the_robots_that_were_counted():
    for n in (value for value, _ in computed("11, forward in state 15").values()):
        assert tells("notebooks/11_wandering_robot.ipynb", n, 15)
    arrived = [value for value, _ in computed("12").values()]
    assert tells("notebooks/12_navigation.ipynb", 18, sum(arrived[:2]))
    assert tells("notebooks/12_navigation.ipynb", sum(arrived[2:]), 18)
    ((shortest, _),) = computed("12, shortest way").values()
    assert tells("notebooks/12_navigation.ipynb", 25, round(shortest, 1), round(shortest / 0.195))
    few, some, many = (value for value, _ in computed("13").values())  # at λ = 0, 0.7 and 0.9
    assert tells("notebooks/13_robot_arm.ipynb", many, 3, 0.9, some, 0.7, few, 0)


def test_lesson_18_tells_what_each_robot_lost_over_the_link():
    lost = [round(value, 1) for value, _ in computed("18, over a link").values()]
    assert tells("notebooks/18_real_robot.ipynb", *lost)


def test_lessons_quote_the_report(outcomes):
    wander = "notebooks/11_wandering_robot.ipynb"
    for world in ("robot", "cause_walls"):
        o = outcomes[f"{world}_wander_1k"]
        assert tells(wander, *(round(o.means()[label], 2) for label in (Q, SR, QBIASSR)))
        assert all(o.pair(*pair)[1] < 0.05 for pair in ((Q, SR), (Q, QBIASSR), (SR, QBIASSR)))
    gains = [outcomes[f"cause_{part}_wander_1k"].pair(SR, Q)[0] for part in ("friction", "lag")]
    assert tells(wander, round(gains[0], 2), -round(gains[1], 2))

    o = outcomes["preliminary_temperature_robot"]
    means = {label: round(o.means()[label], 2) for label in ("T = 1", "T = 0.3")}
    assert tells(
        "notebooks/14_sample_models.ipynb", 1, means["T = 1"], 0.3, means["T = 0.3"], round(o.pair(*means)[1], 3)
    )

    low = {}
    for name in ("robot", "cause_traces"):
        final = outcomes[f"{name}_arm_1k"].final
        at = next(n for n in final if n.unit == "episodes" and n.number == 10)
        low[name] = {label: int((x < 3).sum()) for label, x in final[at].items()}
    assert [low[name][label] for name in low for label in (SR, QBIASSR)] == [10, 8, 0, 2]  # as lesson 13 has them


def test_lesson_22_quotes_the_study_of_networks():
    runs = json.loads((ROOT / "studies/baselines.json").read_text(encoding="utf-8"))["runs"]["wander_1k"]
    last = {label: np.mean([run["windows"][-3:] for run in x]) for label, x in runs.items()}
    numbers = [round(float(last[label]), 1) for label in ("DQN, fitted", QBIASSR)]
    assert tells("notebooks/more/22_a_better_bias.ipynb", *numbers)
    taken = {label: np.mean([run["learning"] for run in runs[label]]) for label in ("DQN, fitted", QBIASSR)}
    assert 50 < taken["DQN, fitted"] / taken[QBIASSR] < 70


@pytest.mark.parametrize("page, heading, lines", [
    ("README.md", "## Ten lines of Python", 10), ("docs/real_robot.md", "## In five lines", 6),  # and its import
])  # fmt: skip
def test_a_heading_counts_its_lines(page, heading, lines):
    code = re.search(rf"^{heading}$.*?^```python$(.*?)^```$", prose(page), re.M | re.S)[1]
    assert len([line for line in code.splitlines() if line]) == lines


def test_the_first_hour_tells_the_minutes_of_the_table_of_lessons():
    table = dict(re.findall(r"notebooks/(\w+)\.ipynb\).*\| (\d+) \|", (ROOT / "README.md").read_text(encoding="utf-8")))
    told = re.findall(r"notebooks/(\w+)\.ipynb\), (\d+) minutes", words(prose("docs/howto/first_hour.md")))
    assert told and all(table[lesson] == minutes for lesson, minutes in told)
