"""What the paper says without a test of its own: its choices in the preliminary tests, traces, models, costs."""

from paper import paper, verdicts
from paper.cause import Outcomes, of_value, p_words, paired
from paper.experiments import PRELIMINARIES, by_key
from paper.verdicts import LEVEL
from rlrobot_edu.experiments.statistics import exact
from rlrobot_edu.experiments.tables import Table, as_text


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
                word = f"{outcome.experiment.best} is {said.name}"
                p = None if said.p is None else exact(said.p)
                values.append([title, where, means, word, said.best, said.loss or None, p])
            for pair, its in paired(outcome, outcome.longest):
                pairs.append([title, where, its.name, verdicts.gain(pair, its),
                              exact(pair.p), str(verdicts.of_pair(pair, its)), says])  # fmt: skip
    columns = ["question", "on the", "means", "verdict", "best", "better by", "p"]
    tables = ["The paper says of its values only that they work well, and that T = 1 has the best results."]
    tables.append(Table("The values that the paper chose", columns, values).markdown)
    columns = ["question", "on the", "pair", "difference", "p", "verdict", "the paper says"]
    return [*tables, Table("The methods that the paper chose", columns, pairs).markdown]


def claims(outcomes: Outcomes) -> list[str]:
    """What the paper says of traces and of sample models, and what came of it."""
    lines = []
    if traces := outcomes.get("traces"):
        difference, p = traces.pair("reduced", "full")
        word = "agrees: no significant difference" if p >= LEVEL else "does not agree: a significant difference"
        lines.append(f"- Reduced traces have a negligible effect: {word} ({as_text(difference)}, {p_words(p)}).")
    pairs = [o.pair("TOSL+QBIASSR", "TOSL+SR") for key, o in outcomes.items() if key.startswith("model_")]
    ahead = [p < LEVEL for difference, p in pairs if difference > 0]
    if pairs:
        lines.append(
            "- On sample models TOSL+QBIASSR is ahead of TOSL+SR in two of four tasks: "
            f"in {len(ahead)} of {len(pairs)} here, significantly in {sum(ahead)}."
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


def diagnoses(outcomes: Outcomes) -> list[str]:
    """What is weak in each model."""
    return [
        f"What `diagnose()` says of the model of {outcome.experiment.task}:\n\n```\n{outcome.diagnosis}\n```"
        for key, outcome in outcomes.items() if key.startswith("model_")
    ]  # fmt: skip


def durations(outcomes: Outcomes) -> Table:
    """How long each experiment took."""
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
