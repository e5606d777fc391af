"""What is worth a look in a task file: the robot is let loose, and an agent tries to learn."""

import html
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats

from rlrobot_edu.experiments.repeat import repeat
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.workshop.blind import BLIND
from rlrobot_edu.workshop.information import Information, information
from rlrobot_edu.workshop.trial import Trial, acting, at_random, learning

LEARNERS = 8  # and as many agents at random, to tell learning from luck, and as many that see nothing
METHOD, CHANCE, SEES_NOTHING = "TOSL+QBIASSR", "Q+RANDOM", "TOSL+SR that sees nothing"
SIGNIFICANT = 0.05
SELDOM = 100  # times that a reward is reached at random; below that, too little is seen to say what tells of it


@dataclass(frozen=True, repr=False)
class TaskCheck:
    """What was seen of a task, and what is worth a look; `print` and notebooks show it all.

    task: its name and size; findings: sentences, none for a task in which nothing is odd
    inputs, rewards, actions, learner: tables
    """

    task: str
    findings: tuple[str, ...]
    inputs: Table
    rewards: Table
    actions: Table
    learner: Table

    def __repr__(self) -> str:
        tables = (str(table) for table in (self.inputs, self.rewards, self.actions, self.learner))
        return "\n\n".join([self.task, *tables, "\n".join(["Worth a look:", *map("- {}".format, self._told)])])

    def _repr_html_(self) -> str:
        tables = (table._repr_html_() for table in (self.inputs, self.rewards, self.actions, self.learner))
        items = "".join(f"<li>{html.escape(finding)}</li>" for finding in self._told)
        return f"<p>{html.escape(self.task)}</p>{''.join(tables)}<p>Worth a look:</p><ul>{items}</ul>"

    @property
    def _told(self) -> tuple[str, ...]:
        return self.findings or ("nothing: every bin was reached, every reward given, and the agent learns.",)


