"""What do the sample models say on the paper's own data? Measures it, and writes docs/studies/authors_recording.md.

``python studies/authors_recording.py`` needs the recording of the paper's authors, see vrep_comparison.py, and takes
a quarter of an hour; what it finds is kept in authors_recording.csv, and ``--page`` writes the page from that alone.
"""

from __future__ import annotations

import csv
import io
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np
from authors_recording_page import page
from joblib import Parallel, delayed
from paper.experiments import FAULTY, PRELIMINARIES
from paper.run import faulty_run
from vrep_comparison import HOUR, vrep_recording
from vrep_worlds import STEPS, TASK

import rlrobot_edu as rl
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.transitions import Transitions

HERE = Path(__file__).parent
FILE = HERE / "authors_recording.csv"
PAGE = HERE.parent / "docs" / "studies" / "authors_recording.md"
SEED, LIFE = 0, 3600
# Agents of each method with all hours, with one left out, and in our recordings
ALL, WITHOUT, OTHER = 300, 500, 100
# Agents of Q-learning with the fault, which is slow
FAULTY_ALL, FAULTY_OTHER = 200, 10
THREE = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")
FIVE = (*THREE, "SL+SR", "SARSA+SR")
TRACES = ("λ = 0", "λ = 0.5", "λ = 0.9")  # those that are tried without an hour, too
OWN = range(1, 7)  # seeds of recordings that are made here
ROBOTS = {"ideal": rl.Realism(), "vrep": rl.Realism.vrep()}


class World(NamedTuple):
    """A sample model, what learns in it, how many of each method, and of Q-learning with the fault."""

    model: rl.SampleModel
    methods: Mapping[str, Mapping]
    agents: int
    faulty: int


def values(*keys: str) -> dict[str, Mapping]:
    """The values of λ, α, γ and T that the report tries in these of its preliminary tests, by label."""
    tried: dict[str, Mapping] = {}
    for key, _, methods, _ in PRELIMINARIES:
        if key in keys:
            tried |= methods
    return tried


def without_hour(recording: rl.Recording, hour: int) -> rl.Recording:
    """The recording without the steps of one hour, counted from 1."""
    n = np.arange(len(recording))
    kept = n // HOUR != hour - 1
    columns = [column[kept] for column in recording.transitions]
    return rl.Recording(Transitions(*columns), recording.source, recording.task)


def own_recording(realism: rl.Realism, seed: int) -> rl.Recording:
    """As many steps of our robot as the authors recorded of theirs, chosen likewise by TOSL+SR."""
    agent = rl.Agent(TASK, "TOSL+SR", seed=seed)
    return rl.record(agent, rl.make_env(TASK, seed, realism=realism), STEPS)


def worlds() -> Iterator[tuple[str, World]]:
    """The worlds by name, made one by one."""
    authors = vrep_recording()
    of_five = {label: {"method": label} for label in FIVE}
    of_three = {label: {"method": label} for label in THREE}
    tried = values("lambda", "alpha", "gamma", "temperature")
    few = {label: tried[label] for label in TRACES}
    model = rl.SampleModel.from_recording
    yield "authors", World(model(authors), of_five | tried, ALL, FAULTY_ALL)
    for unseen in ("siblings", "stay"):
        yield f"authors, {unseen}", World(model(authors, unseen), of_five, ALL, 0)
    for hour in range(1, STEPS // HOUR + 1):
        rest = model(without_hour(authors, hour))
        name = f"authors without hour {hour}"
        yield name, World(rest, of_three | few, WITHOUT, 0)
    recordings = Parallel(n_jobs=-1)(
        delayed(own_recording)(realism, seed)
        for realism in ROBOTS.values()
        for seed in OWN
    )
    names = [f"{robot} {seed}" for robot in ROBOTS for seed in OWN]
    for name, recording in zip(names, recordings, strict=True):
        yield name, World(model(recording), of_three, OTHER, FAULTY_OTHER)


def measured(world: World) -> dict[str, np.ndarray]:
    """Final average rewards by method, arrays (agents,)."""
    result = rl.compare(
        world.model, world.methods, world.agents, steps=LIFE, seed=SEED, progress=False
    )
    found = dict(result.final)
    if world.faulty:
        seeds = np.random.SeedSequence(SEED, spawn_key=(1,)).spawn(world.faulty)
        runs = Parallel(n_jobs=-1)(
            delayed(faulty_run)(world.model, LIFE, seed) for seed in seeds
        )
        found[FAULTY] = np.array([run.final_average_reward for run in runs])
    return found


def measure() -> str:
    """The whole file: of each world and method the number of agents, their mean and their standard deviation."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["world", "method", "n", "mean", "sd"])
    for name, world in worlds():
        for label, x in measured(world).items():
            writer.writerow(
                [name, label, len(x), f"{x.mean():.5f}", f"{x.std(ddof=1):.5f}"]
            )
        print(name, flush=True)
    return text.getvalue()


def main() -> None:
    """Measure, unless only the page is wanted, and write."""
    if "--page" not in sys.argv:
        write_whole(FILE, measure())
    write_whole(PAGE, page(FILE))


if __name__ == "__main__":
    main()
