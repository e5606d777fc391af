"""What is worth a look in a task file: the robot is let loose, and agents try to learn."""

import html
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats

from rlrobot_edu.experiments.repeat import repeat
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.statistics import without_rounding
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.blind import BLIND
from rlrobot_edu.tools.trial import Trial, acting, at_random, learning

LEARNERS = 8  # of each kind, to tell learning from luck
METHOD, CHANCE, SEES_NOTHING = "TOSL+QBIASSR", "Q+RANDOM", "TOSL+SR that sees nothing"
SIGNIFICANT = 0.05


@dataclass(frozen=True, repr=False)
class TaskCheck:
    """What was seen of a task, and what is worth a look; `print` and notebooks show it all.

    task: its name and size; findings: sentences, none for a task in which nothing is odd
    readings, inputs, rewards, actions, learner: tables
    """

    task: str
    findings: tuple[str, ...]
    readings: Table
    inputs: Table
    rewards: Table
    actions: Table
    learner: Table

    def __repr__(self) -> str:
        findings = "\n".join(["Worth a look:", *map("- {}".format, self._told)])
        return "\n\n".join([self.task, *map(str, self._tables), findings])

    def _repr_html_(self) -> str:
        tables = "".join(table._repr_html_() for table in self._tables)
        items = "".join(f"<li>{html.escape(finding)}</li>" for finding in self._told)
        return f"<p>{html.escape(self.task)}</p>{tables}<p>Worth a look:</p><ul>{items}</ul>"

    @property
    def _tables(self) -> tuple[Table, ...]:
        return self.readings, self.inputs, self.rewards, self.actions, self.learner

    @property
    def _told(self) -> tuple[str, ...]:
        return self.findings or ("nothing: every bin was reached, every reward given, and the agent learns.",)


