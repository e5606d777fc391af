"""The page of the reproduction, for a sceptic: what was reproduced, what not, and why; then every number."""

from collections import Counter
from collections.abc import Mapping

from rlrobot_edu.experiments.statistics import exact
from rlrobot_edu.experiments.tables import Table, as_text
from rlrobot_edu.reproduction import paper, verdicts
from rlrobot_edu.reproduction.cause import NOTHING, SHOWN, Cause, of_value, opposites
from rlrobot_edu.reproduction.causes import causes
from rlrobot_edu.reproduction.experiments import EXPERIMENTS, PRELIMINARIES, by_key
from rlrobot_edu.reproduction.outcome import Outcome
from rlrobot_edu.reproduction.verdicts import AGREES, CLASSES, LEVEL, REVERSED

INTRODUCTION = """# The paper's experiments, run again

Written by `python -m rlrobot_edu reproduce{option}`, with {about}.

Everything is run with the same default parameters, nothing is tuned for a task, and nothing is left out. The paper does
not say how long its processes lasted, so where it matters several lengths are run, and all are shown. Every sentence
below that says what came of it is computed. The averages of all repetitions are in [averages.csv](averages.csv),
versions and seed in [environment.json](environment.json)."""

QUICK = "**This is the quick set: a few repetitions, which prove little. Read [the full set](../README.md).**"

Outcomes = Mapping[str, Outcome]


def page(
    outcomes: Outcomes, figures: Mapping[str, str], skipped: dict[str, str], costs: list[float] | None, about: dict
) -> str:
    """The whole page, in Markdown."""
    option = " --quick" if about["set"] == "quick" else ""
    facts = ", ".join(f"{name} {value}" for name, value in about.items() if name != "set")
    found = causes(outcomes, figures)
    parts = [
        INTRODUCTION.format(option=option, about=facts),
        QUICK if option else "",
        "## In short",
        in_short(outcomes, found),
    ]
    parts += [f"Skipped: {key}: {reason}." for key, reason in skipped.items()]
    parts += [counts_table(outcomes).markdown, verdicts.LEGEND]
    parts += ["## The differences, beside the paper's", figures.get("differences", ""), DIFFERENCES]
    parts += [differences_table(outcomes).markdown, "## Why", *(cause.text for cause in found)]
    parts += ["## Preliminary tests", figures.get("preliminaries", ""), *preliminaries(outcomes)]
    parts += ["## Other claims of the paper", *_claims(outcomes)]
    parts += ["## Every experiment", *(outcomes[e.key].section for e in EXPERIMENTS if e.key in outcomes)]
    if costs is not None:
        parts += ["## What a step costs", cost_table(costs).markdown]
    parts += ["## Sample model against simulator", *_diagnoses(outcomes), _durations(outcomes).markdown]
    return "\n\n".join(part for part in parts if part) + "\n"


DIFFERENCES = """A difference is the mean final average reward of one method less that of another. The paper prints Q of
Tukey's test and no means; a difference is Q·√(MSW / n), with MSW and the degrees of freedom of its analysis of variance
and n repetitions of each method (3 n − 3 degrees of freedom within). Its sign follows from the order of the means, the
only one in which two of the Q add up to the third."""


def _tested(outcomes: Outcomes):
    """Every pair that the paper tests, at every length: outcome, length, our pair, its pair."""
    for key, outcome in outcomes.items():
        if key.startswith("robot_"):
            for length, pairs in outcome.pairs.items():
                for pair in pairs:
                    its = verdicts.papers(pair, outcome.experiment.pairs)
                    if its:
                        yield outcome, length, pair, its


def in_short(outcomes: Outcomes, found: list[Cause]) -> str:
    """What was reproduced, what was not, and why."""
    by_pair: dict[tuple[str, str], list[str]] = {}
    for outcome, _, pair, its in _tested(outcomes):
        if its.p < LEVEL:
            name = (outcome.experiment.task, its.name)
            by_pair.setdefault(name, []).append(verdicts.of_pair(pair, its).name)
    always = [name for name, said in by_pair.items() if all(x == AGREES for x in said)]
    never = [name for name, said in by_pair.items() if not any(x == AGREES for x in said)]
    some = [name for name in by_pair if name not in always + never]
    reverse = {name: said.count(REVERSED) for name, said in by_pair.items() if REVERSED in said}
    lines = []
    if by_pair:
        lines.append(
            f"- **Reproduced.** The paper finds {len(by_pair)} pairs of methods significantly different. The same "
            f"method is significantly better here in every set-up in {len(always)} ({_listed(always)}), in some "
            f"set-ups in {len(some)} ({_listed(some)})."
        )
        lines.append(
            f"- **Not reproduced.** In no set-up: {len(never)} ({_listed(never)}). Significantly the opposite in at "
            f"least one set-up: {len(reverse)} ({_listed(reverse)})."
        )
    lines += [f"- **{cause.title}: {cause.status}.** {cause.summary}" for cause in found if cause.status != NOTHING]
    lines.append(f"- **Opposite, and not explained by an experiment here**:{_unexplained(outcomes, found)}")
    return "\n".join(lines)


def _listed(names) -> str:
    by_task: dict[str, list[str]] = {}
    for task, pair in names:
        by_task.setdefault(task, []).append(pair)
    return "; ".join(f"{task}: {', '.join(pairs)}" for task, pairs in by_task.items()) or "none"


