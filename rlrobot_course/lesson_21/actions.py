"""Which actions of one robot do what an action of another one does: by how the robot moves."""

from collections.abc import Iterator
from itertools import combinations_with_replacement

import numpy as np

from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.task.task import Task

TOLERANCE = 0.25  # largest difference of two motions, as part of the largest motion
EQUAL = 1e-9
DETOUR = 0.01  # what a unit of the way between two actions costs


def motion(task: Task, a: int) -> tuple[float, float]:
    """How far the robot goes ahead [m] and turns to the left [rad] in one step of action `a`."""
    ahead, turn = CHASSIS[task.robot].twist(task.command_for(a))
    return ahead * task.step_time, turn * task.step_time


def action_weights(target: Task, source: Task) -> np.ndarray:
    """For each action of `target`, the weights of the source's actions that stand for it.

    These are the source's action of the same outputs and the same motion; or all that have its motion, alike; or the
    two between which its motion lies most nearly, each the more the nearer it is. Motions are compared as parts of the
    largest in either task. If the difference is larger than `TOLERANCE`, nothing stands for the action.

    Parameters
    ----------
    target, source : Task
        Tasks of robots on two wheels.

    Returns
    -------
    array (actions of target, actions of source)
        Each row sums to 1, or to 0 where nothing stands for the action.
    """
    ours = np.array([motion(target, a) for a in range(target.actions.n)])
    theirs = np.array([motion(source, a) for a in range(source.actions.n)])
    largest = np.abs(np.vstack([theirs, ours])).max(axis=0)
    points, point_of = np.unique(
        np.round(theirs / largest, 12), axis=0, return_inverse=True
    )
    alike = [np.flatnonzero(point_of.ravel() == i) for i in range(len(points))]
    weights = np.zeros((target.actions.n, source.actions.n))
    for a, point in enumerate(ours / largest):
        _, difference, parts = min(_ways(point, points))
        if difference > TOLERANCE:
            continue
        for i, part in parts:
            weights[a, alike[i]] = part / len(alike[i])
        for b in np.flatnonzero(weights[a]).tolist():
            same = source.actions.decode(b) == target.actions.decode(a)
            if same and difference < EQUAL:
                weights[a] = 0.0
                weights[a, b] = 1.0
                break
    return weights


def _ways(
    point: np.ndarray, points: np.ndarray
) -> Iterator[tuple[float, float, list[tuple[int, float]]]]:
    """Each way to come near `point` between two of `points`: its cost, the difference that remains, and the parts.

    A long way costs a little more than a short one.
    """
    for i, j in combinations_with_replacement(range(len(points)), 2):
        way = points[j] - points[i]
        length = float(np.linalg.norm(way))
        part = 0.0
        if length:
            part = float(np.clip((point - points[i]) @ way / length**2, 0, 1))
        if abs(part - round(part)) < EQUAL:
            part = float(round(part))
        difference = float(np.linalg.norm(points[i] + part * way - point))
        parts = [(k, w) for k, w in ((i, 1 - part), (j, part)) if w]
        yield round(difference, 9) + DETOUR * length, difference, parts