def check_task(task: Task | str | Path, steps: int = 2000, seed: int = 0) -> TaskCheck:
    """Let a task's robot act at random and an agent learn on it, and tell what is odd.

    Parameters
    ----------
    task : Task, str or Path
        A task, its name, or the path of your own task file.
    steps : int
        Length of each trial, at least 100; there are 26, 17 of them with agents that learn, and those of a quarter
        of it with each action repeated for ever.
    seed : int
        The same seed gives the same report.

    Returns
    -------
    TaskCheck
        Bins never reached, rewards never given, actions without effect, inputs that tell nothing, and whether the
        default method beats chance, agents that see nothing, and the best single action.

    Raises
    ------
    ValueError
        If there is something wrong in the task's file: it says which file, line and what.
    ImportError
        If the robot's simulator is missing; it says what to install.

    Notes
    -----
    An input tells something if, for a given action, it has to do with the reward, or with another input after the step.
    Each is looked at alone and beside one other, while the robot acts at random: what three say only together, or of a
    reward that comes seldom, is not seen. It says nothing about such inputs if the largest reward is rare.
    Longer trials may meet what these did not. So all this is worth a look, and no error.
    In a short trial a robot does not get around, and an input may seem to tell what only holds where it was: heading of
    distance, say, along one wall. With more `steps` that goes away.
    """
    task = load_task(task)
    check_count("steps", steps, least=100)
    check_count("seed", seed, least=0)
    few, (drawn, learned, shifts) = steps // 4, np.random.SeedSequence(seed).spawn(3)
    trial = at_random(task, steps, drawn)
    both = [trial.transitions, learning(task, steps, learned)]
    told = told_by_inputs(task, trial.transitions, np.random.default_rng(shifts))
    blind = {"method": BLIND, "loop_evasion": False}
    trials: dict[str, Any] = {METHOD: {}, CHANCE: {"method": CHANCE}, SEES_NOTHING: blind}
    final = {who: repeat(task, **how, repetitions=LEARNERS, steps=steps, seed=seed + i, progress=False).final
             for i, (who, how) in enumerate(trials.items())}  # fmt: skip
    alone = ((acting(task, [a] * few, seed).transitions.r[few // 2 :].mean(), a) for a in range(task.actions.n))
    paid, best = max(alone)  # what it earned on its way from the start does not count
    rows = [(who, float(runs.mean()), float(runs.std(ddof=1))) for who, runs in final.items()]
    rows.append((f"action {best} ({task.actions.label(best)}) for ever", float(paid), 0.0))
    p = float(stats.mannwhitneyu(final[METHOD], final[CHANCE], alternative="greater").pvalue)
    mute = [i for i, known in enumerate(told) if not any(one.is_real for one in known.values())]
    useless = [i for i in mute if not _tells_beside_another(task, trial.transitions, i, np.random.default_rng(shifts))]
    findings = [*_odd_inputs(task, both, useless), *_odd_rewards(task, both), *_odd_actions(task, trial)]
    if p >= SIGNIFICANT:
        findings.append(
            f"{METHOD} with its defaults is not significantly better than chance after {steps} steps (p = {p:.2f}). "
            "More steps, or is there something it does not perceive?"
        )
    findings += [f"{who} earns {mean:.2f}, {METHOD} {rows[0][1]:.2f} after {steps} steps: it pays not to look."
                 for who, mean, _ in rows[2:] if mean >= rows[0][1]]  # fmt: skip
    return TaskCheck(
        f"{task.name}: {task.states.n} states × {task.actions.n} actions, {task.robot} in {task.scene}",
        tuple(findings),
        _inputs_table(task, both, told),
        _rewards_table(task, both),
        _actions_table(task, trial),
        Table(f"Does it learn? {LEARNERS} agents each, {steps} steps (p = {p:.2g})",
              ("method", "average reward at the end", "standard deviation"), rows),
    )  # fmt: skip


def _bins(task: Task, states: np.ndarray) -> tuple[np.ndarray, ...]:
    """The bin of each input in each state, arrays (n,)."""
    return np.unravel_index(states, task.states.shape)


def told_by_inputs(task: Task, seen: Transitions, rng: np.random.Generator) -> list[dict[str, Information]]:
    """What each input tells, given the action: about "the reward", and about each other input after the step.

    seen: steps at random; rng: of the shifts in time. Returns for each input of the task what it tells, by name.
    """
    rewards = np.unique(seen.r, return_inverse=True)[1]
    names = [variable.name for variable in task.states.inputs]
    now, then = _bins(task, seen.s), _bins(task, seen.s_next)
    told = []
    for i, x in enumerate(now):
        others = {name: y for j, (name, y) in enumerate(zip(names, then, strict=True)) if j != i}
        told.append({name: information(x, y, seen.a, rng) for name, y in {"the reward": rewards, **others}.items()})
    return told


def _times(seen: Transitions, task: Task, i: int) -> np.ndarray:
    """How often each bin of input `i` was met."""
    return np.bincount(_bins(task, seen.s_next)[i], minlength=task.states.shape[i])


def _tells_beside_another(task: Task, seen: Transitions, i: int, rng: np.random.Generator) -> bool:
    """Whether input `i` tells of the reward to who knows the action and one other input, too: a place is x and y."""
    rewards, now = np.unique(seen.r, return_inverse=True)[1], _bins(task, seen.s)
    others = (seen.a * task.states.shape[j] + y for j, y in enumerate(now) if j != i)
    return any(information(now[i], rewards, known, rng).is_real for known in others)


def _odd_inputs(task: Task, seen: list[Transitions], useless: list[int]) -> Iterator[str]:
    paid = seen[0].r == max(task.rewards)  # a long stay on one spot is one arrival
    is_rare = np.count_nonzero(paid & ~np.append(False, paid[:-1])) < SELDOM
    for i, variable in enumerate(task.states.inputs):
        times = sum(_times(part, task, i) for part in seen)
        for k in np.flatnonzero(times == 0).tolist():
            yield f"{variable.name}: bin {k} ({variable.decode(k)}) was never reached."
        if np.count_nonzero(times) == 1:
            yield f"{variable.name} is always in the same bin, so it tells nothing; it makes the table longer."
        elif i in useless and not is_rare:
            yield (
                f"{variable.name} tells nothing about the reward, alone or beside another input, nor about the others. "
                "Is it needed? Compare agents with and without it."
            )


def _odd_rewards(task: Task, seen: list[Transitions]) -> Iterator[str]:
    given = {float(r) for part in seen for r in np.unique(part.r)}
    for r in sorted(set(task.rewards) - given):
        yield f"the reward {r:g} was never given."
    if len(given) == 1:
        yield f"the reward was always {given.pop():g}, so there is nothing to learn from."


def _odd_actions(task: Task, trial: Trial) -> Iterator[str]:
    commands = [task.command_for(a) for a in range(task.actions.n)]
    for a, command in enumerate(commands):
        label = f"action {a} ({task.actions.label(a)})"
        if command in commands[:a]:
            yield f"{label} does the same as action {commands.index(command)}."
        elif not trial.moved[trial.transitions.a == a].any():
            yield f"{label} changes nothing that the robot senses. Is it there to stand still?"


def _inputs_table(task: Task, seen: list[Transitions], told: list[dict[str, Information]]) -> Table:
    rows = []
    for i, variable in enumerate(task.states.inputs):
        shares = [" ".join(f"{n:.0%}" for n in _times(part, task, i) / len(part.s)) for part in seen]
        best = max((name for name in told[i] if name != "the reward"), key=lambda name: told[i][name].bits, default="")
        about = f"{told[i][best].bits:.3f} ({best})" if best else ""
        rows.append((variable.name, *shares, f"{told[i]['the reward'].bits:.3f}", about))
    head = ("input", "bins at random", "bins while learning", "tells of the reward [bit]", "of another input [bit]")
    return Table("What it perceives: share of the steps in each bin", head, rows)


def _rewards_table(task: Task, seen: list[Transitions]) -> Table:
    rows = [(f"{r:g}", *(f"{np.mean(part.r == r):.1%}" for part in seen)) for r in sorted(task.rewards)]
    return Table("What it is given: share of the steps", ("reward", "at random", "while learning"), rows)


def _actions_table(task: Task, trial: Trial) -> Table:
    rows = []
    for a in range(task.actions.n):
        mine = trial.transitions.a == a
        mean = float(trial.transitions.r[mine].mean()) if mine.any() else None
        rows.append((a, task.actions.label(a), f"{trial.moved[mine].mean():.0%}" if mine.any() else "", mean))
    return Table("What it does, at random", ("action", "", "changes a reading", "average reward"), rows)
