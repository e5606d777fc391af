"""The values of the cells of the worked example: for each cell and heading, the value of the best action."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.robots.cell_robot import AHEAD, CELLS
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.stepper.tape import Tape

_HEADING = {0: "→", 90: "↑", -90: "↓"}
_SPIN = {90: "↺", -90: "↻"}
ASIDE = 0.345  # of a mark from the middle of its cell [m]: beside the robot
INPUTS = {
    "X",
    "Y",
    "theta",
    "d",
}  # those that depend only on the place of robot and box


class Mark(NamedTuple):
    """A value at a place (x, y) [m]: the icons of the best actions there, and what they are worth.

    Where the robot was before the step, is_its: the icon and the value of what it did; was: its value before, if the
    step has changed it
    """

    x: float
    y: float
    icons: str
    value: float
    is_its: bool = False
    was: float | None = None


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
        free = [cell for cell in CELLS if cell != box]
        found = []
        for x, y in free:
            for heading, (dx, dy) in AHEAD.items():
                is_blocked = (x + dx, y + dy) not in free
                readings = {"X": x, "Y": y, "theta": heading, "d": int(is_blocked)}
                s = task.states.encode(readings)
                icons = [_icon(command, heading) for command in task.commands]
                found.append(
                    Place(x - 0.5 + ASIDE * dx, y - 0.5 + ASIDE * dy, s, icons)
                )
        return found

    def of(self, tape: Tape, scene: Scene) -> list[Mark]:
        """The marks of the places that were visited, where the box is in this scene."""
        box = next(solid for solid in scene.solids if solid.name == "box")
        cell_x, cell_y = box.pose[:2, 3] + 0.5
        found = []
        frame = tape.frame
        for x, y, s, icons in self._places[round(cell_x), round(cell_y)]:
            if frame is not None and s == frame.step.s:
                now = frame.q_sa_new
                was = None if now == frame.q_sa else frame.q_sa
                found.append(Mark(x, y, icons[frame.step.a], now, True, was))
            elif tape.visits[s].any():
                value = tape.q[s].max()
                best = np.flatnonzero(tape.q[s] == value).tolist()
                their_icons = "".join(icons[a] for a in best)
                found.append(Mark(x, y, their_icons, float(value)))
        return found

    def constant_data(self) -> dict[str, list[dict[str, Any]]]:
        """The places of each cell of the box, for worlds.js."""
        data = {}
        for (box_x, box_y), places in self._places.items():
            data[f"{box_x},{box_y}"] = [
                {"at": [round(p.x, 3), round(p.y, 3)], "s": p.s, "icons": p.icons}
                for p in places
            ]
        return data


def _icon(command: Mapping[str, float], heading: int) -> str:
    """A command of a robot that looks in this direction [deg], as one sign."""
    if command["advance"]:
        return _HEADING[heading]
    return _SPIN.get(command["spin"], "·")