def check_task(task: Task | str | Path, steps: int = 2000, seed: int = 0) -> TaskCheck:
    """Let a task's robot act at random and agents learn on it, and tell what is odd.

    Parameters
    ----------
    task : Task, str or Path
        A task, its name, or the path of your own task file.
    steps : int
        Length of each trial, at least 100: one at random, one with an agent that learns, eight each with the kinds of
        agents of the last table, and eight with the best single action, which is found in trials of a quarter of it.
    seed : int
        The same seed gives the same report.

    Returns
    -------
    TaskCheck
        How far the readings go, bins never reached, rewards never given, actions without effect, and whether the
        default method beats chance, itself without each of its inputs, agents that see nothing, and the best single
        action.

    Raises
    ------
    ValueError
        If there is something wrong in the task's file: it says which file, line and what.
    ImportError
        If the robot's simulator is missing; it says what to install.

    Notes
    -----
    It pays not to look if who does not look earns significantly more after so many `steps` (Mann–Whitney): agents that
    see nothing, or one action repeated. An input is asked about if agents without it earn significantly more, and if
    those with it learn at all. It may pay later, for it makes the table larger. All are measured alike: over the whole
    run, or in an episodic task over its last episode.
    Longer trials may meet what these did not. So all this is worth a look, and no error.
    """
    task = load_task(task)
    check_count("steps", steps, least=100)
    check_count("seed", seed, least=0)
    few, (drawn, learned, repeated) = steps // 4, np.random.SeedSequence(seed).spawn(3)
    trials = [at_random(task, steps, drawn), learning(task, steps, learned)]
    alone = [acting(task, [a] * few, seed) for a in range(task.actions.n)]
    seen = [*trials, *alone]
    # which one to repeat for as long as agents learn: not by what it earns on its way from the start
    _, best = max((float(trial.transitions.r[few // 2 :].mean()), a) for a, trial in enumerate(alone))
    moving = [i for i in range(len(task.inputs)) if np.count_nonzero(_times(task, seen, i)) > 1]
    earned = _earned(task, moving if len(task.inputs) > 1 else [], steps, seed)
    same = [acting(task, [best] * steps, each).transitions for each in repeated.spawn(LEARNERS)]
    like = earned[METHOD][0]  # measured as an agent is
    earned[f"action {best} ({task.actions.label(best)}) for ever"] = Runs(replace(like, transitions=x) for x in same)
    final = dict(zip(earned, without_rounding([runs.final for runs in earned.values()]), strict=True))
    learner = [(who, float(x.mean()), float(x.std(ddof=1))) for who, x in final.items()]
    return TaskCheck(
        f"{task.name}: {task.states.n} states × {task.actions.n} actions, {task.robot} in {task.scene}",
        (*_odd_inputs(task, seen), *_odd_rewards(task, seen), *_odd_actions(task, trials[0]),
         *_odd_learning(final, steps)),
        _readings_table(task, seen),
        _inputs_table(task, trials),
        _rewards_table(task, trials),
        _actions_table(task, trials[0]),
        Table(f"Does it learn? {LEARNERS} agents each, {steps} steps",
              ("method", "average reward at the end", "standard deviation"), learner),
    )  # fmt: skip


def _earned(task: Task, inputs: Sequence[int], steps: int, seed: int) -> dict[str, Runs]:
    """What agents of each kind earn, LEARNERS of each; some do without one of the inputs."""
    blind = {"method": BLIND, "loop_evasion": False}
    kinds: dict[str, dict[str, Any]] = {METHOD: {}, CHANCE: {"method": CHANCE}, SEES_NOTHING: blind}
    for i in inputs:
        without = replace(task, inputs=[*task.inputs[:i], *task.inputs[i + 1 :]])
        kinds[f"{METHOD} without {task.inputs[i].name}"] = {"world": without}
    usual: dict[str, Any] = {"world": task, "repetitions": LEARNERS, "steps": steps}
    return {who: repeat(**{**usual, **how}, seed=seed + i) for i, (who, how) in enumerate(kinds.items())}


def _times(task: Task, seen: Sequence[Trial], i: int) -> np.ndarray:
    """How often each bin of input `i` was met."""
    states = np.concatenate([trial.transitions.s_next for trial in seen])
    return np.bincount(np.unravel_index(states, task.states.shape)[i], minlength=task.states.shape[i])


def _read(seen: Sequence[Trial], name: str) -> tuple[float, float]:
    """The smallest and the largest that a reading was."""
    low, high = zip(*(trial.read[name] for trial in seen), strict=True)
    return min(low), max(high)


def _odd_inputs(task: Task, seen: Sequence[Trial]) -> Iterator[str]:
    for i, variable in enumerate(task.states.inputs):
        times = _times(task, seen, i)
        if never := [f"bin {k} ({variable.decode(k)})" for k in np.flatnonzero(times == 0).tolist()]:
            low, high = _read(seen, variable.name)
            span = f"{low:.3g} to {high:.3g} {variable.unit}".strip()
            yield f"{variable.name}: {', '.join(never)} was never reached; it read {span}."
        if np.count_nonzero(times) == 1:
            yield f"{variable.name} is always in the same bin, so it tells nothing; it makes the table longer."


def _odd_rewards(task: Task, seen: Sequence[Trial]) -> Iterator[str]:
    given = {float(r) for trial in seen for r in np.unique(trial.transitions.r)}
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


def _odd_learning(final: dict[str, np.ndarray], steps: int) -> Iterator[str]:
    p_learned = _p_more(final[METHOD], final[CHANCE])
    if p_learned >= SIGNIFICANT:
        so_far = f"not significantly better than chance after {steps} steps (p = {p_learned:.2f})"
        yield f"{METHOD} with its defaults is {so_far}. More steps, or is there something it does not perceive?"
    for who, x in final.items():
        if (p := _p_more(x, final[METHOD])) < SIGNIFICANT:
            means = f"{who} earns {x.mean():.2f}, {METHOD} {final[METHOD].mean():.2f}"
            compared = f"{means} after {steps} steps (p = {p:.2g})"
            if not who.startswith(f"{METHOD} without"):
                yield f"{compared}: it pays not to look."
            elif p_learned < SIGNIFICANT:
                yield f"{compared}. Is it needed?"


def _p_more(these: np.ndarray, those: np.ndarray) -> float:
    """How often chance alone would make such a difference."""
    return float(stats.mannwhitneyu(these, those, alternative="greater").pvalue)


def _readings_table(task: Task, seen: Sequence[Trial]) -> Table:
    card, rows = ROBOTS[task.robot], []
    cut = {one.name: f"{one.sectors} sectors" if one.sectors else one.cuts or one.values for one in task.inputs}
    for name, (unit, low, high) in (card.sensors | card.stops).items():
        cuts = str(cut.get(name, "")).strip("(,)")
        rows.append((name, unit, *map("{:.3g}".format, (*_read(seen, name), low, high)), cuts))
    head = ("reading", "unit", "lowest seen", "highest seen", "at least", "at most", "cuts")
    return Table("What it reads, in all trials", head, rows)


def _inputs_table(task: Task, trials: Sequence[Trial]) -> Table:
    rows = []
    for i, variable in enumerate(task.states.inputs):
        times = (_times(task, [trial], i) for trial in trials)
        rows.append((variable.name, *(" ".join(f"{n:.0%}" for n in each / each.sum()) for each in times)))
    head = ("input", "bins at random", "bins while learning")
    return Table("What it perceives: share of the steps in each bin", head, rows)


def _rewards_table(task: Task, trials: Sequence[Trial]) -> Table:
    rows = [(f"{r:g}", *(f"{np.mean(trial.transitions.r == r):.1%}" for trial in trials)) for r in sorted(task.rewards)]
    return Table("What it is given: share of the steps", ("reward", "at random", "while learning"), rows)


def _actions_table(task: Task, trial: Trial) -> Table:
    rows = []
    for a in range(task.actions.n):
        mine = trial.transitions.a == a
        mean = float(trial.transitions.r[mine].mean()) if mine.any() else None
        rows.append((a, task.actions.label(a), f"{trial.moved[mine].mean():.0%}" if mine.any() else "", mean))
    return Table("What it does, at random", ("action", "", "changes a reading", "average reward"), rows)
