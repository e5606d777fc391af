"""The page of the reproduction, for a sceptic: what was reproduced, what not, and why; then every number."""

from collections import Counter
from collections.abc import Callable, Mapping

from paper import paper, verdicts
from paper.cause import NOTHING, Cause, Outcomes, paired, signed
from paper.causes import causes
from paper.claims import claims, cost_table, diagnoses, durations, preliminaries
from paper.experiments import EXPERIMENTS
from paper.outcome import interval
from paper.verdicts import AGREES, CLASSES, LEVEL, OPPOSITE, REVERSED
from rlrobot_edu.experiments.statistics import exact
from rlrobot_edu.experiments.tables import Table

INTRODUCTION = """# The paper's experiments, run again

Written by `python studies/reproduce.py{option}`, with {about}.

Everything is run with the same default parameters, nothing is tuned for a task, and nothing is left out. Of its
processes the paper says only how long the Giraff's lasted, so where it matters several lengths are run, and all are
shown. Every sentence below that says what came of it is computed. The averages of all repetitions are in
[averages.csv](averages.csv), versions and seed in [environment.json](environment.json)."""

QUICK = "**This is the quick set: a few repetitions, which prove little. Read [the full set](../README.md).**"

NOT_ALL = """**{n} of {all} experiments have not been run for this page: {missing}. It says nothing of them;
`make reproduce` runs them all.**"""


def page(
    outcomes: Outcomes, figures: Mapping[str, str], skipped: dict[str, str], costs: list[float] | None, about: dict
) -> str:
    """The whole page, in Markdown."""
    quick = about["set"] == "quick"
    option = " --quick" * quick + (f" --engine {about['engine']}" if "engine" in about else "")
    facts = ", ".join(f"{name} {value}" for name, value in about.items() if name != "set")
    found = causes(outcomes, figures)
    missing = [e.key for e in EXPERIMENTS if e.key not in outcomes and e.key not in skipped]
    parts = [
        INTRODUCTION.format(option=option, about=facts),
        QUICK if quick else "",
        NOT_ALL.format(n=len(missing), all=len(EXPERIMENTS), missing=", ".join(missing)) if missing else "",
        "## In short",
        in_short(outcomes, found),
    ]
    parts += [f"Skipped: {key}: {reason}." for key, reason in skipped.items()]
    parts += [counts_table(outcomes).markdown, verdicts.LEGEND]
    parts += ["## The differences, beside the paper's", figures.get("differences", ""), DIFFERENCES]
    parts += [differences_table(outcomes).markdown, "## Why", *(cause.text for cause in found)]
    parts += ["## Preliminary tests", figures.get("preliminaries", ""), *preliminaries(outcomes)]
    parts += ["## Other claims of the paper", *claims(outcomes)]
    parts += ["## Every experiment", *(outcomes[e.key].section for e in EXPERIMENTS if e.key in outcomes)]
    if costs is not None:
        parts += ["## What a step costs", cost_table(costs).markdown]
    parts += ["## Sample model against simulator", *diagnoses(outcomes), durations(outcomes).markdown]
    return "\n\n".join(part for part in parts if part) + "\n"


DIFFERENCES = """A difference is the mean final average reward of one method less that of another. The paper prints Q of
Tukey's test and no means; a difference is Q·√(MSW / n), with MSW and the degrees of freedom of its analysis of variance
and n repetitions of each method (3 n − 3 degrees of freedom within). Its sign follows from the order of the means, the
only one in which two of the Q add up to the third."""


def _tested(outcomes: Outcomes):
    """Every pair that the paper tests, at every length: outcome, length, our pair, its pair."""
    for key, outcome in outcomes.items():
        if key.startswith("robot_"):
            for length in outcome.pairs:
                for pair, its in paired(outcome, length):
                    yield outcome, length, pair, its


def in_short(outcomes: Outcomes, found: list[Cause]) -> str:
    """What was reproduced, what was not, and why."""
    by_pair: dict[tuple[str, str], list[str]] = {}
    for outcome, _, pair, its in _tested(outcomes):
        if its.p < LEVEL:
            name = (outcome.experiment.task, its.name)
            by_pair.setdefault(name, []).append(verdicts.of_pair(pair, its).name)
    lines = _reproduced(by_pair) if by_pair else []
    lines += [f"- **{cause.title}: {cause.status}.** {cause.summary}" for cause in found if cause.status != NOTHING]
    reversed_, nulls = _unexplained(outcomes, found)
    lines.append(f"- **Significantly the opposite, and not explained by an experiment here**: {reversed_}.")
    lines.append(f"- **No difference shown, where the paper has one, and the other sign**: {nulls}.")
    return "\n".join(lines)


