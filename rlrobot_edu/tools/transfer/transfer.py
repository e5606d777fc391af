"""Carry over what an agent has learned to a new agent of another task."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy import sparse

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.size import Env, task_of
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.transfer.bins import overlap
from rlrobot_edu.tools.transfer.commands import ActionMatch, label, match_actions
from rlrobot_edu.tools.transfer.report import InputMatch, Report


class TransferredAgent(Agent):
    """An agent that begins with what another one has learned. It is an `Agent` like any other.

    report: what was carried over; None in one that was loaded from a file
    """

    report: Report | None = None


def transfer(
    source_agent: Agent,
    target: Task | str | Path | Env,
    *,
    source_task: Task | str | Path | None = None,
    method: str | Method | None = None,
    seed: int | np.random.SeedSequence | None = None,
    **settings: Any,
) -> TransferredAgent:
    """A new agent for `target` that begins with what `source_agent` has learned.

    Parameters
    ----------
    source_agent : Agent
        The one that has learned; it stays as it is.
    target : Task, str, Path or gymnasium.Env
        The task of the new agent, its name or path, or an environment that runs it.
    source_task : Task, str or Path, optional
        What the source learned; by default the task that it was made from. Needed if it was made from a foreign
        environment or a model that does not know its task, or loaded from a file.
    method : str or Method, optional
        The new agent's, see `Agent`; by default the source's.
    seed : int or numpy.random.SeedSequence, optional
        Of the new agent's own random numbers.
    **settings
        Parameters of the new agent, such as ``temperature=2``; by default the source's, but for `r_max`.

    Returns
    -------
    TransferredAgent
        An `Agent` with a `report` of what was carried over. Its visits are 0 and its traces empty: they are to count
        its own experience.

    Raises
    ------
    ValueError
        If the source's task is not known or not the one that it learned, if the tasks have no input or no action in
        common, or an input has another unit.
    FileNotFoundError
        If there is no such task file.

    Notes
    -----
    Each Q(s, a) of the target is a weighted mean of the source's. The weight of a source's pair is the product of

    - for each input that both have, by name: the part of the target's bin that lies in the source's;
    - for each input that the target lacks: the same for all bins; one that the source lacks makes no difference;
    - the part that its action has in the target's action, by their physical commands;
    - 1 if the source has visited the pair, else 0. A pair never tried has Q = 0, which is no knowledge; as one number
      among others it would make the mean wrong. How often it was tried does not count: that says which way the source
      went, not how much of a bin it covers.

    Where all weights are 0 the target's pair is unknown and begins with 0, like those of any new agent.

    Then Q is multiplied by the ratio of the tasks' Qmax = Rmax / (1 − γ), the largest value it can take. Softmax
    divides Q by Qmax, so the same preferences lead to the same probabilities, whatever the rewards' size.
    """
    source, goal = _source_task(source_agent, source_task), _target_task(target)
    inputs, matrices = _match_inputs(goal, source)
    actions = match_actions(goal, source)
    if not any(match.sources for match in actions):
        raise ValueError(
            f"no action of {source.name} is like any of {goal.name}, so there is nothing to carry over"
        )
    kept = dataclasses.asdict(source_agent.parameters) | {
        "r_max": None,
        "planner": source_agent.method.planner,
    }
    if method is not None:
        del kept["accumulating"]  # a variant of one algorithm
    learner = method or dataclasses.replace(
        source_agent.method, planner=None
    )  # the planner is one of the settings
    agent = TransferredAgent(goal, learner, seed=seed, **{**kept, **settings})
    scale = source_agent.parameters.q_scale / agent.parameters.q_scale
    tried = (source_agent.visits > 0) | (
        source_agent.q != 0
    )  # a transferred agent has values without visits
    matrices.append(_action_weights(actions, source.actions.n))
    names, shape = (
        [v.name for v in source.inputs],
        (*source.states.shape, source.actions.n),
    )
    order = [names.index(match.name) for match in inputs if match.name in names]
    values, weights = (
        _spread(x.reshape(shape).transpose(*order, -1), matrices).reshape(agent.q.shape)
        for x in (np.where(tried, source_agent.q, 0.0), 1.0 * tried)
    )
    known = weights > 0
    with np.errstate(over="ignore", invalid="ignore"):
        q = scale * np.divide(values, weights, out=np.zeros_like(values), where=known)
    if not np.isfinite(q).all():
        raise ValueError(
            f"Q of {source.name} times {scale:g} is more than a number can hold; give smaller rewards"
        )
    agent.q[:] = q
    labels, outputs = (
        tuple(label(source, a) for a in range(source.actions.n)),
        [v.name for v in goal.outputs],
    )
    agent.report = Report(
        source.name,
        goal.name,
        tuple(inputs),
        tuple(actions),
        known,
        scale,
        labels,
        ", ".join(outputs),
    )
    return agent


def _source_task(agent: Agent, given: Task | str | Path | None) -> Task:
    if not isinstance(agent, Agent):
        raise ValueError(
            f"rl.transfer carries over what an rl.Agent has learned, not {agent!r:.200}"
        )
    task = agent.task if given is None else load_task(given)
    if task is None:
        raise ValueError(
            "this agent does not know which task it has learned; say it with source_task="
        )
    if (task.states.shape, task.actions.n) != (agent.shape, agent.q.shape[1]):
        raise ValueError(
            f"the agent has learned in {agent.shape} bins and {agent.q.shape[1]} actions, but {task.name} has "
            f"{task.states.shape} and {task.actions.n}; give the task that it was made for as source_task="
        )
    return task


def _target_task(target: Task | str | Path | Env) -> Task:
    task = load_task(target) if isinstance(target, str | Path) else task_of(target)
    if task is None:
        kind = type(target).__name__
        raise ValueError(
            f"a {kind} does not say what its bins and actions mean; give rl.transfer the task itself"
        )
    return task


def _match_inputs(
    target: Task, source: Task
) -> tuple[list[InputMatch], list[sparse.csr_array]]:
    """What is done about each input: the target's in their order, then those of the source alone."""
    theirs, ours = ({v.name: v for v in task.inputs} for task in (source, target))
    if not theirs.keys() & ours.keys():
        raise ValueError(
            f"no input of {target.name} ({', '.join(ours)}) is one of {source.name} ({', '.join(theirs)}), "
            "so nothing can be carried over"
        )
    ways: list[tuple[str, str, sparse.csr_array]] = []
    for name, variable in ours.items():
        if name in theirs:
            ways.append((name, "matched", overlap(variable, theirs[name])))
        else:
            ways.append(
                (name, "copied", sparse.csr_array(np.ones((variable.n_bins, 1))))
            )
    for name in [name for name in theirs if name not in ours]:
        n = theirs[name].n_bins
        ways.append((name, "averaged", sparse.csr_array(np.full((1, n), 1 / n))))
    return [InputMatch(*way) for way in ways], [matrix for _, _, matrix in ways]


def _action_weights(actions: Sequence[ActionMatch], n_source: int) -> sparse.csr_array:
    """The actions' matches as an array (actions of the target, actions of the source)."""
    entries = [
        (match.action, b, weight) for match in actions for b, weight in match.sources
    ]
    rows, columns, weights = zip(*entries, strict=True)
    return sparse.csr_array((weights, (rows, columns)), shape=(len(actions), n_source))


def _spread(array: np.ndarray, matrices: Sequence[sparse.csr_array]) -> np.ndarray:
    """Sum `array` along each axis with the weights of its matrix (new, old); an axis that it lacks has length 1."""
    array = array.reshape([matrix.shape[1] for matrix in matrices])
    growth = [matrix.shape[0] / matrix.shape[1] for matrix in matrices]
    for axis in (
        np.argsort(growth).tolist()
    ):  # what shrinks first, so that nothing on the way is larger than both ends
        array = np.moveaxis(array, axis, 0)
        rest = array.shape[1:]
        array = np.moveaxis(
            (matrices[axis] @ array.reshape(array.shape[0], -1)).reshape(-1, *rest),
            0,
            axis,
        )
    return array
