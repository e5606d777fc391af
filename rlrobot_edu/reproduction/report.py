"""The page of the reproduction: every table of ours beside the paper's, and in what they agree."""

from typing import NamedTuple

from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.statistics import Pair, inference
from rlrobot_edu.experiments.tables import Table, as_text
from rlrobot_edu.reproduction.paper import ANOVA, COST, EXPERIMENTS, Experiment, PaperPair

INTRODUCTION = """# The paper's experiments, run again

Written by `python -m rlrobot_edu reproduce{option}`, with {about}.

Everything is run with the same default parameters, nothing is tuned for a task, and nothing is left out. A verdict says
whether the better method of a pair is the same as in the paper (*direction*), and whether Tukey's test puts the pair
into the same class: p<0.01, p<0.05 or neither (*significance*). Where the paper gives no number for a pair, only the
direction can be compared. The averages of all repetitions are in [averages.csv](averages.csv), versions and seed in
[environment.json](environment.json)."""

CAUSES = """## Where ours differs, and what is known of the cause

- **Other worlds.** The paper used V-REP and a real robot; ours is a two-dimensional simulation (pymunk) and an arm in
  PyBullet, in scenes drawn after the paper's figures. How a robot slides along a wall decides what it is rewarded for.
- **Another program.** The paper's program differed from its equations in places: Q-learning sampled what happens next
  before it selected its action, and some bins could not be reached. Ours follows the equations.
- **Few repetitions.** The paper has six of each method in wander-1K and wander-4K (df = 15) and three in the navigation
  (df = 6); a test on so few misses differences that thirty show.
- **Unknown lengths.** Its processes last from 1 to 60 minutes; it does not say which task lasts how long.
- **Models that promise too much.** In a sample model, a pair that was seen once always answers the same. A learner that
  settles early (large α, small γ, low T) is paid for it there: it finds a rewarded loop which the robot does not have.
  See the last section for how many such loops each model has."""


class Outcome(NamedTuple):
    """What the page needs of an experiment once its repetitions are gone.

    text: its section; pairs: of Tukey's test; means: final average reward by label; optimum, diagnosis: of its model
    """

    text: str
    pairs: tuple[Pair, ...]
    means: dict[str, float]
    optimum: float | None
    diagnosis: str

    @classmethod
    def of(cls, experiment: Experiment, result: Comparison, alt: str) -> "Outcome":
        """The outcome of an experiment; `alt` says in words what its figure shows."""
        means = {label: float(final.mean()) for label, final in result.final.items()}
        diagnosis = str(result.world.diagnose()) if experiment.model else ""
        return cls(section(experiment, result, alt), result.tukey().pairs, means, result.optimum, diagnosis)


def page(outcomes: dict[str, Outcome], skipped: dict[str, str], costs: list[float] | None, about: dict) -> str:
    """The whole page, in Markdown."""
    option = " --quick" if about["set"] == "quick" else ""
    facts = ", ".join(f"{name} {value}" for name, value in about.items() if name != "set")
    parts = [INTRODUCTION.format(option=option, about=facts), "## All verdicts"]
    parts += [_summary(outcomes, skipped).markdown, CAUSES]
    for experiment in EXPERIMENTS:
        if experiment.key in outcomes:
            parts.append(outcomes[experiment.key].text)
        elif experiment.key in skipped:
            parts += [f"## {experiment.title}", f"Skipped: {skipped[experiment.key]}."]
    if costs is not None:
        parts += ["## What a step costs", cost_table(costs).markdown]
    parts += _model_against_robot(outcomes)
    return "\n\n".join(parts) + "\n"


def section(experiment: Experiment, result: Comparison, alt: str) -> str:
    """One experiment: figure, averages, analysis of variance and Tukey's test, the paper's beside ours."""
    parts = [
        f"## {experiment.title}",
        f"{experiment.steps} steps. The paper: {experiment.says}",
        f"![{alt}]({experiment.key}.png)",
        result.table().markdown,
        anova_table(experiment, result).markdown,
        tukey_table(experiment, result).markdown,
    ]
    return "\n\n".join(parts)


def anova_table(experiment: Experiment, result: Comparison) -> Table:
    """The analysis of variance in the paper's layout, with the paper's beside it where there is one."""
    ours = result.anova()
    table = ours.table(experiment.task)
    if experiment.model or experiment.task not in ANOVA:
        return table
    paper, f, p = ANOVA[experiment.task]
    same = "same" if inference(ours.p) == inference(p) else "not the same"
    beside = [
        [paper.ss_between, paper.df_between, f, p, f"{same} significance"],
        [paper.ss_within, paper.df_within, None, None, ""],
        [paper.ss_between + paper.ss_within, paper.df_between + paper.df_within, None, None, ""],
    ]
    columns = [*table.columns, *(f"paper's {name}" for name in ("sum of squares", "df", "F", "p")), "verdict"]
    return Table(table.caption, columns, [[*a, *b] for a, b in zip(table.rows, beside, strict=True)])