def _unexplained(outcomes: Outcomes, found: list[Cause]) -> str:
    known = frozenset().union(*(cause.explains for cause in found if cause.status == SHOWN))
    left = []
    for key, outcome in outcomes.items():
        if key.startswith("cause_"):
            continue
        for length in outcome.pairs:
            bad = {name: said for name, said in opposites(outcome, length).items() if (key, length, name) not in known}
            if bad:
                words = "; ".join(f"{name}: {said}" for name, said in bad.items())
                left.append(f"  - {outcome.experiment.where}, {length}: {words}")
    return "\n".join(["", *left]) if left else " nothing; no pair is opposite without a cause that is shown"


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


def preliminaries(outcomes: Outcomes) -> list[str]:
    """Verdicts on the choices that the paper made in its preliminary tests."""
    values, pairs = [], []
    for key, title, *_, says in PRELIMINARIES:
        for end, where in (("", "model"), ("_robot", "robot")):
            outcome = outcomes.get(f"preliminary_{key}{end}")
            if outcome is None:
                continue
            means = ", ".join(f"{label}: {mean:.2f}" for label, mean in outcome.means().items())
            if outcome.experiment.best:
                said = of_value(outcome)
                values.append([title, where, means, f"{outcome.experiment.best} is {said.name}", said.best, said.loss,
                               said.p and exact(said.p)])  # fmt: skip
            for pair in outcome.pairs[outcome.longest]:
                its = verdicts.papers(pair, outcome.experiment.pairs)
                if its:
                    pairs.append([title, where, its.name, verdicts.gain(pair, its),
                                  exact(pair.p), str(verdicts.of_pair(pair, its)), says])  # fmt: skip
    columns = ["question", "on the", "means", "verdict", "best", "better by", "p"]
    tables = ["The paper says of its values only that they work well, and that T = 1 has the best results."]
    tables.append(Table("The values that the paper chose", columns, values).markdown)
    columns = ["question", "on the", "pair", "difference", "p", "verdict", "the paper says"]
    return [*tables, Table("The methods that the paper chose", columns, pairs).markdown]


def _claims(outcomes: Outcomes) -> list[str]:
    """What the paper says of traces and of sample models, and what came of it."""
    lines = []
    if traces := outcomes.get("traces"):
        difference, p = traces.pair("reduced", "full")
        word = "agrees: no significant difference" if p >= LEVEL else "does not agree: a significant difference"
        lines.append(f"- Reduced traces have a negligible effect: {word} ({as_text(difference)}, p = {as_text(p)}).")
    ahead = [o.pair("TOSL+QBIASSR", "TOSL+SR")[0] > 0 for key, o in outcomes.items() if key.startswith("model_")]
    if ahead:
        lines.append(
            "- On sample models TOSL+QBIASSR is ahead of TOSL+SR in two of four tasks: "
            f"in {sum(ahead)} of {len(ahead)} here."
        )
    rows = _model_against_robot(outcomes)
    if not rows:
        return ["\n".join(lines)]
    worse, q = sum(row[5] < 0 for row in rows), [row[5] for row in rows if row[2] == "Q+SR"]
    lines.append(
        "- Most processes on models performed worse than in the simulator, Q-learning most of all: here "
        f"{worse} of {len(rows)} are worse on the model; of Q+SR, {sum(x < 0 for x in q)} of {len(q)}."
    )
    columns = ["task", "length", "method", "on the model", "on the robot", "difference", "best on the model"]
    return ["\n".join(lines), Table("Final average reward on model and robot", columns, rows).markdown]


def _model_against_robot(outcomes: Outcomes) -> list[list]:
    rows = []
    for key, model in outcomes.items():
        robot = outcomes.get(key.replace("model_", "robot_"))
        if not key.startswith("model_") or robot is None:
            continue
        for length in model.final:
            there = robot.means(length)
            for label, mean in model.means(length).items():
                difference = mean - there[label]
                rows.append([by_key(key).task, str(length), label, mean, there[label], difference, model.optimum])
    return rows


def _diagnoses(outcomes: Outcomes) -> list[str]:
    return [
        f"What `diagnose()` says of the model of {outcome.experiment.task}:\n\n```\n{outcome.diagnosis}\n```"
        for key, outcome in outcomes.items() if key.startswith("model_")
    ]  # fmt: skip


def _durations(outcomes: Outcomes) -> Table:
    rows = [[key, outcome.seconds] for key, outcome in outcomes.items()]
    return Table("Computing time, all cores together", ["experiment", "seconds"], rows)


def cost_table(costs: list[float]) -> Table:
    """CPU time a step: ours and the paper's, as measured and relative to Q+SR."""
    rows = []
    for (method, traces, its), ours in zip(paper.COST, costs, strict=True):
        relative, its_relative = ours / costs[0], its / paper.COST[0][2]
        same = "same direction" if (relative >= 1) == (its_relative >= 1) else "not the same direction"
        same = same if rows else ""  # the first row is the ruler
        rows.append([method, traces, ours * 1e6, relative, its * 1e6, its_relative, same])
    columns = ["method", "traces", "µs a step", "relative to Q+SR", "paper's µs", "paper's relative", "verdict"]
    return Table("CPU time a step, sample-modelled wander_1k", columns, rows)
