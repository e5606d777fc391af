"""The tables of `check_task`: what a robot read, perceived, did and was given in some trials."""

from collections.abc import Iterable, Sequence

import numpy as np

from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.tools.trial import Trial


def shares_of_bins(task: Task, seen: Iterable[Trial], i: int) -> np.ndarray:
    """In which part of the steps each bin of input `i` was met."""
    states = np.concatenate([trial.transitions.s_next for trial in seen])
    return np.bincount(
        np.unravel_index(states, task.states.shape)[i], minlength=task.states.shape[i]
    ) / len(states)


def extremes(seen: Sequence[Trial], name: str) -> tuple[float, float]:
    """The smallest and the largest that a reading was."""
    low, high = zip(*(trial.read[name] for trial in seen), strict=True)
    return min(low), max(high)


def readings_table(task: Task, seen: Sequence[Trial]) -> Table:
    """The lowest and highest of each reading, beside its limits and cuts."""
    card, rows = ROBOTS[task.robot], []
    cut = {
        v.name: f"{v.sectors} sectors"
        if v.sectors
        else str(v.cuts or v.values).strip("(,)")
        for v in task.inputs
    }
    for name, (unit, low, high) in (card.sensors | card.stops).items():
        rows.append(
            (
                name,
                unit,
                *map("{:.3g}".format, (*extremes(seen, name), low, high)),
                cut.get(name, ""),
            )
        )
    head = (
        "reading",
        "unit",
        "lowest seen",
        "highest seen",
        "at least",
        "at most",
        "cuts",
    )
    return Table("What it reads, in all trials", head, rows)


def inputs_table(task: Task, trials: Iterable[Trial]) -> Table:
    """How often each bin of an input was met, in each trial."""
    rows = []
    for i, variable in enumerate(task.states.inputs):
        met = (
            map("{:.0%}".format, shares_of_bins(task, [trial], i)) for trial in trials
        )
        rows.append((variable.name, *map(" ".join, met)))
    return Table(
        "What it perceives: share of the steps in each bin",
        ("input", "at random", "while learning"),
        rows,
    )


def when_given(task: Task, trial: Trial, r: float) -> tuple[int, str, str]:
    """In how many steps a reward was given, their share, and the state in which most of them began."""
    states = trial.transitions.s[trial.transitions.r == r]
    times = np.bincount(states, minlength=1)
    place = ", ".join(
        f"{name} {part}"
        for name, part in task.states.decode(int(times.argmax())).items()
    )
    return (
        len(states),
        f"{len(states) / len(trial.moved):.1%}",
        f"{place} ({times.max()})" if len(states) else "",
    )


def actions_table(task: Task, trial: Trial) -> Table:
    """How often each action changed a reading, and what it earned."""
    rows = []
    for a in range(task.actions.n):
        mine = trial.transitions.a == a
        mean = float(trial.transitions.r[mine].mean()) if mine.any() else None
        rows.append(
            (
                a,
                task.actions.label(a),
                f"{trial.moved[mine].mean():.0%}" if mine.any() else "",
                mean,
            )
        )
    return Table(
        "What it does, at random",
        ("action", "", "changes a reading", "average reward"),
        rows,
    )