def tukey_table(experiment: Experiment, result: Comparison) -> Table:
    """Tukey's test in the paper's layout, with the paper's numbers and a verdict beside each pair."""
    pairs = result.tukey()
    table = pairs.table(experiment.task)
    rows = []
    for row, pair in zip(table.rows, pairs.pairs, strict=True):
        paper = of_the_paper(experiment, pair)
        beside = [paper.q, paper.p, verdict(pair, paper)] if paper else [None, None, ""]
        rows.append([*row, *beside])
    return Table(table.caption, [*table.columns, "paper's Q", "paper's p", "verdict"], rows)


def of_the_paper(experiment: Experiment, pair: Pair) -> PaperPair | None:
    """What the paper says about these two methods."""
    same = (p for p in experiment.pairs if {p.better, p.worse} == {pair.first, pair.second})
    return next(same, None)


def verdict(pair: Pair, paper: PaperPair) -> str:
    """In what our pair of methods agrees with the paper's."""
    ours_better = pair.first if pair.difference > 0 else pair.second
    direction = "same direction" if ours_better == paper.better else "not the same direction"
    if paper.p is None:
        return f"{direction} (ours {pair.inference or 'not significant'})"
    if pair.inference == inference(paper.p):
        return f"{direction}, same significance"
    words = [text or "not significant" for text in (pair.inference, inference(paper.p))]
    return f"{direction}, not the same significance (ours {words[0]}, the paper's {words[1]})"


def cost_table(costs: list[float]) -> Table:
    """CPU time a step: ours and the paper's, as measured and relative to Q+SR."""
    rows = []
    for (method, traces, paper), ours in zip(COST, costs, strict=True):
        relative, paper_relative = ours / costs[0], paper / COST[0][2]
        same = "same direction" if (relative >= 1) == (paper_relative >= 1) else "not the same direction"
        same = same if rows else ""  # the first row is the ruler
        rows.append([method, traces, ours * 1e6, relative, paper * 1e6, paper_relative, same])
    columns = ["method", "traces", "µs a step", "relative to Q+SR", "paper's µs", "paper's relative", "verdict"]
    return Table("CPU time a step, sample-modelled wander_1k", columns, rows)


def _summary(outcomes: dict[str, Outcome], skipped: dict[str, str]) -> Table:
    rows = [[key, "", f"skipped: {reason}"] for key, reason in skipped.items()]
    biased = []
    for experiment in (e for e in EXPERIMENTS if e.key in outcomes):
        for pair in outcomes[experiment.key].pairs:
            name, paper = f"{pair.first} vs {pair.second}", of_the_paper(experiment, pair)
            if paper:
                rows.append([experiment.key, name, verdict(pair, paper)])
            elif experiment.key == "traces":
                same = "same" if not pair.inference else "not the same"
                words = f"difference {as_text(pair.difference)}, p = {as_text(pair.p)}; the paper's is negligible"
                rows.append([experiment.key, name, f"{same}: {words}"])
            elif experiment.model and {pair.first, pair.second} == {"TOSL+QBIASSR", "TOSL+SR"}:
                biased.append(pair.difference > 0)
    if biased:
        words = f"TOSL+QBIASSR is ahead in {sum(biased)} of {len(biased)}; in the paper in 2 of 4"
        rows.append(["model_*", "TOSL+QBIASSR vs TOSL+SR", words])
    return Table("Ours and the paper's", ["experiment", "pair", "verdict"], rows)


def _model_against_robot(outcomes: dict[str, Outcome]) -> list[str]:
    """Sample model and simulator side by side, and the weak points of each model."""
    diagnoses, rows = [], []
    for experiment in EXPERIMENTS:
        model, robot = outcomes.get(f"model_{experiment.task}"), outcomes.get(f"robot_{experiment.task}")
        if experiment.key != f"model_{experiment.task}" or model is None or robot is None:
            continue
        for label, on_model in model.means.items():
            on_robot = robot.means[label]
            same = "same direction" if on_model < on_robot else "not the same direction"
            rows.append([experiment.task, label, on_model, on_robot, on_model - on_robot, model.optimum, same])
        diagnoses.append(f"What `diagnose()` says of the model of {experiment.task}:\n\n```\n{model.diagnosis}\n```")
    if not rows:
        return []
    columns = ["task", "method", "on the model", "on the robot", "difference", "best on the model", "verdict"]
    says = "The paper: most processes on sample models performed worse than in the simulator, Q-learning most of all."
    return [
        "## Sample model against simulator",
        says,
        Table("Final average reward", columns, rows).markdown,
        *diagnoses,
    ]
