"""The robot of the paper's worked example (section 3): four cells, three headings and a box in the way."""

import math
from collections.abc import Mapping

import numpy as np

from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import ROBOTS

Cell = tuple[int, int]  # X, Y

BOX_MOVES = 0.1  # probability a step
CELLS = [(0, 0), (0, 1), (1, 0), (1, 1)]
# heading [deg] -> way to the cell ahead; the robot never looks back along X
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
        self._cell = (0, 0)
        self._heading = 0
        self._box = (1, 1)
        self._bumped = False
        self._rng = rng

    def _sense(self) -> dict[str, float]:
        """Cell X, Y; heading theta [deg]; d, 1 if a wall or the box is ahead; bumped, 1 after running into it."""
        x, y = self._cell
        is_blocked = not self._is_free(self._cell_ahead())
        return {
            "X": x,
            "Y": y,
            "theta": self._heading,
            "d": int(is_blocked),
            "bumped": int(self._bumped),
        }

    def _move(self, command: Mapping[str, float]) -> None:
        """Spin by `spin` (−90, 0 or 90 [deg], 90 is to the left), then advance by `advance` (0 or 1 cells).

        The heading stays within ±90; an obstacle ahead stops the robot. Raises ValueError for any other command.
        """
        spin = command["spin"]
        advance = command["advance"]
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
            empty = [cell for cell in CELLS if cell not in (self._box, self._cell)]
            self._box = empty[self._rng.integers(len(empty))]

    def _cell_ahead(self) -> Cell:
        x, y = self._cell
        dx, dy = AHEAD[self._heading]
        return x + dx, y + dy

    def _is_free(self, cell: Cell) -> bool:
        """Whether the robot could drive into this cell."""
        return cell in CELLS and cell != self._box

    def scene(self) -> Scene:
        """The outer walls, the robot and the box."""
        x, y = _middle_of(self._cell)
        box_x, box_y = _middle_of(self._box)
        here = pose(x, y, 0.0, math.radians(self._heading))
        body_at = here @ pose(0, 0, 0.15)
        nose_at = here @ pose(0.2, 0, 0.325)
        box_at = pose(box_x, box_y, 0.15)
        moving = (
            Solid("robot/body", "cylinder", (0.3, 0.3), body_at, "robot"),
            Solid("robot/nose", "box", (0.2, 0.1, 0.05), nose_at, "robot"),
            Solid("box", "box", (0.6, 0.6, 0.3), box_at, "object"),
        )
        no_beams = np.empty((0, 2, 3))
        solids = self._arena.solids() + moving
        return Scene(solids, no_beams, self._arena.bounds, self._bumped)


def _middle_of(cell: Cell) -> tuple[float, float]:
    """Where the middle of a cell is [m]."""
    x, y = cell
    return x - 0.5, y - 0.5
