"""The tables of `check_task`: what a robot read, perceived, did and was given in some trials."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import InputVariable
from rlrobot_edu.tools.trial import Trial


def shares_of_bins(task: Task, seen: Iterable[Trial], i: int) -> np.ndarray:
    """The share of the steps in which each bin of input `i` was reached."""
    states = np.concatenate([trial.transitions.s_next for trial in seen])
    shape = task.states.shape
    bins = np.unravel_index(states, shape)[i]
    return np.bincount(bins, minlength=shape[i]) / len(states)


def extremes(seen: Sequence[Trial], name: str) -> tuple[float, float]:
    """The smallest and the largest value of a reading."""
    spans = [trial.read[name] for trial in seen]
    return min(low for low, _ in spans), max(high for _, high in spans)


def readings_table(task: Task, seen: Sequence[Trial]) -> Table:
    """The lowest and highest of each reading, beside its limits and cuts."""
    card = ROBOTS[task.robot]
    cuts = {variable.name: _cuts_of(variable) for variable in task.inputs}
    rows = []
    for name, quantity in (card.sensors | card.stops).items():
        lowest, highest = extremes(seen, name)
        rows.append(
            (
                name,
                quantity.unit,
                f"{lowest:.3g}",
                f"{highest:.3g}",
                f"{quantity.low:.3g}",
                f"{quantity.high:.3g}",
                cuts.get(name, ""),
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


def _cuts_of(variable: InputVariable) -> str:
    """How an input is cut into bins."""
    if variable.sectors:
        return f"{variable.sectors} sectors"
    return ", ".join(map(str, variable.cuts or variable.values or ()))


def inputs_table(task: Task, trials: Mapping[str, Trial]) -> Table:
    """How often each bin of an input was reached in each trial; trials: by the words that say what was done."""
    rows = []
    for i, variable in enumerate(task.states.inputs):
        cells = [variable.name]
        for trial in trials.values():
            shares = shares_of_bins(task, [trial], i)
            cells.append(" ".join(f"{share:.0%}" for share in shares))
        rows.append(cells)
    title = "What it perceives: share of the steps in each bin"
    return Table(title, ("input", *trials), rows)


def rewards_table(task: Task, trials: Mapping[str, Trial]) -> Table:
    """In how many steps of each trial a reward was given, and where most of these steps began."""
    rows = []
    for r in sorted(task.rewards):
        for who, trial in trials.items():
            n = times_given(trial, r)
            share = f"{n / len(trial.transitions.r):.1%}"
            rows.append((f"{r:g}", who, n, share, most_often_from(task, trial, r)))
    columns = ("reward", "", "steps", "share", "most often from the state")
    return Table("What it is given", columns, rows)


def times_given(trial: Trial, r: float) -> int:
    """In how many steps the reward was `r`."""
    return int(np.count_nonzero(trial.transitions.r == r))


def most_often_from(task: Task, trial: Trial, r: float) -> str:
    """The state in which most of the steps with the reward `r` began, and how many; empty if there was none."""
    states = trial.transitions.s[trial.transitions.r == r]
    if not len(states):
        return ""
    times = np.bincount(states)
    parts = task.states.decode(int(times.argmax()))
    place = ", ".join(f"{name} {part}" for name, part in parts.items())
    return f"{place} ({times.max()})"


def actions_table(task: Task, trial: Trial) -> Table:
    """How often each action changed a reading, and what it earned."""
    rows = []
    for a in range(task.actions.n):
        mine = trial.transitions.a == a
        moved = ""
        mean = None
        if mine.any():
            moved = f"{trial.moved[mine].mean():.0%}"
            mean = float(trial.transitions.r[mine].mean())
        rows.append((a, task.actions.label(a), moved, mean))
    columns = ("action", "", "changes a reading", "average reward")
    return Table("What it does, at random", columns, rows)
