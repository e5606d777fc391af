"""What is worth a look in a task file: its robot acts at random, and agents try to learn."""

import html
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats

from rlrobot_edu.checks import check_count
from rlrobot_edu.experiments.repetitions import repetition, run
from rlrobot_edu.experiments.rounding import without_rounding
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.tables import Table
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.task.plain import NotPlainError, task_text
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.blind import BLIND
from rlrobot_edu.tools.task_tables import (
    actions_table,
    extremes,
    inputs_table,
    most_often_from,
    readings_table,
    rewards_table,
    shares_of_bins,
    times_given,
)
from rlrobot_edu.tools.trial import Trial, acting, learning

LEARNERS = 8  # of each kind, to tell learning from luck
METHOD = "TOSL+QBIASSR"
CHANCE = "Q+RANDOM"
SEES_NOTHING = "TOSL+SR that sees nothing"
WITHOUT = f"{METHOD} without "
SIGNIFICANT = 0.05
LEARNER_COLUMNS = (
    "method",
    "average reward at the end",
    "standard deviation",
    f"than {METHOD}",
    "p",
)
KEEP_IT = (
    "Give more steps first; leave it out only if that changes nothing, and if it guards against nothing "
    "that the reward leaves out."
)
# Steps for each pair of state and action; after fewer nobody can tell whether an input is needed.
ENOUGH = 10
RARE = 0.05  # share of the steps; a reward that is given less often may be too rare to be learned from


@dataclass(frozen=True, repr=False)
class TaskCheck:
    """The report on a task, with what is worth a look; `print` and notebooks show it all.

    task: its name and size; findings: sentences, none for a task in which nothing is odd
    speed: whether reward and goal are plain functions, see `rlrobot_edu.task.plain`; an empty text for a robot without
        ``engine="kinematic"``
    readings, inputs, rewards, actions, learner: tables
    """

    task: str
    speed: str
    findings: tuple[str, ...]
    readings: Table
    inputs: Table
    rewards: Table
    actions: Table
    learner: Table

    def __repr__(self) -> str:
        parts = [self._head]
        parts += [str(table) for table in self._tables]
        parts.append("\n- ".join(["Worth a look:", *self._sentences]))
        return "\n\n".join(parts)

    def _repr_html_(self) -> str:
        tables = "".join(table._repr_html_() for table in self._tables)
        items = "".join(f"<li>{html.escape(text)}</li>" for text in self._sentences)
        return f"<p>{html.escape(self._head)}</p>{tables}<p>Worth a look:</p><ul>{items}</ul>"

    @property
    def _head(self) -> str:
        return f"{self.task}. {self.speed}" if self.speed else self.task

    @property
    def _tables(self) -> tuple[Table, ...]:
        return self.readings, self.inputs, self.rewards, self.actions, self.learner

    @property
    def _sentences(self) -> tuple[str, ...]:
        if self.findings:
            return self.findings
        return (
            "nothing: each bin and reward was met, each input is needed, and looking pays.",
        )


