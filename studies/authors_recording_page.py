"""The page docs/studies/authors_recording.md, from the numbers in authors_recording.csv."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from in_markdown import in_markdown
from paper.experiments import FAULTY
from scipy import stats

from rlrobot_edu.experiments.tables import Table

FIVE = ("TOSL+QBIASSR", "TOSL+SR", "SL+SR", "Q+SR", "SARSA+SR")
QBIASSR, SR, _, Q, _ = FIVE
HOURS = range(1, 6)
RULES = {"authors": "uniform", "authors, siblings": "siblings", "authors, stay": "stay"}
BY_HOUR = {
    "TOSL+QBIASSR less TOSL+SR": (QBIASSR, SR),
    "TOSL+SR less Q+SR": (SR, Q),
}
WITH_FAULT = (SR, FAULTY)
PAIRS = BY_HOUR | {"TOSL+SR less Q+SR with the fault": WITH_FAULT}
TRACES = {
    "λ = 0.9 less λ = 0": ("λ = 0.9", "λ = 0"),
    "λ = 0.9 less λ = 0.5": ("λ = 0.9", "λ = 0.5"),
}
ROBOTS = {"ideal": "ideal robot", "vrep": "with friction and lag"}


class Group(NamedTuple):
    """Agents of one method in one model: how many, mean and standard deviation of their final average rewards."""

    n: int
    mean: float
    sd: float

    def __str__(self) -> str:
        half = stats.t.ppf(0.975, self.n - 1) * self.sd / math.sqrt(self.n)
        return f"{self.mean:.2f} ± {half:.2f}".replace("-", "−")


Found = dict[str, dict[str, Group]]


class Spread(NamedTuple):
    """A difference of two means over several models: of all, in each, and half of a 95 % interval."""

    mean: float
    each: list[float]
    half: float

    def __str__(self) -> str:
        return f"{self.mean:+.2f} ± {self.half:.2f}".replace("-", "−")


def read(file: Path) -> Found:
    """The numbers by world and method."""
    found: Found = {}
    with file.open(encoding="utf-8", newline="") as rows:
        for row in csv.DictReader(rows):
            group = Group(int(row["n"]), float(row["mean"]), float(row["sd"]))
            found.setdefault(row["world"], {})[row["method"]] = group
    return found


def gain(groups: dict[str, Group], pair: tuple[str, str]) -> float:
    """The mean of one method less that of another."""
    first, second = pair
    return groups[first].mean - groups[second].mean


def without_hours(found: Found, pair: tuple[str, str]) -> Spread:
    """A difference in the authors' recording, and without each of its hours: the jackknife's interval."""
    each = [gain(found[f"authors without hour {hour}"], pair) for hour in HOURS]
    n = len(each)
    error = math.sqrt((n - 1) / n * np.sum((np.array(each) - np.mean(each)) ** 2))
    return Spread(
        gain(found["authors"], pair), each, float(stats.t.ppf(0.975, n - 1) * error)
    )


def over_agents(found: Found, pair: tuple[str, str]) -> Spread:
    """A difference in the model of the whole recording, and Welch's interval over agents in this one model."""
    groups = [found["authors"][label] for label in pair]
    errors = [group.sd**2 / group.n for group in groups]
    freedom = sum(errors) ** 2 / sum(
        error**2 / (group.n - 1) for error, group in zip(errors, groups, strict=True)
    )
    half = stats.t.ppf(0.975, freedom) * math.sqrt(sum(errors))
    return Spread(gain(found["authors"], pair), [], float(half))


def over_recordings(found: Found, robot: str, pair: tuple[str, str]) -> Spread:
    """A difference in the models of our recordings of one robot, and Student's interval over these."""
    each = [
        gain(groups, pair) for world, groups in found.items() if world.startswith(robot)
    ]
    half = stats.t.ppf(0.975, len(each) - 1) * stats.sem(each)
    return Spread(float(np.mean(each)), each, float(half))


def in_words(each: Iterable[float]) -> str:
    """Differences, one after the other."""
    return ", ".join(f"{x:+.2f}" for x in each).replace("-", "−")


def rows_of(head: Sequence[str], rows: list[list]) -> str:
    """A table in Markdown, without a caption."""
    return "\n".join(in_markdown(Table("", list(head), rows)).splitlines()[2:])


def methods_table(found: Found) -> str:
    """The five methods in the model of the whole recording, by the rule for unknown pairs."""
    rows = [
        [rule, *(str(found[world][label]) for label in FIVE)]
        for world, rule in RULES.items()
    ]
    return rows_of(["unknown pairs", *FIVE], rows)


def hours_table(found: Found) -> str:
    """Each difference with all hours, and without each one."""
    rows = []
    for name, pair in (BY_HOUR | TRACES).items():
        its = without_hours(found, pair)
        rows.append([name, str(its), in_words(its.each)])
    return rows_of(["difference", "five hours", "without hour 1, 2, 3, 4, 5"], rows)


