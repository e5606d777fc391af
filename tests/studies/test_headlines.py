"""What docs/results.md, the report and lessons say of results: numbers are read from sentences, compared with data."""

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
from rlrobot_edu.experiments.statistics import Tukey

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
QBIASSR, SR, Q = paper.THREE
NUMBER = r"([-−+]?\d+(?:\.\d+)?)"


def words(text: str) -> str:
    """The text with one blank wherever there is white space."""
    return " ".join(text.split())


def prose(page: str) -> str:
    """What a page says; of a notebook, its cells of text."""
    text = (ROOT / page).read_text(encoding="utf-8")
    if not page.endswith(".ipynb"):
        return text
    return "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown")


def said(page: str, sentence: str) -> list[float]:
    """The numbers at the places of # in this sentence of a page; the sentence must be there, once."""
    pattern = NUMBER.join(map(re.escape, words(sentence).split("#")))
    found = list(re.finditer(pattern, words(prose(page))))
    assert len(found) == 1, f"{page} says {len(found)} times: {sentence}"
    return [float(number.replace("−", "-")) for number in found[0].groups()]


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


def test_the_reports_verdicts_follow_from_the_averages_beside_it(outcomes):
    page = (DOCS / "reproduction/README.md").read_text(encoding="utf-8")
    short = report.in_short(outcomes, causes(outcomes, {}))
    assert [line for line in short.splitlines() if line not in page] == []
    for table in (report.counts_table(outcomes), report.differences_table(outcomes)):
        assert table.markdown in page


def test_the_results_page_counts_the_pairs_as_the_averages_do(outcomes):
    found = defaultdict(list)
    for outcome, length, _, its in report._tested(outcomes):
        if its.p < 0.05:
            found[outcome.experiment.task, its.name].append(of_pairs(outcome, length)[its.name].name)
    always = sum(set(said) == {AGREES} for said in found.values())
    some = sum(AGREES in said and set(said) != {AGREES} for said in found.values())
    sentence = """of the # pairs of methods that the paper finds significantly different, the same one is
        significantly better here in all set-ups in # and in some in # more."""
    assert said("docs/results.md", sentence) == [len(found), always, some]


def test_the_results_page_says_who_is_ahead_where_the_tests_do(outcomes):
    said("docs/results.md", "In wander_1k and wander_4k the paper's own method is significantly ahead of both others;")
    for task in ("wander_1k", "wander_4k"):
        o = outcomes[f"robot_{task}"]
        assert all(difference > 0 and p < 0.05 for difference, p in (o.pair(QBIASSR, SR), o.pair(QBIASSR, Q)))
    (steps,) = said("docs/results.md", "in wander_simple TOSL+SR is ahead of it, significantly so after # steps.")
    o = outcomes["robot_wander_simple"]
    gains = {length.number: o.pair(SR, QBIASSR, length) for length in o.final}
    assert all(gain > 0 for gain, _ in gains.values())
    assert [n for n, (_, p) in gains.items() if p < 0.05] == [steps]
    said("docs/results.md", "on the ideal robot and on the sample model Q-learning beats TOSL+SR in wander_1k;")
    for key in ("robot_wander_1k", "preliminary_algorithms"):
        gain, p = outcomes[key].pair(Q, SR)
        assert gain > 0 and p < 0.05
    episodes = said("docs/results.md", "in arm_1k it is significantly ahead of both others after #, # and # episodes;")
    o = outcomes["robot_arm_1k"]
    both = {n: [o.pair(Q, other, n) for other in (QBIASSR, SR)] for n in o.final if n.unit == "episodes"}
    assert episodes == [n.number for n, pairs in both.items() if all(gain > 0 and p < 0.05 for gain, p in pairs)]


def test_the_readmes_differences_of_wander_1k_are_those_of_the_averages_and_of_the_paper(outcomes):
    numbers = said(
        "docs/results.md", "are in the paper's order, with differences of #, # and # (in the paper #, # and #)."
    )
    held = outcomes["cause_walls_wander_1k"]
    ours = [held.pair(*pair) for pair in ((QBIASSR, SR), (QBIASSR, Q), (SR, Q))]
    theirs = [paper.difference("wander_1k", its) for its in paper.TUKEY["wander_1k"]]
    assert numbers == [round(x, 2) for x in [*(gain for gain, _ in ours), *theirs]]
    assert all(gain > 0 and p < 0.05 for gain, p in ours)


def test_the_readmes_causes_are_those_of_the_report(outcomes):
    sentence = """If contact alone is rewarded, # of the arms' # pairs that are opposite to the paper's change their
        sign, # of them significantly."""
    bad = signs = significant = 0
    for arm in ("arm_1k", "arm_4k"):
        before, after = outcomes[f"robot_{arm}"], outcomes[f"cause_contact_{arm}"]
        for length in before.final:
            names = opposites(before, length)
            bad += len(names)
            signs += sum(not of_pairs(after, length)[name].is_opposite for name in names)
            significant += len(set(names) & set(ahead(after, length)))
    assert said("docs/results.md", sentence) == [signs, bad, significant]
    status = {cause.title: cause.status for cause in causes(outcomes, {})}
    assert status["Q-learning on the model: a fault of the paper's program"] == "shown"
    assert status["wander_1k: walls that hold the robot"] == "shown"
    sentence = """In giraff_wander_1k TOSL+QBIASSR is significantly behind TOSL+SR by its rule; by ours it is ahead, not
        significantly (p = #)."""
    (p,) = said("docs/results.md", sentence)
    ours, its = (outcomes[f"{kind}_giraff_wander_1k"] for kind in ("robot", "cause_evasion"))
    assert of_pairs(its, its.longest)[f"{QBIASSR} over {SR}"].name == REVERSED
    gain, real = ours.pair(QBIASSR, SR)
    assert gain > 0 and p == round(real, 3) >= 0.05


