"""Which bias helps, when, and how much? Runs the comparison and writes docs/bias.md and its picture.

``python studies/bias_study.py`` takes some hours of one core and keeps every finished repetition in results/bias, from
where it goes on; ``--quick`` is a trial, 5 repetitions on the sample models, and writes nothing. ``--robots TASK …``
and ``--models TASK …`` run some tasks alone; then the page is of these.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from bias_page import write_page
from bias_verdicts import BLIND_LABEL, COARSE_LABEL, Outcome, outcomes_of
from coarse import COARSE
from paper.experiments import Length

import rlrobot_edu as rl
from rlrobot_course.lesson_22.biases import BIASES
from rlrobot_edu.tools.blind import BLIND

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"
BIASED = ("QBIASSR", "VBIASSR", "OBIASSR", "FBIASSR", "TBIASSR")

# Judged early and late. The late one is run; the early one is its beginning.
LENGTHS = {
    "wander_1k": (Length(300), Length(3600)),
    "giraff_wander_1k": (Length(300), Length(1800)),
    "wander_simple": (Length(60), Length(300)),
    "giraff_wander_simple": (Length(60), Length(300)),
    "worked_example": (Length(2, "episodes"), Length(10, "episodes")),
    "arm_1k": (Length(1, "episodes"), Length(10, "episodes")),
    "arm_4k": (Length(1, "episodes"), Length(10, "episodes")),
    "wander_4k": (Length(300), Length(3600)),
    "giraff_wander_4k": (Length(300), Length(1800)),
    "mobile_arm_2k": (Length(1, "episodes"), Length(10, "episodes")),
    "wander_12k": (Length(300), Length(3600)),
    "navigation_1k": (Length(1, "episodes"), Length(3, "episodes")),
}
KINEMATIC = ("arm_1k", "arm_4k", "mobile_arm_2k")  # where PyBullet would take 2 ms a step
REPETITIONS = {"robot": 30, "model": 100}


def share_of_s(task: rl.Task) -> float:
    """How much of Q(s) is in QBIASSR's bias(s): with all input bins b, the mean of 1 / b."""
    return float(np.mean([1 / bins for bins in task.states.shape]))


def methods(task: rl.Task) -> dict[str, dict]:
    """What is compared: the biased selections at T = 1, and SR at three temperatures.

    1, the default; 1 / (1 + c), at which SR counts Q(s) as QBIASSR does; and 1/2, as cold as any of the biased ones can
    become by its bias, where all states of the sets agree.
    """
    temperatures = {"SR": 1.0, "SR, colder": 1 / (1 + share_of_s(task)), "SR, half": 0.5}
    sr = {label: {"method": "TOSL+SR", "temperature": t} for label, t in temperatures.items()}
    others = {bias.name: rl.Method("TOSL", bias) for bias in BIASES}
    return sr | {name: {"method": others.get(name, f"TOSL+{name}")} for name in BIASED} | seeing_little(task)


def seeing_little(task: rl.Task) -> dict[str, dict]:
    """Who sees nothing, and, where there are lasers alone and more than two bins, who sees whether a wall is near."""
    who = {BLIND_LABEL: {"method": BLIND, "loop_evasion": False}}
    if all(variable.name.startswith("laser") for variable in task.inputs) and max(task.states.shape) > 2:
        who[COARSE_LABEL] = {"method": COARSE, "loop_evasion": False}
    return who


def study(name: str, where: str, folder: Path | None, repetitions: int, n_jobs: int) -> Iterator[Outcome]:
    """The comparison in one task, on its robot or on a sample model of its recording, judged early and late."""
    task, late = rl.load_task(name), LENGTHS[name][-1]
    world = task if where == "robot" else rl.SampleModel.from_recording(rl.read_recording(name), unseen="uniform")
    result = rl.compare(
        world, methods(task), repetitions, **{late.unit: late.number}, n_jobs=n_jobs, progress=False,
        engine="kinematic" if where == "robot" and name in KINEMATIC else None,
        store=folder and folder / f"{where}_{name}",
    )  # fmt: skip
    return outcomes_of(task, where, result, LENGTHS[name])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a trial, which writes nothing")
    for world in ("models", "robots"):
        parser.add_argument(f"--{world}", nargs="*", default=list(LENGTHS), choices=list(LENGTHS), metavar="TASK")
    parser.add_argument("--n-jobs", type=int, default=-1)
    parser.add_argument("--store", type=Path, default=HERE.parent / "results" / "bias")
    given = parser.parse_args()
    found = []
    for where, names in (("model", given.models), ("robot", [] if given.quick else given.robots)):
        for name in names:
            repetitions = 5 if given.quick else REPETITIONS[where]
            for outcome in study(name, where, None if given.quick else given.store, repetitions, given.n_jobs):
                found.append(outcome)
                print(outcome, flush=True)
    if not given.quick:
        print(write_page(found, DOCS))


if __name__ == "__main__":
    main()
