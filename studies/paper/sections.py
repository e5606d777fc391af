"""One section of the report for each experiment: figure, averages, analysis of variance, Tukey's test."""

from paper import paper, verdicts
from paper.experiments import Experiment
from paper.outcome import shortened
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.statistics import Tukey, exact
from rlrobot_edu.experiments.tables import Table


def section(experiment: Experiment, result: Comparison, alt: str) -> str:
    """The section; alt: what the figure shows, in words."""
    lengths, task = experiment.lengths, experiment.where
    shown = f"{lengths[-1]} ({task})."
    if len(lengths) > 1:
        shorter = ", ".join(map(str, lengths[:-1]))
        shown = f"{lengths[-1]} ({task}); as they stood after {shorter}, the same agents are in the tables, too."
    results = {length: shortened(result, length) for length in lengths}
    parts = [
        f"### {experiment.title}",
        f"{shown} The paper: {experiment.says}",
        f"![{alt}]({experiment.key}.png)",
        _joined([results[length].table() for length in lengths], lengths).markdown,
        anova_table(experiment, results).markdown,
        tukey_table(experiment, results).markdown,
    ]
    return "\n\n".join(parts)


def _joined(tables: list[Table], lengths) -> Table:
    rows = [[str(n), *row] for n, table in zip(lengths, tables, strict=True) for row in table.rows]
    return Table(tables[0].caption, ["length", *tables[0].columns], rows)


def anova_table(experiment: Experiment, results) -> Table:
    """The analysis of variance at each length, and the paper's below."""
    rows = []
    for length, result in results.items():
        ours = result.anova()
        sums = [ours.ss_between, ours.df_between, ours.ss_within, ours.df_within]
        rows.append([str(length), *sums, ours.f, exact(ours.p), str(ours.eta_squared)])
    if experiment.pairs and experiment.pairs == paper.TUKEY.get(experiment.task):  # the same three methods
        its, f, p = paper.ANOVA[experiment.task]
        rows.append(["the paper", its.ss_between, its.df_between, its.ss_within, its.df_within, f, p, ""])
    columns = ["length", "between: sum of squares", "df", "within: sum of squares", "df", "F", "p-value", "η² [95 %]"]
    return Table("Analysis of variance", columns, rows)


def tukey_table(experiment: Experiment, results) -> Table:
    """Tukey's test at each length, with the paper's numbers and a verdict beside each pair."""
    rows = []
    for length, result in results.items():
        for pair in Tukey.of(result.final).pairs:
            row = [str(length), f"{pair.first} vs {pair.second}", pair.q, exact(pair.p), pair.inference]
            row += [pair.difference, str(pair.g)]
            its = verdicts.papers(pair, experiment.pairs)
            rows.append([*row, its and its.q, its and its.p, str(verdicts.of_pair(pair, its)) if its else ""])
    columns = ["length", "pair", "HSD Q statistic", "HSD p-value", "HSD inference", "difference", "Hedges g [95 %]"]
    return Table("Post-hoc Tukey HSD test", [*columns, "paper's Q", "paper's p", "verdict"], rows)