def _reproduced(by_pair: Mapping[tuple[str, str], list[str]]) -> list[str]:
    """What became of the pairs that the paper finds significant; by task and pair, the verdicts of all set-ups."""

    def those(holds: Callable[[list[str]], bool]) -> str:
        names = [name for name, said in by_pair.items() if holds(said)]
        return f"{len(names)} ({_listed(names)})"

    def is_opposite(word: str) -> bool:
        return word in (OPPOSITE, REVERSED)

    every = those(lambda said: all(word == AGREES for word in said))
    some = those(lambda said: AGREES in said and any(word != AGREES for word in said))
    only = those(lambda said: AGREES not in said and not any(map(is_opposite, said)))
    once = those(lambda said: AGREES not in said and any(map(is_opposite, said)))
    reverse = those(lambda said: REVERSED in said)
    return [
        f"- **Reproduced.** Of the {len(by_pair)} pairs of methods that the paper finds significantly different, the "
        f"same method is significantly better here in every set-up in {every}, and in some set-ups in {some}.",
        f"- **The same direction, but never significant here**: {only}.",
        f"- **Not reproduced.** Never significant here, and opposite in at least one set-up: {once}. Of all pairs, "
        f"significantly the opposite in at least one set-up: {reverse}.",
    ]


def _listed(names) -> str:
    by_task: dict[str, list[str]] = {}
    for task, pair in names:
        by_task.setdefault(task, []).append(pair)
    return "; ".join(f"{task}: {', '.join(pairs)}" for task, pairs in by_task.items()) or "none"


def _unexplained(outcomes: Outcomes, found: list[Cause]) -> tuple[str, str]:
    """The pairs that are opposite to the paper's without a cause that is shown: significantly, and not."""
    known = frozenset().union(*(cause.explains for cause in found))
    significant, nulls = [], []
    for key, outcome in outcomes.items():
        if key.startswith("cause_"):
            continue
        for length, groups in outcome.final.items():
            where, width = f"{outcome.experiment.where}, {length}", interval(groups)
            for pair, its in paired(outcome, length):
                said, gain = verdicts.of_pair(pair, its), verdicts.gain(pair, its)
                if (key, length, its.name) in known:
                    continue
                if said.name == REVERSED:
                    significant.append(f"{where}: {its.name}")
                elif said.name == OPPOSITE:
                    reach = f"{signed(gain - width)} to {signed(gain + width)}"
                    nulls.append(f"{where}: {its.better} less {its.worse} {signed(gain)} (95 %: {reach})")
    return "; ".join(significant) or "none", "; ".join(nulls) or "none"


def counts_table(outcomes: Outcomes) -> Table:
    """How many pairs of each set-up have each verdict."""
    counted: dict[tuple, Counter] = {}
    for outcome, length, pair, its in _tested(outcomes):
        place = (outcome.experiment.task, str(length), len(outcome.final[length][pair.first]))
        counted.setdefault(place, Counter())[verdicts.of_pair(pair, its).name] += 1
    rows = [[*place, *(counter[name] for name in CLASSES)] for place, counter in counted.items()]
    return Table("Verdicts on the pairs of methods that the paper tests", ["task", "length", "n", *CLASSES], rows)


def differences_table(outcomes: Outcomes) -> Table:
    """Raw differences: the paper's and ours."""
    rows = []
    for outcome, length, pair, its in _tested(outcomes):
        task, n = outcome.experiment.task, len(outcome.final[length][pair.first])
        theirs = paper.difference(task, its)
        rows.append([
            task, str(length), f"{its.better} less {its.worse}", theirs, paper.repetitions(task), its.p,
            verdicts.gain(pair, its), n, exact(pair.p), str(verdicts.of_pair(pair, its)),
        ])  # fmt: skip
    columns = [
        "task",
        "length",
        "pair",
        "the paper's difference",
        "its n",
        "its p",
        "ours",
        "our n",
        "our p",
        "verdict",
    ]
    return Table("Differences of mean final average rewards", columns, rows)
