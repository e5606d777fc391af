"""The robot of the paper's worked example (section 3): four cells, three headings and a box in the way."""

import math
from collections.abc import Mapping

import numpy as np

from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import ROBOTS

BOX_MOVES = 0.1  # probability a step
CELLS = [(0, 0), (0, 1), (1, 0), (1, 1)]  # (X, Y)
# heading [deg] -> neighbouring cell; it never looks back along X
AHEAD = {0: (1, 0), 90: (0, 1), -90: (0, -1)}


class CellRobot(SimulatedRobot):
    """A robot that stands in one of 2 × 2 cells of 1 m. A box stands in another and now and then moves to a free one.

    scene: name of the arena
    step_time: duration of one control step [s]; a step is one move, however long it takes
    """

    def __init__(self, scene: str, step_time: float) -> None:
        super().__init__(ROBOTS["cell_robot"])
        self._arena = ARENAS[scene]
        self.reset()

    def _begin(self, rng: np.random.Generator) -> None:
        """Put the robot in cell (0, 0), heading along X, and the box in cell (1, 1); `rng` moves it later."""
        self._cell, self._heading, self._box, self._bumped, self._rng = (
            (0, 0),
            0,
            (1, 1),
            False,
            rng,
        )

    def _sense(self) -> dict[str, float]:
        """Cell X, Y; heading theta [deg]; d, 1 if a wall or the box is ahead; bumped, 1 if it has just run into it."""
        x, y = self._cell
        blocked = not self._is_free(self._cell_ahead())
        return {
            "X": x,
            "Y": y,
            "theta": self._heading,
            "d": int(blocked),
            "bumped": int(self._bumped),
        }

    def _move(self, command: Mapping[str, float]) -> None:
        """Spin by `spin` (−90, 0 or 90 [deg], 90 is to the left), then advance by `advance` (0 or 1 cells).

        The heading stays within ±90; an obstacle ahead stops the robot. Raises ValueError for any other command.
        """
        spin, advance = command["spin"], command["advance"]
        if spin not in AHEAD or advance not in (0, 1):
            raise ValueError(
                f"spin must be -90, 0 or 90 and advance 0 or 1, got {dict(command)}"
            )
        self._heading = int(min(max(self._heading + spin, -90), 90))
        target = self._cell_ahead()
        self._bumped = bool(advance) and not self._is_free(target)
        if advance and not self._bumped:
            self._cell = target
        if self._rng.random() < BOX_MOVES:
            free = [
                cell for cell in CELLS if self._is_free(cell) and cell != self._cell
            ]
            self._box = free[self._rng.integers(len(free))]

    def _cell_ahead(self) -> tuple[int, int]:
        dx, dy = AHEAD[self._heading]
        return self._cell[0] + dx, self._cell[1] + dy

    def _is_free(self, cell: tuple[int, int]) -> bool:
        return cell in CELLS and cell != self._box

    def scene(self) -> Scene:
        """The outer walls, the robot and the box."""
        x, y = (i - 0.5 for i in self._cell)
        box_x, box_y = (i - 0.5 for i in self._box)
        here = pose(x, y, 0.0, math.radians(self._heading))
        moving = (
            Solid(
                "robot/body", "cylinder", (0.3, 0.3), here @ pose(0, 0, 0.15), "robot"
            ),
            Solid(
                "robot/nose",
                "box",
                (0.2, 0.1, 0.05),
                here @ pose(0.2, 0, 0.325),
                "robot",
            ),
            Solid("box", "box", (0.6, 0.6, 0.3), pose(box_x, box_y, 0.15), "object"),
        )
        return Scene(
            self._arena.solids() + moving, np.empty((0, 2, 3)), self._arena.bounds
        )
