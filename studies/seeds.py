"""How many verdicts on the paper's pairs stay with another seed? Measures it on the kinematic robots: seeds.csv.

``python studies/seeds.py`` takes some minutes. Of each seed it runs the report's experiments of all robots that have a
kinematic engine; ``python studies/reproduce.py --engine kinematic --seed 1`` runs the same and all others.
"""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import NamedTuple

from paper.experiments import EXPERIMENTS, Experiment
from paper.outcome import Outcome
from paper.run import run_experiment, shortened

from rlrobot_edu.files import write_whole

FILE = Path(__file__).parent / "seeds.csv"
SEEDS = (0, 1)
STORES = Path("results/seeds")


class Row(NamedTuple):
    """One pair of the paper at one length with one seed: how much its better method gains, and Tukey's p."""

    seed: int
    task: str
    length: str
    better: str
    worse: str
    gain: float
    p: float
    verdict: str


def read(file: Path = FILE) -> list[Row]:
    """The rows of the file."""
    with file.open(encoding="utf-8", newline="") as lines:
        return [
            Row(int(x["seed"]), x["task"], x["length"], x["better"], x["worse"],
                float(x["gain"]), float(x["p"]), x["verdict"])
            for x in csv.DictReader(lines)
        ]  # fmt: skip


def measured(experiment: Experiment, seed: int) -> list[Row]:
    """The rows of one experiment with one seed; none if the robot has no kinematic engine."""
    stores = STORES / str(seed)
    try:
        result = run_experiment(experiment, False, stores, "kinematic", seed)
    except (LookupError, ImportError):
        return []
    finals = {length: shortened(result, length).final for length in experiment.lengths}
    outcome = Outcome(experiment, finals)
    rows = []
    for length in experiment.lengths:
        for one in outcome.judged(length):
            names = one.pair.better, one.pair.worse
            rows.append(
                Row(
                    seed, experiment.task, str(length), *names,
                    one.gain, one.p, one.verdict.name,
                )
            )  # fmt: skip
    return rows


def main() -> None:
    """Measure and write."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(Row._fields)
    for experiment in EXPERIMENTS:
        if experiment.key.startswith("robot_") and experiment.pairs:
            for seed in SEEDS:
                for row in measured(experiment, seed):
                    writer.writerow(
                        row._replace(gain=round(row.gain, 5), p=float(f"{row.p:.4g}"))
                    )
            print(experiment.key, flush=True)
    write_whole(FILE, text.getvalue())


if __name__ == "__main__":
    main()
