"""Writes docs/results.md from results_template.md and the data: ``python studies/results_page.py``.

A name in braces in the template stands for a number or a table. Names with a colon are looked up in
docs/reproduction/averages.csv, see `number`; the others are in `named`.
"""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Mapping
from pathlib import Path

import authors_recording_page
import numpy as np
import seeds
import still_object
from in_markdown import in_markdown
from paper import paper, tally
from paper.experiments import EXPERIMENTS
from paper.outcome import Outcome, read_outcomes
from paper.verdicts import LEVEL
from scipy import stats

from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.files import write_whole

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
TEMPLATE = HERE / "results_template.md"
PAGE = DOCS / "results.md"
NAME = re.compile(r"\{([^{}]+)\}")
NOTE = re.compile(r"^<!--.*?-->\n", re.M | re.S)  # for those who write the template
QBIASSR, SR, Q = paper.THREE
TESTS = ("Tukey", "Games-Howell")
LINES = textwrap.TextWrapper(120, break_long_words=False, break_on_hyphens=False)
POINTS = textwrap.TextWrapper(
    120, break_long_words=False, break_on_hyphens=False, subsequent_indent="  "
)
OURS, PROGRAMS = (
    tally.RULES
)  # where loop evasion acts: here, and in the paper's program
Outcomes = Mapping[str, Outcome]


def signed(value: float) -> str:
    """With its sign and two decimals."""
    return f"{value:+.2f}".replace("-", "−")


def plain(value: float) -> str:
    """With two decimals."""
    return f"{value:.2f}".replace("-", "−")


def number(outcomes: Outcomes, name: str) -> str:
    """The number that a name stands for.

    "key: A" is a mean with its interval, "key: A - B" a signed difference of means, "p key: A - B" its p in Tukey's
    test; "paper task: A - B" is the paper's difference. A length may follow the key after a comma; without one it is
    the longest. Raises KeyError if there is no such experiment, method or length.
    """
    place, what = name.split(": ")
    first, _, second = what.partition(" - ")
    if place.startswith("paper "):
        task = place.removeprefix("paper ")
        for pair in paper.TUKEY[task]:
            if (pair.better, pair.worse) == (first, second):
                return signed(paper.difference(task, pair))
        raise KeyError(name)
    key, _, length = place.removeprefix("p ").partition(", ")
    outcome = outcomes[key]
    lengths = {str(each): each for each in outcome.final}
    at = lengths[length] if length else outcome.longest
    if not second:
        return told(outcome.final[at][first])
    difference, p = outcome.pair(first, second, at)
    return f"{p:.2g}" if place.startswith("p ") else signed(difference)


def told(values) -> str:
    """Mean and half of its 95 % interval (Student's t)."""
    half = stats.t.ppf(0.975, len(values) - 1) * stats.sem(values)
    return f"{np.mean(values):.2f} ± {half:.2f}".replace("-", "−")


def marks(outcomes: Outcomes, rule: str, test: str) -> dict[tuple[str, str], str]:
    """What became of each pair that the paper finds significant, by task and name of the pair."""
    found = tally.looks(outcomes, tally.RULES[rule])
    p_values = tally.TESTS[test]([judged.ours for _, _, judged in found])
    return tally.marks(found, p_values)


def pairs_table(outcomes: Outcomes) -> str:
    """Each pair that the paper finds significant: its difference and ours, and the marks by both tests."""
    by_test = [marks(outcomes, OURS, test) for test in TESTS]
    rows = []
    for task, pairs in paper.TUKEY.items():
        outcome = outcomes[f"robot_{task}"]
        for pair in pairs:
            if pair.p < LEVEL:
                ours = []
                for length in outcome.final:
                    gain, p = outcome.pair(pair.better, pair.worse, length)
                    ours.append(f"**{signed(gain)}**" if p < LEVEL else signed(gain))
                rows.append(
                    f"| {task} | {pair.name} | {signed(paper.difference(task, pair))} | "
                    f"{', '.join(ours)} | {by_test[0][task, pair.name]} | {by_test[1][task, pair.name]} |"
                )
    head = "| task | pair | the paper | here | Tukey | Games-Howell |"
    return "\n".join([head, "| :--- | :--- | ---: | :--- | :---: | :---: |", *rows])


def without_caption(table: Table) -> str:
    """A table in Markdown, no more."""
    return "\n".join(in_markdown(table).splitlines()[2:])