def recordings_table(found: Found) -> str:
    """Each difference over our recordings of either robot."""
    rows = []
    for robot, said in ROBOTS.items():
        for name, pair in PAIRS.items():
            its = over_recordings(found, robot, pair)
            rows.append([said, name, str(its), in_words(its.each)])
    return rows_of(["robot", "difference", "mean over six", "each"], rows)


def values_table(found: Found) -> str:
    """The values of λ, α, γ and T in the authors' model."""
    rows = []
    for symbol, chosen in {"λ": "0.9", "α": "0.1", "γ": "0.9", "T": "1"}.items():
        its = {
            x: g for x, g in found["authors"].items() if x.startswith(f"{symbol} = ")
        }
        best = max(its, key=lambda label: its[label].mean)
        means = ", ".join(
            f"{label.split(' = ')[1]}: {group}" for label, group in its.items()
        )
        rows.append([symbol, chosen, best.split(" = ")[1], means])
    return rows_of(["", "the paper's", "highest mean", "means"], rows)


def excludes_zero(spread: Spread) -> bool:
    """Whether the interval says which sign the difference has."""
    return abs(spread.mean) > spread.half


def verdict(found: Found) -> str:
    """What follows, in words that follow the numbers."""
    bias, order = (without_hours(found, pair) for pair in BY_HOUR.values())
    with_fault = over_agents(found, WITH_FAULT)
    signs = {True: "The interval excludes 0", False: "The interval includes 0"}
    ranks = sorted(FIVE, key=lambda label: -found["authors"][label].mean)
    alike = sum(x > 0 for x in bias.each)
    ours = [over_recordings(found, robot, (SR, Q)) for robot in ROBOTS]
    each = [x for spread in ours for x in spread.each]
    lines = [
        f"- **Without the fault** the order of the means is {', '.join(ranks)}.",
        f"- **TOSL+QBIASSR less TOSL+SR** is {bias}. {signs[excludes_zero(bias)]}; the difference is positive in"
        f" {alike} of the five models without an hour.",
        f"- **TOSL+SR less Q+SR** is {order}. {signs[excludes_zero(order)]}: one recording of five hours "
        + (
            "shows who is ahead."
            if excludes_zero(order)
            else "does not show who is ahead."
        ),
        f"- **With the fault** Q+SR earns {found['authors'][FAULTY]}, and TOSL+SR is ahead of it by {with_fault}. These"
        " intervals are about agents in the model of all five hours.",
        f"- **In our own recordings** Q+SR is ahead of TOSL+SR in {sum(x < 0 for x in each)} of {len(each)} models, and"
        " with the fault it is behind.",
    ]
    return "\n".join(lines)


PAGE = """# The authors' own recording

The paper's authors recorded 18,000 steps, five hours, of `wander_1k` in V-REP. The report's sample models are made of
our robot's recordings; here is what a model of theirs says, with the paper's parameters. In particular: does the
paper's order of methods need the fault of its Q-learning, which drew s′ with the action of the step before?

`python studies/authors_recording.py` measures it. It needs the recording, which is not part of the project; the numbers
are kept in [authors_recording.csv](../../studies/authors_recording.csv), from which `--page` writes this page.

## In short

{verdict}

So the fault is one possible cause of the paper's order on models. It is not needed for that order in a model of their
recording.

## Five methods

Final average reward of an hour, mean ± half of its 95 % interval; {n} agents each, loop evasion in all. An unknown pair
(s, a) leads anywhere by default; *siblings* and *stay* are the library's other rules.

{methods}

These intervals are about agents in one model. They say nothing about another recording. Of Q-learning with the fault
there are {faulty_all} agents.

## How far one recording carries

Each hour was left out in turn ({without} agents each). The interval is the jackknife's, with Student's t for five
hours. It is rough: the hours are few, and they come from one agent that learned on.

{hours}

## Six recordings of our own

Recordings as long as theirs, made by TOSL+SR on pymunk's base with seeds 1 to 6, of the ideal robot and of one with
V-REP's wall friction and lag (`Realism.vrep()`); {other} agents of each method in each
model, {faulty} of Q-learning with the fault. The interval is over the six recordings, and so about another recording.

{recordings}

## λ, α, γ and T on the paper's data

TOSL+SR in the model of the whole recording, {n} agents each. The paper's λ has nearly the highest mean; the interval
over hours, above, does not exclude that a shorter trace is as good. The paper's α, γ and T are not the best, as on the
models of our recordings.

{values}
"""


def page(file: Path) -> str:
    """The page in Markdown."""
    found = read(file)
    return PAGE.format(
        verdict=verdict(found), methods=methods_table(found), hours=hours_table(found),
        recordings=recordings_table(found), values=values_table(found), n=found["authors"][SR].n,
        without=found["authors without hour 1"][SR].n, other=found["ideal 1"][SR].n,
        faulty=found["ideal 1"][FAULTY].n, faulty_all=found["authors"][FAULTY].n,
    )  # fmt: skip