@suggests_keywords
def check_task(task: Task | str | Path, steps: int = 2000, seed: int = 0) -> TaskCheck:
    """Let a task's robot act at random and agents learn on it, and report what is odd.

    Parameters
    ----------
    task : Task, str or Path
        A task, its name, or the path of your own task file.
    steps : int
        Length of each trial, at least 100. There is one trial at random, one with an agent that learns, eight for
        each kind of agent in the last table, and eight with the best single action. That action is found in trials of
        a quarter of this length.
    seed : int
        The same seed gives the same report.

    Returns
    -------
    TaskCheck
        The range of the readings, bins never reached, how often and where each reward was given, and actions without
        effect. Also whether the default method is shown to beat chance, agents that see nothing, the best single
        action, and itself without each of its inputs.

    Raises
    ------
    ValueError
        If something is wrong in the task's file; the message names the file, the line and the mistake.
    FileNotFoundError
        If there is no such task file.
    ImportError
        If the robot's simulator is missing; it says what to install.

    Notes
    -----
    Comparisons are one-sided Mann–Whitney tests at the 5 % level, of the average reward over the whole run or, in an
    episodic task, over its last episode. A task passes only if the default method earns significantly more than chance
    and than each robot that does not look: agents that see nothing, and one action repeated. If one of these earns
    significantly more, it pays not to look. An input is shown to be needed if agents without it earn significantly
    less. Of other inputs the report says only that the steps are too few to tell, unless there are ten for each pair of
    state and action. It says nothing about inputs while agents do not beat chance. With eight agents each, about every
    other true difference of one standard deviation is missed. An input may also pay only later, because it makes the
    table larger. Longer trials may find more. These are hints, not errors.
    """
    task = load_task(task)
    check_count("steps", steps, least=100)
    check_count("seed", seed, least=0)
    few = steps // 4
    drawn, learned, repeated = np.random.SeedSequence(seed).spawn(3)
    trials = {
        "at random": learning(task, steps, drawn, CHANCE),
        "while learning": learning(task, steps, learned),
    }
    alone = [acting(task, [a] * few, seed) for a in range(task.actions.n)]
    seen = [*trials.values(), *alone]
    earned = _earned(task, _inputs_to_leave_out(task, seen), steps, seed)
    best = _best_alone(alone)
    repeating = f"action {best} ({task.actions.label(best)}) for ever"
    like = earned[METHOD][0]  # measured as an agent is
    runs = Runs()
    for its_seed in repeated.spawn(LEARNERS):
        trial = acting(task, [best] * steps, its_seed)
        runs.append(replace(like, transitions=trial.transitions))
    earned[repeating] = runs
    compared = _compared(earned)
    return TaskCheck(
        task=f"{task.name}: {task.states.n} states × {task.actions.n} actions, {task.robot} in {task.scene}",
        speed=_speed(task),
        findings=(
            *_odd_inputs(task, seen),
            *_odd_rewards(task, seen),
            *_odd_actions(task, trials["at random"]),
            *_odd_learning(
                compared,
                steps,
                pairs=task.states.n * task.actions.n,
                advice=_advice(task, trials, steps),
            ),
        ),
        readings=readings_table(task, seen),
        inputs=inputs_table(task, trials),
        rewards=rewards_table(task, trials),
        actions=actions_table(task, trials["at random"]),
        learner=Table(
            f"Does it learn? {LEARNERS} agents each, {steps} steps; p: one-sided Mann–Whitney test",
            LEARNER_COLUMNS,
            compared,
        ),
    )