def slips() -> dict[str, str]:
    """What follows from numbers that the paper prints, and how it prints them."""
    pair = paper.TUKEY["wander_simple"][0]
    within = paper.ANOVA["wander_simple"][0].df_within
    anova, f, p = paper.ANOVA["navigation_1k"]
    gains = []
    for task, pairs in paper.TUKEY.items():
        for one in pairs:
            if {one.better, one.worse} == {QBIASSR, SR}:
                gains.append((task, one))
    ahead = [one for _, one in gains if one.better == QBIASSR and one.p < LEVEL]
    return {
        "slip q": f"{pair.q:.2f}",
        "slip q printed": f"{pair.p:.3f}",
        "slip q right": f"{stats.studentized_range.sf(pair.q, 3, within):.3f}",
        "slip F": f"{f:.2f}",
        "slip F printed": f"{p:.3f}",
        "slip F right": f"{stats.f.sf(f, anova.df_between, anova.df_within):.4f}",
        "slip order": plain(paper.difference("wander_simple", pair)),
        "bias tests": str(len(gains)),
        "bias significant": str(len(ahead)),
        "n wander": str(paper.repetitions("wander_1k")),
        "n navigation": str(paper.repetitions("navigation_1k")),
    }


def counts_of_seeds() -> dict[str, str]:
    """How many verdicts stay with another seed, in all and by kind of task, on the kinematic robots."""
    by_pair: dict[tuple, list[str]] = {}
    for row in seeds.read():
        place = row.task, row.length, row.better, row.worse
        by_pair.setdefault(place, []).append(row.verdict)
    kinds = {
        "all": "",
        "wandering": "wander",
        "navigation": "navigation",
        "arms": "arm",
    }
    found = {}
    for kind, beginning in kinds.items():
        its = [
            both for place, both in by_pair.items() if place[0].startswith(beginning)
        ]
        same = sum(first == second for first, second in its)
        found[f"stay in {kind}"] = f"{same} of {len(its)}"
    return found


def of_studies() -> dict[str, str]:
    """Numbers of other studies."""
    blind = json.loads((HERE / "blind.json").read_text(encoding="utf-8"))
    better = json.loads((HERE / "better_bias.json").read_text(encoding="utf-8"))
    still = json.loads(still_object.FILE.read_text(encoding="utf-8"))
    found = {
        f"blind {task}": told(its["finals"]["blind"]) for task, its in blind.items()
    }
    for label in ("coarse", "QBIASSR"):
        found[f"{label} wander_1k"] = told(better["wander_1k"][label])
    for task, its in still.items():
        found[f"met {task}"] = str(its["met"])
        found[f"states {task}"] = str(its["states"])
    found["change by the object"] = plain(still_object.largest_change(still))
    recording = authors_recording_page.read(HERE / "authors_recording.csv")
    of = authors_recording_page
    for name, pair in of.BY_HOUR.items():
        found[f"authors {name}"] = str(of.without_hours(recording, pair))
        for robot in of.ROBOTS:
            found[f"{robot} {name}"] = str(of.over_recordings(recording, robot, pair))
    found["authors with the fault"] = str(of.over_agents(recording, of.WITH_FAULT))
    return found


def named(outcomes: Outcomes) -> dict[str, str]:
    """All that has a name without a colon."""
    counts = without_caption(tally.tally_table(outcomes))
    found = {"tally": counts, "pairs": pairs_table(outcomes)}
    ours = list(marks(outcomes, OURS, "Tukey").values())
    found["significant in the paper"] = str(len(ours))
    found["pairs of the paper"] = str(sum(map(len, paper.TUKEY.values())))
    return found | slips() | counts_of_seeds() | of_studies()


def page() -> str:
    """The page in Markdown."""
    outcomes = read_outcomes(DOCS / "reproduction" / "averages.csv", EXPERIMENTS)
    names = named(outcomes)

    def value(found: re.Match) -> str:
        name = found[1]
        return number(outcomes, name) if ": " in name else names[name]

    template = NOTE.sub("", TEMPLATE.read_text(encoding="utf-8"))
    parts = NAME.sub(value, template).split("\n\n")
    return "\n\n".join(map(wrapped, parts)).strip() + "\n"


def one_blank(text: str) -> str:
    """With one blank wherever there is white space."""
    return " ".join(text.split())


def wrapped(part: str) -> str:
    """A paragraph or list with its lines filled anew; anything else as it is."""
    if part.startswith(("|", "#", "!")):
        return part
    items = re.split(r"\n(?=- )", part)
    return "\n".join(
        POINTS.fill(item) if item.startswith("- ") else LINES.fill(item)
        for item in map(one_blank, items)
    )


def write_results() -> None:
    """Write the page."""
    write_whole(PAGE, page())


if __name__ == "__main__":
    write_results()
