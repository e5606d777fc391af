"""The tables of the report, by the name of the block that each fills; all but the costs follow from averages.csv."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from in_markdown import in_markdown
from scipy import stats

from paper import paper
from paper.experiments import FAULTY, PRELIMINARIES, Experiment
from paper.outcome import Outcome, detectable, significant_with
from paper.tally import lost_by_holm, tally_table
from paper.verdicts import DIRECTION, LEVEL
from rlrobot_edu.experiments.statistics import Anova, marked_p, shown_p
from rlrobot_edu.experiments.tables import Table

Outcomes = Mapping[str, Outcome]
SR, Q = paper.THREE[1:]
LOST = "†"  # the mark of a pair that is not significant after Holm's correction
CHANGES = (
    "walls",
    "contact",
    "traces",
    "evasion",
)  # experiments cause_..., each of which changes one thing of a task


def tables(outcomes: Outcomes) -> dict[str, str]:
    """All tables that have rows, in Markdown."""
    made = {}
    for task in dict.fromkeys(o.experiment.task for o in outcomes.values()):
        made[f"pairs of {task}"] = pairs_table(outcomes, task)
        made[f"set-ups of {task}"] = set_ups_table(outcomes, task)
        made[f"changes in {task}"] = changes_table(outcomes, task)
    made |= {
        "tally": tally_table(outcomes),
        "TOSL against Q-learning": order_table(outcomes),
        "few repetitions": few_table(outcomes),
    }
    made |= {"values": values_table(outcomes), "methods": methods_table(outcomes)}
    return {name: in_markdown(table) for name, table in made.items() if table.rows}


def mean_and_half(values: np.ndarray) -> str:
    """A mean and half of its 95 % interval (Student's t)."""
    return f"{values.mean():.2f} ± {stats.t.ppf(0.975, len(values) - 1) * stats.sem(values):.2f}"


def set_up(experiment: Experiment) -> str:
    """The set-up in words, without its task."""
    return experiment.title.removesuffix(f": {experiment.task}")


def pairs_table(outcomes: Outcomes, task: str) -> Table:
    """The paper's differences of this task, and ours at each length."""
    rows, lost = [], lost_by_holm(outcomes)
    for o in (outcomes[f"robot_{task}"],) if f"robot_{task}" in outcomes else ():
        for length, groups in o.final.items():
            for one in o.judged(length):
                its, ours = one.pair, one.ours
                is_lost = (task, str(length), its.name) in lost
                rows.append([
                    str(length), f"{its.better} less {its.worse}", paper.difference(task, its), its.q, its.p,
                    one.gain, detectable(groups), shown_p(ours.p), marked_p(ours.games_howell, ours.tests_disagree),
                    f"{one.verdict} {LOST}" if is_lost else str(one.verdict),
                ])  # fmt: skip
    columns = [
        "length",
        "pair",
        "the paper's difference",
        "its Q",
        "its p",
        "ours",
        "detectable",
        "our p",
        "Games-Howell p",
        "verdict",
    ]
    return Table(f"{task}: differences of mean final average rewards", columns, rows)


def set_ups_table(outcomes: Outcomes, task: str) -> Table:
    """Means of the three methods in every set-up of a task, with F and p of the analysis of variance."""
    rows: list[list] = []
    for o in outcomes.values():
        if o.experiment.task == task and set(o.experiment.methods) == set(paper.THREE):
            for length, groups in o.final.items():
                cells, anova = (
                    [mean_and_half(groups[label]) for label in paper.THREE],
                    Anova.of(list(groups.values())),
                )
                rows.append(
                    [
                        set_up(o.experiment),
                        str(length),
                        len(groups[Q]),
                        *cells,
                        anova.f,
                        shown_p(anova.p),
                    ]
                )
    if task in paper.ANOVA:
        _, f, p = paper.ANOVA[task]
        rows.insert(
            0, ["the paper", None, paper.repetitions(task), None, None, None, f, p]
        )
    columns = ["set-up", "length", "n", *paper.THREE, "F", "p"]
    return Table(
        f"{task}: final average reward, mean ± half of its 95 % interval", columns, rows
    )


def changes_table(outcomes: Outcomes, task: str) -> Table:
    """Pairs that are opposite to the paper's, or of which the verdict is another once one thing is changed."""
    rows = []
    for changed in (outcomes.get(f"cause_{kind}_{task}") for kind in CHANGES):
        for length in changed.final if changed else ():
            before = outcomes[f"robot_{task}"].judged(length)
            for was, now in zip(before, changed.judged(length), strict=True):
                if was.verdict.is_opposite or was.verdict.name != now.verdict.name:
                    p = marked_p(now.p, now.ours.tests_disagree)
                    rows.append([
                        set_up(changed.experiment), str(length), f"{was.pair.better} less {was.pair.worse}",
                        was.gain, now.gain, p, str(was.verdict), str(now.verdict),
                    ])  # fmt: skip
    columns = [
        "what is changed",
        "length",
        "pair",
        "before",
        "after",
        "p after",
        "verdict before",
        "verdict after",
    ]
    return Table(f"{task}: one thing changed", columns, rows)


def order_table(outcomes: Outcomes) -> Table:
    """TOSL against Q-learning, both with softmax, wherever both were run in wander_1k."""
    rows = []
    for o in outcomes.values():
        if o.experiment.task == "wander_1k" and {SR, Q} <= set(
            o.experiment.methods
        ) <= set(paper.THREE):
            q = FAULTY if o.experiment.faulty else Q
            means, ours = o.means(), o.tested(SR, q)
            p = marked_p(ours.p, ours.tests_disagree)
            rows.append(
                [set_up(o.experiment), means[SR], means[q], means[SR] - means[q], p]
            )
    return Table(
        "TOSL+SR and Q+SR in wander_1k", ["set-up", SR, Q, f"{SR} less {Q}", "p"], rows
    )


def few_table(outcomes: Outcomes) -> Table:
    """Pairs that are significant only here: how often as few of our repetitions as the paper has find them."""
    rows = []
    for key, o in outcomes.items():
        n = (
            paper.repetitions(o.experiment.task)
            if key.startswith("robot_") and o.experiment.pairs
            else np.inf
        )
        for length, groups in o.final.items():
            only_ours = [
                x
                for x in o.judged(length)
                if x.verdict.name == DIRECTION and x.p < LEVEL
            ]
            if only_ours and n < min(map(len, groups.values())):
                share = significant_with(groups, int(n))
                rows += [[o.experiment.task, str(length), x.pair.name, n,
                          f"{share[frozenset((x.pair.better, x.pair.worse))]:.0%}"] for x in only_ours]  # fmt: skip
    columns = ["task", "length", "pair", "the paper's repetitions", "significant in"]
    return Table(
        "Draws of only the paper's number of our repetitions in which a pair is significant",
        columns,
        rows,
    )


def values_table(outcomes: Outcomes) -> Table:
    """The values that the paper chose."""
    rows = []
    for title, where, o in _preliminary(outcomes):
        if chosen := o.experiment.best:
            means = ", ".join(
                f"{label}: {mean:.2f}" for label, mean in o.means().items()
            )
            name, best, loss, ours = o.value()
            rows.append(
                [
                    title,
                    where,
                    means,
                    f"{chosen} is {name}",
                    best,
                    loss or None,
                    detectable(o.final[o.longest]),
                    None if ours is None else marked_p(ours.p, ours.tests_disagree),
                ]
            )
    columns = [
        "question",
        "on the",
        "means",
        "verdict",
        "best",
        "better by",
        "detectable",
        "p",
    ]
    return Table("The values that the paper chose", columns, rows)


def methods_table(outcomes: Outcomes) -> Table:
    """The methods that the paper chose."""
    rows = [
        [
            title, where, one.pair.name, one.gain, detectable(o.final[o.longest]),
            marked_p(one.p, one.ours.tests_disagree), str(one.verdict),
        ]
        for title, where, o in _preliminary(outcomes) for one in o.judged()
    ]  # fmt: skip
    columns = ["question", "on the", "pair", "difference", "detectable", "p", "verdict"]
    return Table("The methods that the paper chose", columns, rows)


def _preliminary(outcomes: Outcomes) -> Iterable[tuple[str, str, Outcome]]:
    """The preliminary tests: the question, where it is asked, and what came of it."""
    for key, title, *_ in PRELIMINARIES:
        for name, where in (
            (f"preliminary_{key}", "model"), (f"preliminary_{key}_robot", "robot"),
            (f"cause_walls_{key}", "robot that walls hold"),
            (f"cause_walls_{key}_qbiassr", "same with TOSL+QBIASSR"),
        ):  # fmt: skip
            if name in outcomes:
                yield title, where, outcomes[name]


def cost_table(costs: Sequence[float]) -> Table:
    """CPU time a step: ours and the paper's, as measured and relative to Q+SR."""
    rows = []
    for (method, traces, its), ours in zip(paper.COST, costs, strict=True):
        rows.append(
            [
                method,
                traces,
                ours * 1e6,
                ours / costs[0],
                its * 1e6,
                its / paper.COST[0][2],
            ]
        )
    columns = [
        "method",
        "traces",
        "µs a step",
        "relative to Q+SR",
        "paper's µs",
        "paper's relative",
    ]
    return Table("CPU time a step, sample-modelled wander_1k", columns, rows)
