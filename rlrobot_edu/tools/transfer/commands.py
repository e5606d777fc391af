"""Actions of one task as actions of another: by what the robot is physically told in one step."""

from collections.abc import Iterator, Sequence
from itertools import combinations_with_replacement
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.task.robot_cards import ROBOTS, WHEELS
from rlrobot_edu.task.task import Task

TOLERANCE = (
    0.25  # how far a command may be from what stands for it, as part of the largest
)
EQUAL, NEAREST, DETOUR = 1e-9, 12, 0.01


class ActionMatch(NamedTuple):
    """What stands for an action of the target.

    action: its number; label: the values of its outputs
    sources: numbers and weights of the source's actions that are taken for it; none if there is nothing like it
    miss: how far their mean command is from its own, as part of the largest
    """

    action: int
    label: str
    sources: tuple[tuple[int, float], ...]
    miss: float


def label(task: Task, a: int) -> str:
    """Action `a` in short, without the outputs' names: ``(1, -1)``."""
    values = task.actions.decode(a)
    words = (
        v.words[v.values.index(values[v.name])] if v.words else f"{values[v.name]:g}"
        for v in task.actions.outputs
    )
    return f"({', '.join(words)})"


def motion(task: Task, a: int) -> dict[str, float]:
    """What the command of action `a` does in one step: metres ahead and radians to the left, and radians of joints."""
    command, card = task.command_for(a), ROBOTS[task.robot]
    told = {
        name: value
        * (task.step_time if card.commands[name].unit.endswith("/s") else 1.0)
        for name, value in command.items()
    }
    if task.robot in CHASSIS:
        wheels = {wheel: told.pop(wheel) for wheel in WHEELS}
        told["ahead"], told["turn"] = CHASSIS[task.robot].twist(wheels)
    return told


def match_actions(target: Task, source: Task) -> list[ActionMatch]:
    """For each action of `target` the source's that stand for it.

    The source's action of the same outputs and the same motion; or all that have its motion, alike; or the two between
    which its motion lies most nearly, each the more the nearer it is. Motions are compared as parts of the largest in
    either task; what is missed by more than `TOLERANCE` has no match. A command that a robot does not have counts as 0.

    Raises ValueError if the robots have no command in common.
    """
    wanted = [motion(target, a) for a in range(target.actions.n)]
    known = [motion(source, a) for a in range(source.actions.n)]
    if not wanted[0].keys() & known[0].keys():
        raise ValueError(
            f"{source.name} tells its robot {', '.join(known[0])}, {target.name} {', '.join(wanted[0])}: no action of "
            "one is like any of the other; choose tasks whose robots move alike"
        )
    parts = sorted(wanted[0].keys() | known[0].keys())
    theirs, ours = (
        np.array([[told.get(part, 0.0) for part in parts] for told in all_])
        for all_ in (known, wanted)
    )
    largest = np.abs(np.vstack([theirs, ours])).max(axis=0)
    largest[largest == 0] = 1.0
    points, number = np.unique(
        np.round(theirs / largest, 12), axis=0, return_inverse=True
    )
    alike = [np.flatnonzero(number.ravel() == i).tolist() for i in range(len(points))]
    matches = []
    for a, point in enumerate(ours / largest):
        miss, weights = _between(point, points)
        sources = (
            [(b, w / len(alike[i])) for i, w in weights for b in alike[i]]
            if miss <= TOLERANCE
            else []
        )
        same = [
            b
            for b, _ in sources
            if miss < EQUAL and source.actions.decode(b) == target.actions.decode(a)
        ]
        taken = [(b, 1.0) for b in same] or sorted(sources)
        matches.append(ActionMatch(a, label(target, a), tuple(taken), miss))
    return matches


def _between(
    point: np.ndarray, points: np.ndarray
) -> tuple[float, list[tuple[int, float]]]:
    """How near `points` come to `point`, alone or two together, and which they are with their weights."""
    near = np.argsort(np.linalg.norm(points - point, axis=1), kind="stable")[
        :NEAREST
    ].tolist()
    return min(_segments(point, points, near))[1:]


def _segments(
    point: np.ndarray, points: np.ndarray, near: Sequence[int]
) -> Iterator[tuple[float, float, list[tuple[int, float]]]]:
    """Cost, miss and weights of each way to meet `point` between two of `points`; a long way costs a little."""
    for i, j in combinations_with_replacement(near, 2):
        way = points[j] - points[i]
        length = float(np.linalg.norm(way))
        part = (
            float(np.clip((point - points[i]) @ way / length**2, 0, 1))
            if length
            else 0.0
        )
        part = float(round(part)) if abs(part - round(part)) < EQUAL else part
        miss = float(np.linalg.norm(points[i] + part * way - point))
        weights = (
            [(k, w) for k, w in ((i, 1 - part), (j, part)) if w]
            if i != j
            else [(i, 1.0)]
        )
        yield round(miss, 9) + DETOUR * length, miss, weights