def _best_alone(alone: Sequence[Trial]) -> int:
    """The action that earns most if it is repeated, the last of several alike.

    What it earns on the way from the start does not count, because it will be repeated for longer.
    """
    means = []
    for trial in alone:
        rewards = trial.transitions.r
        means.append(float(rewards[len(rewards) // 2 :].mean()))
    _, best = max((mean, a) for a, mean in enumerate(means))
    return best


def _inputs_to_leave_out(task: Task, seen: Sequence[Trial]) -> list[str]:
    """The inputs without which agents try to learn, one by one: those that were in more than one bin."""
    if len(task.inputs) == 1:
        return []
    moving = []
    for i, variable in enumerate(task.inputs):
        if np.count_nonzero(shares_of_bins(task, seen, i)) > 1:
            moving.append(variable.name)
    return moving


def _compared(earned: Mapping[str, Runs]) -> list[tuple[Any, ...]]:
    """Mean and standard deviation of the final rewards of each kind, and whether they differ from those of METHOD."""
    final = without_rounding([runs.final for runs in earned.values()])
    its_final = dict(zip(earned, final, strict=True))
    rows: list[tuple[Any, ...]] = []
    for who, x in its_final.items():
        mean = float(x.mean())
        deviation = float(x.std(ddof=1))
        rows.append((who, mean, deviation, *_against(x, its_final[METHOD])))
    return rows


def _earned(
    task: Task, inputs: Sequence[str], steps: int, seed: int
) -> dict[str, Runs]:
    """What agents of each kind earn, LEARNERS of each; some do without one of the inputs."""
    kinds: dict[str, tuple[Task, dict[str, Any]]] = {
        METHOD: (task, {"method": METHOD}),
        CHANCE: (task, {"method": CHANCE}),
        SEES_NOTHING: (task, {"method": BLIND, "loop_evasion": False}),
    }
    for name in inputs:
        others = [variable for variable in task.inputs if variable.name != name]
        kinds[WITHOUT + name] = (replace(task, inputs=others), {"method": METHOD})
    jobs = {}
    for i, (who, (world, settings)) in enumerate(kinds.items()):
        for j, each in enumerate(np.random.SeedSequence(seed + i).spawn(LEARNERS)):
            jobs[who, j] = partial(repetition, world, settings, {"steps": steps}, each)
    return run(jobs, threads=False, bar=task.name)


def _speed(task: Task) -> str:
    """Whether learning is compiled where the robot is geometry alone."""
    if "kinematic" not in ROBOTS[task.robot].engines:
        return ""
    try:
        task_text(task)
    except NotPlainError as error:
        return f"With engine='kinematic' learning takes the plain loop: {error}."
    return "Reward and goal are plain functions: with engine='kinematic' learning is compiled."


def _odd_inputs(task: Task, seen: Sequence[Trial]) -> Iterator[str]:
    for i, variable in enumerate(task.states.inputs):
        met = shares_of_bins(task, seen, i)
        missed = np.flatnonzero(met == 0).tolist()
        if missed:
            never = [f"bin {k} ({variable.decode(k)})" for k in missed]
            low, high = extremes(seen, variable.name)
            span = f"{low:.3g} to {high:.3g} {variable.unit}".strip()
            yield f"{variable.name}: {', '.join(never)} was never reached; it read {span}."
        if np.count_nonzero(met) == 1:
            yield f"{variable.name} is always in the same bin, so it tells nothing; it makes the table longer."


def _odd_rewards(task: Task, seen: Sequence[Trial]) -> Iterator[str]:
    given: set[float] = set()
    for trial in seen:
        given.update(trial.transitions.r.tolist())
    for r in sorted(set(task.rewards) - given):
        yield f"the reward {r:g} was never given."
    if len(given) == 1:
        yield f"the reward was always {given.pop():g}, so there is nothing to learn from."


def _odd_actions(task: Task, trial: Trial) -> Iterator[str]:
    commands = task.commands
    for a, command in enumerate(commands):
        label = f"action {a} ({task.actions.label(a)})"
        if command in commands[:a]:
            yield f"{label} does the same as action {commands.index(command)}."
        elif not trial.moved[trial.transitions.a == a].any():
            yield f"{label} changes nothing that the robot senses. Is it there to stand still?"


def _against(these: np.ndarray, those: np.ndarray) -> tuple[str, float | None]:
    """Whether these are significantly less or more than those, and the one-sided p of that side.

    Nothing if both are the same.
    """
    if these is those:
        return "", None
    less = stats.mannwhitneyu(these, those, alternative="less").pvalue
    greater = stats.mannwhitneyu(these, those, alternative="greater").pvalue
    p, side = min((less, "less"), (greater, "greater"))
    return side if p < SIGNIFICANT else "not shown", float(p)


def _odd_learning(
    compared: Sequence[Sequence[Any]], steps: int, pairs: int, advice: str
) -> Iterator[str]:
    """What agents are not shown to beat, with advice; inputs that they are not shown to need.

    pairs: how many pairs of state and action the task has
    """
    method, *others = compared
    mine = method[1]
    unbeaten = []
    for who, _, _, side, _ in others:
        if side != "less" and not who.startswith(WITHOUT):
            unbeaten.append(who)
    doubtful = []
    for who, mean, _, side, p in others:
        is_better = side == "greater"
        after = f"after {steps} steps (p = {p:.2g})"
        if who in unbeaten:
            verdict = "looking is not shown to pay"
            if is_better:
                verdict = "it pays not to look"
            yield f"{who} earns {mean:.2f}, {METHOD} {mine:.2f} {after}: {verdict}."
        elif side != "less" and CHANCE not in unbeaten:
            name = who.removeprefix(WITHOUT)
            verdict = "hinders so far" if is_better else "is not shown to be needed"
            means = f"without it agents earn {mean:.2f}, with it {mine:.2f} {after}"
            doubtful.append((name, f"{name} {verdict}: {means}. {KEEP_IT}"))
    if doubtful and steps < ENOUGH * pairs:
        names = ", ".join(name for name, _ in doubtful)
        yield f"too few steps to tell whether {names} can be spared: {steps} for {pairs} pairs of state and action."
    else:
        yield from (sentence for _, sentence in doubtful)
    if unbeaten:
        yield advice


def _advice(task: Task, trials: Mapping[str, Trial], steps: int) -> str:
    """What to do if agents are no better than robots that do not look; it depends on how rare the best reward is."""
    best = max(task.rewards)
    drawn = times_given(trials["at random"], best)
    learned = times_given(trials["while learning"], best)
    if max(drawn, learned) >= RARE * steps:
        return (
            "give more steps, pay for what only a robot that looks can do, "
            "or let it perceive what decides the reward."
        )
    times = f"{drawn} of {steps} steps at random, {learned} while learning"
    where = most_often_from(task, trials["while learning"], best)
    if where:
        times += f", most often from: {where}"
    return f"the reward {best:g} is rare, a likely reason: {times}. Pay for what leads there, or begin nearer to it."
