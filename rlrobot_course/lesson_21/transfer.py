"""Carry over what an agent has learned to a new agent of another task."""

from collections.abc import Sequence
from dataclasses import asdict

import numpy as np

from rlrobot_course.lesson_21.actions import action_weights
from rlrobot_course.lesson_21.bins import overlap
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


def transfer(
    source_agent: Agent,
    target: Task | str,
    *,
    seed: int | np.random.SeedSequence | None = None,
) -> Agent:
    """A new agent for `target` that begins with what `source_agent` has learned.

    Parameters
    ----------
    source_agent : Agent
        The one that has learned, made from a task; it stays as it is.
    target : Task or str
        The task of the new agent, or its name.
    seed : int or numpy.random.SeedSequence, optional
        Of the new agent's own random numbers.

    Returns
    -------
    Agent
        With the source's method and parameters. Its visits are 0: they count its own experience.

    Raises
    ------
    ValueError
        If one of the robots has no wheels, or the target lacks an input of the source.

    Notes
    -----
    Q is multiplied by the ratio of the tasks' Qmax = Rmax / (1 − γ), the largest value it can take. Softmax divides Q
    by Qmax, so the same preferences lead to the same probabilities, whatever the rewards' size.
    """
    if isinstance(target, str):
        target = load_task(target)
    q, _ = carried_over(source_agent, target)
    parameters = asdict(source_agent.parameters) | {"r_max": None}
    agent = Agent(target, source_agent.method, seed=seed, **parameters)
    agent.q[:] = q * source_agent.parameters.q_scale / agent.parameters.q_scale
    return agent


def carried_over(source_agent: Agent, target: Task) -> tuple[np.ndarray, np.ndarray]:
    """Values of the target's pairs (s, a) as weighted means of the source's, and which of them are known.

    The weight of a source's pair is the product of

    - for each input that both have, by name: the part of the target's bin that lies in the source's bin;
    - for the action: its part in the target's action, by how the robot moves;
    - 1 if the source has tried the pair, else 0. A pair never tried has Q = 0, which is no knowledge; as one number
      among others it would make the mean wrong.

    An input that the source lacks makes no difference.

    Parameters
    ----------
    source_agent : Agent
        The one that has learned.
    target : Task
        The task of the new agent.

    Returns
    -------
    q : array (n_states, n_actions)
        The values, 0 where nothing is known.
    known : bool array (n_states, n_actions)
        Where a pair that was tried has a weight above 0.
    """
    source = source_agent.task
    known_inputs = {variable.name: variable for variable in source.inputs}
    names = [variable.name for variable in target.inputs]
    if not {
        source.robot,
        target.robot,
    } <= CHASSIS.keys() or not known_inputs.keys() <= set(names):
        raise ValueError(
            f"{target.name} cannot take over what was learned in {source.name}: choose two tasks of robots on wheels, "
            "where the second has all inputs of the first"
        )
    matrices = []
    for variable in target.inputs:
        if variable.name in known_inputs:
            matrices.append(overlap(variable, known_inputs[variable.name]))
        else:
            matrices.append(np.ones((variable.n_bins, 1)))
    matrices.append(action_weights(target, source))
    order = [[*known_inputs].index(name) for name in names if name in known_inputs]

    def spread(table: np.ndarray) -> np.ndarray:
        by_input = table.reshape(*source.states.shape, source.actions.n)
        summed = _weighted_sums(by_input.transpose(*order, -1), matrices)
        return summed.reshape(target.states.n, target.actions.n)

    # a transferred agent has values without visits
    tried = (source_agent.visits > 0) | (source_agent.q != 0)
    values = spread(np.where(tried, source_agent.q, 0.0))
    weights = spread(tried.astype(float))
    known = weights > 0
    return np.divide(values, weights, out=np.zeros_like(values), where=known), known


def _weighted_sums(table: np.ndarray, matrices: Sequence[np.ndarray]) -> np.ndarray:
    """Sum `table` along each axis with the weights of its matrix (new, old); an axis that it lacks has length 1."""
    table = table.reshape([matrix.shape[1] for matrix in matrices])
    for axis, matrix in enumerate(matrices):
        table = np.moveaxis(np.tensordot(matrix, table, axes=(1, axis)), 0, axis)
    return table
