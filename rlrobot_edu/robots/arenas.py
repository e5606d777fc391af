"""The arenas that mobile robots move about in: walls and starting place, as data; and the arena of a `Room`."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, radians, sin
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import Solid, pose
from rlrobot_edu.task.room import Room

Place = (
    str | Room
)  # where a robot may be: in an arena of this name, or in a room of one's own
THICKNESS = 0.1  # of a wall, where nothing else is said [m]
TABLE_HEIGHT = (
    0.22  # of the table in its room [m]; the lasers see it, and the arm reaches over it
)


class Wall(NamedTuple):
    """An upright box on the floor.

    x, y: its centre [m]
    length, thickness, height: its size [m]
    angle: direction of its length, from the x axis to the left [rad]
    name: in a scene; a wall without one is numbered
    """

    x: float
    y: float
    length: float
    thickness: float = THICKNESS
    angle: float = 0.0
    height: float = 0.4
    name: str = ""

    def corners(self) -> np.ndarray:
        """Its four corners on the floor, counter-clockwise [m]; array (4, 2)."""
        along = np.array([cos(self.angle), sin(self.angle)]) * self.length / 2
        across = np.array([-sin(self.angle), cos(self.angle)]) * self.thickness / 2
        return np.array(
            [-along - across, along - across, along + across, across - along]
        ) + (self.x, self.y)


class Arena(NamedTuple):
    """Walls and a starting place.

    bounds: (x_min, y_min, x_max, y_max), the floor inside the outer walls [m]
    start: (x, y, theta) of the robot at the beginning [m, m, rad]
    goal: (x, y, radius) of the place to reach [m], or None; nothing but a mark on the floor
    """

    walls: tuple[Wall, ...]
    bounds: tuple[float, float, float, float]
    start: tuple[float, float, float]
    goal: tuple[float, float, float] | None = None

    def solids(self) -> tuple[Solid, ...]:
        """The walls, and the goal if there is one, for a viewer to draw."""
        solids = []
        for i, wall in enumerate(self.walls):
            size = (wall.length, wall.thickness, wall.height)
            here = pose(wall.x, wall.y, wall.height / 2, wall.angle)
            solids.append(Solid(wall.name or f"wall/{i}", "box", size, here, "wall"))
        if self.goal is not None:
            x, y, radius = self.goal
            solids.append(
                Solid("goal", "cylinder", (radius, 0.01), pose(x, y, 0.005), "goal")
            )
        return tuple(solids)


def _square(
    side: float, *inside: Wall, start: tuple[float, float, float], height: float = 0.4
) -> Arena:
    """A square floor of `side` [m] around the origin, with outer walls of this `height` [m] and walls `inside`."""
    middle, length = (side + THICKNESS) / 2, side + 2 * THICKNESS
    places = (
        (0, -middle, 0.0),
        (middle, 0, pi / 2),
        (0, middle, 0.0),
        (-middle, 0, pi / 2),
    )
    outer = (Wall(x, y, length, angle=angle, height=height) for x, y, angle in places)
    return Arena((*outer, *inside), (-side / 2, -side / 2, side / 2, side / 2), start)


def _walls_around(*corners: tuple[float, float]) -> tuple[Wall, ...]:
    """Walls along the sides of a convex floor, whose corners [m] are given counter-clockwise."""
    walls = []
    for (x, y), (next_x, next_y) in pairwise([*corners, corners[0]]):
        angle = atan2(next_y - y, next_x - x)
        middle_x = (x + next_x) / 2 + sin(angle) * THICKNESS / 2
        middle_y = (y + next_y) / 2 - cos(angle) * THICKNESS / 2
        length = hypot(next_x - x, next_y - y) + 2 * THICKNESS
        walls.append(Wall(middle_x, middle_y, length, angle=angle))
    return tuple(walls)


def _along_y(x: float, y: float, length: float) -> Wall:
    return Wall(x, y, length, angle=pi / 2)


_MAZE_6X6 = (
    *(Wall(0, -3, 6), _along_y(2.95, 0, 6), Wall(0, 3, 6), _along_y(-2.95, 0, 6)),
    # a corner in each quarter
    *(
        Wall(2.35, -1.85, 1),
        _along_y(1.9, -2.425, 1),
        _along_y(-1.95, 2.375, 1),
        Wall(-2.375, 1.8, 1),
    ),
    *(
        Wall(2.375, 1.95, 1),
        _along_y(1.8, 2.4, 1),
        Wall(-2.375, -1.825, 1),
        _along_y(-1.825, -2.4, 1),
    ),
    _along_y(-0.025, -2.4, 1),
    Wall(-1.15, 0.875, 1, angle=radians(60)),
    _along_y(1.775, 0.175, 1),
    Wall(0.6, 1.55, 1, angle=radians(130)),
    Wall(0.925, -0.95, 0.5, angle=radians(130)),
    _along_y(-0.875, -0.9, 1),
)
_MAZE_4X4 = (
    *(
        Wall(0, -2.025, 4),
        _along_y(2.05, 0, 4),
        Wall(0, 2.05, 4),
        _along_y(-2.05, 0, 4),
    ),
    *(Wall(-1.5, -1, 1), Wall(0, 0.025, 2), Wall(1.475, 1, 1)),
)
_TABLE = Wall(1.25, 0, 0.8, 0.5, pi / 2, TABLE_HEIGHT, "table")
_HEXAGON = (
    (0.75, 0.0),
    (0.375, 0.5),
    (-0.375, 0.5),
    (-0.75, 0.0),
    (-0.375, -0.5),
    (0.375, -0.5),
)

ARENAS = {
    "square_2x2": _square(2.0, start=(0.0, 0.0, 0.0)),
    # as in the paper's V-REP scenes
    "maze_6x6": Arena(_MAZE_6X6, (-2.9, -2.95, 2.9, 2.95), start=(0.0, 0.0, 0.0)),
    "maze_4x4_goal": Arena(
        _MAZE_4X4, (-2.0, -1.975, 2.0, 2.0), (-1.5, -1.475, 0.0), (1.65, 1.575, 0.5)
    ),
    "hexagon_giraff": Arena(
        _walls_around(*_HEXAGON), (-0.75, -0.5, 0.75, 0.5), start=(0.0, 0.0, 0.0)
    ),
    "table_room": _square(3.0, _TABLE, start=(0.1, -0.35, 0.0), height=TABLE_HEIGHT),
    "four_cells": _square(2.0, start=(-0.5, -0.5, 0.0)),
}


def arena_of(scene: Place) -> Arena:
    """The arena of this name, or the room."""
    if isinstance(scene, str):
        return ARENAS[scene]
    walls = [
        Wall((x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0)
        for x0, y0, x1, y1 in scene.walls
    ]
    return Arena(tuple(walls), scene.bounds, scene.start, scene.goal)