def test_the_page_of_differences_says_how_long_the_processes_are(outcomes):
    sentence = """`wander_simple` after # and # steps, the Giraff's `wander_1k` after its # minutes, as `wander_4k`, its
        `wander_simple` after # steps, the arms after # to # episodes, navigation after # to #,"""
    runs = {
        task: [n.number for n in outcomes[f"robot_{task}"].final if n.unit == unit] for task, unit in {
            "wander_simple": "steps", "giraff_wander_1k": "steps", "giraff_wander_simple": "steps",
            "arm_1k": "episodes", "navigation_1k": "episodes"}.items()
    }  # fmt: skip
    (giraff,), (its_small,) = runs["giraff_wander_1k"], runs["giraff_wander_simple"]
    ends = [runs[task][i] for task in ("arm_1k", "navigation_1k") for i in (0, -1)]
    assert said("docs/differences.md", sentence) == [*runs["wander_simple"], giraff / 60, its_small, *ends]


def test_the_results_page_says_how_fast_the_arms_turn():
    ours, theirs = said("docs/results.md", "Our arm is slower than the authors', too (# rad/s, theirs #):")
    assert ours == max(x for output in rl.load_task("arm_1k").outputs for x in output.values)
    assert [theirs] == said("docs/differences.md", "in its scene # rad/s within a narrow range")


def test_the_pages_picture_is_the_reports(outcomes):
    sentence = """means of # repetitions: TOSL+QBIASSR ends at #, Q+SR at #, TOSL+SR at
        #.](reproduction/robot_wander_1k.png)"""
    o = outcomes["robot_wander_1k"]
    n = len(o.final[o.longest][Q])
    assert said("docs/results.md", sentence) == [n, *(round(o.means()[label], 2) for label in (QBIASSR, Q, SR))]


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
    ("05b", "05b_lambda_from_both_sides", "{value:.2f} ± {half:.2f}"),
    ("07", "07_qbiassr", "{value:.2f} ±{half:.2f}"),
    ("10", "10_wandering_robot", "{value:.2f} ± {half:.2f}"),
    ("10a", "10a_where_to_cut", "{value:.2f} ± {half:.2f}"),
    ("10a, situations met", "10a_where_to_cut", "| {value:.0f} |"),
    ("17", "17_real_robot", "{value:.1f} ± {half:.1f}"),
])  # fmt: skip
def test_lessons_quote_what_was_computed_for_them(lesson, name, form):
    text = (ROOT / "notebooks" / f"{name}.ipynb").read_text(encoding="utf-8")
    rows = computed(lesson)
    for of, row in rows.items():
        assert form.format(value=row[0], half=row[1]) in text, of
    assert rows


