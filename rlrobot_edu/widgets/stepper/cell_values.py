"""What an agent thinks of the cells of the worked example: for each cell and heading, the value of the best action."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.robots.cell_robot import AHEAD, CELLS
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.stepper.tape import Tape

_HEADING = {0: "→", 90: "↑", -90: "↓"}
_SPIN = {90: "↺", -90: "↻"}
INPUTS = {"X", "Y", "theta", "d"}  # all that the place of robot and box decides


class Mark(NamedTuple):
    """A value at a place (x, y) [m]: the icons of the best actions there, and what they are worth."""

    x: float
    y: float
    icons: str
    value: float


class Place(NamedTuple):
    """A place (x, y) [m] of a mark, its state, and the icon of each action there."""

    x: float
    y: float
    s: int
    icons: list[str]


class CellValues:
    """The marks of a task in the cells, whose inputs are some of `INPUTS`."""

    def __init__(self, task: Task) -> None:
        self._places = {box: self._around(task, box) for box in CELLS}

    def _around(self, task: Task, box: tuple[int, int]) -> list[Place]:
        """Each place in which the robot can be while the box stays where it is."""
        commands, found = task.commands, []
        for x, y in CELLS:
            for heading, (dx, dy) in AHEAD.items():
                if (x, y) == box:
                    continue
                free = (x + dx, y + dy) in CELLS and (x + dx, y + dy) != box
                s = task.states.encode(
                    {"X": x, "Y": y, "theta": heading, "d": int(not free)}
                )
                icons = [
                    _HEADING[heading] if c["advance"] else _SPIN.get(c["spin"], "·")
                    for c in commands
                ]
                found.append(Place(x - 0.5 + 0.31 * dx, y - 0.5 + 0.31 * dy, s, icons))
        return found

    def of(self, tape: Tape, scene: Scene) -> list[Mark]:
        """The marks of the places that were visited, where the box is in this scene."""
        at = next(
            solid.pose[:2, 3] + 0.5 for solid in scene.solids if solid.name == "box"
        )
        found = []
        for x, y, s, icons in self._places[round(at[0]), round(at[1])]:
            if tape.visits[s].any():
                value = tape.q[s].max()
                best = np.flatnonzero(tape.q[s] == value).tolist()
                found.append(Mark(x, y, "".join(icons[a] for a in best), float(value)))
        return found

    def constant_data(self) -> dict[str, list[dict[str, Any]]]:
        """The places of each cell of the box, for worlds.js."""
        return {
            f"{box[0]},{box[1]}": [
                {"at": [round(p.x, 3), round(p.y, 3)], "s": p.s, "icons": p.icons}
                for p in places
            ]
            for box, places in self._places.items()
        }
