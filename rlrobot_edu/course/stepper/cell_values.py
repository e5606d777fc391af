"""What an agent thinks of the cells of the worked example: for each cell and heading, the value of the best action."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.robots.cell_robot import AHEAD, CELLS, CellRobot
from rlrobot_edu.robots.scene import Scene

_HEADING = {0: "→", 90: "↑", -90: "↓"}
_SPIN = {90: "↺", -90: "↻"}


class Mark(NamedTuple):
    """A value at a place (x, y) [m]: the icons of the best actions there, and what they are worth."""

    x: float
    y: float
    icons: str
    value: float
    state: int


def marks_of(robot: Any, names: Names) -> Callable[[Tape, Scene], list[Mark]] | None:
    """Function that finds the marks of a tape in a scene; None if `robot` does not live in cells."""
    task = names.task
    if not isinstance(robot, CellRobot) or task is None or not {"X", "Y", "theta", "d"} >= set(names.inputs):
        return None

    @lru_cache
    def states(box: tuple[int, int]) -> list[tuple[int, int, int, int]]:
        """Cell, heading and state of each place in which the robot can be while the box stays where it is."""
        found = []
        for x, y in CELLS:
            for heading, (dx, dy) in AHEAD.items():
                free = (x + dx, y + dy) in CELLS and (x + dx, y + dy) != box
                readings = {"X": x, "Y": y, "theta": heading, "d": int(not free)}
                found += [(x, y, heading, task.states.encode(readings))] if (x, y) != box else []
        return found

    def icon(a: int, heading: int) -> str:
        command = task.command(task.actions.decode(a))
        return _HEADING[heading] if command["advance"] else _SPIN.get(command["spin"], "·")

    def marks(tape: Tape, scene: Scene) -> list[Mark]:
        at = next(solid.pose[:2, 3] + 0.5 for solid in scene.solids if solid.name == "box")
        found = []
        for x, y, heading, s in states((round(at[0]), round(at[1]))):
            if tape.visits[s].any():
                value = tape.q[s].max()
                best = "".join(icon(a, heading) for a in np.flatnonzero(tape.q[s] == value).tolist())
                dx, dy = AHEAD[heading]
                found.append(Mark(x - 0.5 + 0.31 * dx, y - 0.5 + 0.31 * dy, best, float(value), s))
        return found

    return marks