def computed(lesson: str) -> dict[str, tuple[float, float]]:
    """What lesson_numbers.csv has for a lesson: value and half interval, by what they are of and the steps."""
    with open(ROOT / "studies/lesson_numbers.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["lesson"] == lesson]
    return {f"{row['of']}, {row['steps']}": (float(row["value"]), float(row["half_interval"])) for row in rows}


PLUS_MINUS = re.compile(r"([-−]?\d+\.\d+) ?± ?(\d*\.\d+)")


@pytest.mark.parametrize("lesson", sorted(path.name for path in ROOT.glob("notebooks/*.ipynb")))
def test_a_mean_with_its_interval_stands_in_an_output_of_its_lesson_or_was_computed_for_one(lesson):
    with open(ROOT / "studies/lesson_numbers.csv", encoding="utf-8") as file:
        rows = [(float(row["value"]), float(row["half_interval"])) for row in csv.DictReader(file)]
    known = {(f"{value:.{digits}f}", f"{half:.{digits}f}") for value, half in rows for digits in (1, 2)}
    cells = json.loads((ROOT / "notebooks" / lesson).read_text(encoding="utf-8"))["cells"]
    outputs = json.dumps([cell.get("outputs") for cell in cells], ensure_ascii=False)
    known |= set(PLUS_MINUS.findall(outputs.replace("−", "-")))
    assert set(PLUS_MINUS.findall(prose(f"notebooks/{lesson}").replace("−", "-"))) - known == set()


def test_lessons_10_and_10a_call_apart_what_does_not_overlap():
    rows = computed("10") | computed("10a")

    def below(low: str, high: str) -> bool:
        (a, half_a), (b, half_b) = rows[f"{low}, 1800"], rows[f"{high}, 1800"]
        return a + half_a < b - half_b

    said("notebooks/10_wandering_robot.ipynb", "the interval lies below the ideal robot's.")
    assert below("lasers err by 5 cm", "ideal") and not below("wheels slip by 20 %", "ideal")
    sentence = "the nearest cuts earn most and the farthest least, and no two intervals of a column overlap."
    said("notebooks/10a_where_to_cut.ipynb", sentence)
    for world in ("ideal", "as in V-REP"):  # the rows of these names have the paper's cuts
        assert below(world, f"5, 10, 15 cm, {world}") and below(f"50, 100, 150 cm, {world}", world)


def test_lessons_11_and_12a_count_the_robots_that_were_counted():
    arrived = [value for value, _ in computed("11").values()]
    sentence = "With minus ten times that length, of # robots that could reverse # reached the goal in three hours"
    assert said("notebooks/11_navigation.ipynb", sentence) == [18, sum(arrived[:2])]
    assert said("notebooks/11_navigation.ipynb", "with minus that length itself, # of # did.") == [sum(arrived[2:]), 18]
    caught = [value for value, _ in computed("12a").values()]
    sentence = "Of a hundred other arms each, # ended below 3 at λ = 0.9, # at λ = 0.7 and # at λ = 0."
    assert said("notebooks/12a_the_reward_trap.ipynb", sentence) == caught[::-1]


def test_lesson_17_tells_what_each_robot_lost_over_the_link():
    sentence = "the Giraffs lost #, #, # and # a step, the others #, #, # and #."
    lost = [round(value, 1) for value, _ in computed("17, over a link").values()]
    assert said("notebooks/17_real_robot.ipynb", sentence) == lost


def test_lessons_quote_the_report(outcomes):
    page = "notebooks/10_wandering_robot.ipynb"
    sentence = "With thirty robots each and a whole hour it was # [#, #] against # [#, #]"
    numbers, report_says = said(page, sentence), (DOCS / "reproduction/README.md").read_text(encoding="utf-8")
    for task, (mean, low, high) in {"wander_1k": numbers[:3], "wander_4k": numbers[3:]}.items():
        assert mean == round(outcomes[f"robot_{task}"].means()[QBIASSR], 2)
        assert f"| {QBIASSR} | 30 | {mean} | [{low:.2f}, {high:.2f}] |" in report_says

    o = outcomes["robot_navigation_1k"]
    sentence = """by the paper's measure ours came to # (TOSL+QBIASSR) and # (Q+SR) after one episode, which is no clear
        difference; after five # and #, which is one"""
    one, five = (next(n for n in o.final if n.unit == "episodes" and n.number == x) for x in (1, 5))
    means = [round(o.means(n)[label], 2) for n in (one, five) for label in (QBIASSR, Q)]
    assert said("notebooks/11_navigation.ipynb", sentence) == means
    assert o.pair(QBIASSR, Q, one)[1] >= 0.05 > o.pair(QBIASSR, Q, five)[1]

    page = "notebooks/13a_where_a_model_misleads.ipynb"
    sentence = "Q-learning leads TOSL by # (both with softmax); once the loops are taken out, by # (*p* = #), # or #,"
    models = [outcomes[f"cause_loops_{unseen}"].pair(Q, SR) for unseen in ("uniform", "siblings", "stay")]
    (gain, p), others = models[0], [round(gain, 2) for gain, _ in models[1:]]
    assert said(page, sentence)[1:] == [round(gain, 2), round(p, 2), *others]
    o = outcomes["preliminary_temperature_robot"]
    gain, p = o.pair("T = 1", "T = 0.3")
    means = [round(o.means()[label], 2) for label in ("T = 1", "T = 0.3")]
    sentence = "in the report's thirty agents each, $T = 1$ earns # and $T = 0.3$ earns # (*p* = #)."
    assert said(page, sentence) == [*means, round(p, 3)]

    page, low = "notebooks/12a_the_reward_trap.ipynb", {}
    for name in ("robot", "cause_traces"):
        final = outcomes[f"{name}_arm_1k"].final
        at = next(n for n in final if n.unit == "episodes" and n.number == 10)
        low[name] = {label: int((x < 3).sum()) for label, x in final[at].items()}
    assert (low["robot"][SR], low["cause_traces"][SR]) == (10, 0)
    assert (low["robot"][QBIASSR], low["cause_traces"][QBIASSR]) == (8, 2)
    said(page, "ten of thirty with TOSL+SR are below 3 at λ = 0.9 and none at λ = 0; with TOSL+QBIASSR eight and two.")


def test_lesson_16b_quotes_the_study_of_networks():
    runs = json.loads((ROOT / "studies/baselines.json").read_text(encoding="utf-8"))["runs"]["wander_1k"]
    last = {label: np.mean([run["windows"][-3:] for run in x]) for label, x in runs.items()}
    sentence = "one of them, DQN, earns # a step at the end and TOSL+QBIASSR #, for some sixty times the computing."
    numbers = said("notebooks/16b_a_better_bias.ipynb", sentence)
    assert numbers == [round(float(last[label]), 1) for label in ("DQN, fitted", QBIASSR)]
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
