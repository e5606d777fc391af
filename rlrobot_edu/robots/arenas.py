"""The arenas that mobile robots move about in: walls and starting place, as data; and the arena of a `Room`."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, radians, sin
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import Solid, pose
from rlrobot_edu.task.room import Room

Place = str | Room  # the name of an arena, or a room of one's own
Point = tuple[float, float]  # x, y [m]
Start = tuple[float, float, float]  # x, y, theta [m, m, rad]

WALL_THICKNESS = 0.1  # [m]
WALL_HEIGHT = 0.4  # [m]
TABLE_HEIGHT = 0.22  # [m]; the lasers see the table, and the arm reaches over it


class Wall(NamedTuple):
    """An upright box on the floor.

    x, y: its centre [m]
    length, thickness, height: its size [m]
    angle: direction of its length, from the x axis to the left [rad]
    name: of its solid in a scene; a wall without a name gets a number
    """

    x: float
    y: float
    length: float
    thickness: float = WALL_THICKNESS
    angle: float = 0.0
    height: float = WALL_HEIGHT
    name: str = ""

    def corners(self) -> np.ndarray:
        """Its four corners on the floor, counter-clockwise [m]; array (4, 2)."""
        along = np.array([cos(self.angle), sin(self.angle)]) * self.length / 2
        across = np.array([-sin(self.angle), cos(self.angle)]) * self.thickness / 2
        corners = [-along - across, along - across, along + across, across - along]
        return np.array(corners) + (self.x, self.y)


class Arena(NamedTuple):
    """Walls and a starting place.

    bounds: (x_min, y_min, x_max, y_max), the floor inside the outer walls [m]
    start: (x, y, theta) of the robot at the beginning [m, m, rad]
    goal: (x, y, radius) of the place to reach [m], or None; it is only a mark on the floor
    """

    walls: tuple[Wall, ...]
    bounds: tuple[float, float, float, float]
    start: Start
    goal: tuple[float, float, float] | None = None

    def solids(self) -> tuple[Solid, ...]:
        """The walls, and the goal if there is one, for a viewer to draw."""
        solids = []
        for i, wall in enumerate(self.walls):
            name = wall.name or f"wall/{i}"
            size = (wall.length, wall.thickness, wall.height)
            here = pose(wall.x, wall.y, wall.height / 2, wall.angle)
            solids.append(Solid(name, "box", size, here, "wall"))
        if self.goal is not None:
            x, y, radius = self.goal
            here = pose(x, y, 0.005)
            solids.append(Solid("goal", "cylinder", (radius, 0.01), here, "goal"))
        return tuple(solids)


def _square(
    side: float, *inside: Wall, start: Start, height: float = WALL_HEIGHT
) -> Arena:
    """A square floor of `side` [m] around the origin: outer walls of this `height` [m], then the walls `inside`."""
    middle = (side + WALL_THICKNESS) / 2
    length = side + 2 * WALL_THICKNESS
    outer = (
        Wall(0, -middle, length, angle=0.0, height=height),
        Wall(middle, 0, length, angle=pi / 2, height=height),
        Wall(0, middle, length, angle=0.0, height=height),
        Wall(-middle, 0, length, angle=pi / 2, height=height),
    )
    half = side / 2
    return Arena((*outer, *inside), (-half, -half, half, half), start)


def _walls_around(*corners: Point) -> tuple[Wall, ...]:
    """Walls along the sides of a convex floor, whose corners are given counter-clockwise."""
    walls = []
    for (x, y), (next_x, next_y) in pairwise([*corners, corners[0]]):
        dx = next_x - x
        dy = next_y - y
        angle = atan2(dy, dx)
        middle_x = (x + next_x) / 2 + sin(angle) * WALL_THICKNESS / 2
        middle_y = (y + next_y) / 2 - cos(angle) * WALL_THICKNESS / 2
        length = hypot(dx, dy) + 2 * WALL_THICKNESS
        walls.append(Wall(middle_x, middle_y, length, angle=angle))
    return tuple(walls)


def _along_y(x: float, y: float, length: float) -> Wall:
    return Wall(x, y, length, angle=pi / 2)


_CENTRE = (0.0, 0.0, 0.0)
_MAZE_6X6 = (
    # around the floor
    Wall(0, -3, 6),
    _along_y(2.95, 0, 6),
    Wall(0, 3, 6),
    _along_y(-2.95, 0, 6),
    # a corner in each quarter
    Wall(2.35, -1.85, 1),
    _along_y(1.9, -2.425, 1),
    _along_y(-1.95, 2.375, 1),
    Wall(-2.375, 1.8, 1),
    Wall(2.375, 1.95, 1),
    _along_y(1.8, 2.4, 1),
    Wall(-2.375, -1.825, 1),
    _along_y(-1.825, -2.4, 1),
    # walls that stand alone
    _along_y(-0.025, -2.4, 1),
    Wall(-1.15, 0.875, 1, angle=radians(60)),
    _along_y(1.775, 0.175, 1),
    Wall(0.6, 1.55, 1, angle=radians(130)),
    Wall(0.925, -0.95, 0.5, angle=radians(130)),
    _along_y(-0.875, -0.9, 1),
)
_MAZE_4X4 = (
    # around the floor
    Wall(0, -2.025, 4),
    _along_y(2.05, 0, 4),
    Wall(0, 2.05, 4),
    _along_y(-2.05, 0, 4),
    # walls that stand alone
    Wall(-1.5, -1, 1),
    Wall(0, 0.025, 2),
    Wall(1.475, 1, 1),
)
_HEXAGON = _walls_around(
    (0.75, 0.0),
    (0.375, 0.5),
    (-0.375, 0.5),
    (-0.75, 0.0),
    (-0.375, -0.5),
    (0.375, -0.5),
)
_TABLE = Wall(1.25, 0, 0.8, 0.5, angle=pi / 2, height=TABLE_HEIGHT, name="table")

ARENAS = {
    "square_2x2": _square(2.0, start=_CENTRE),
    # the mazes and the hexagon are as in the paper's V-REP scenes
    "maze_6x6": Arena(
        _MAZE_6X6,
        bounds=(-2.9, -2.95, 2.9, 2.95),
        start=_CENTRE,
    ),
    "maze_4x4_goal": Arena(
        _MAZE_4X4,
        bounds=(-2.0, -1.975, 2.0, 2.0),
        start=(-1.5, -1.475, 0.0),
        goal=(1.65, 1.575, 0.5),
    ),
    "hexagon_giraff": Arena(
        _HEXAGON,
        bounds=(-0.75, -0.5, 0.75, 0.5),
        start=_CENTRE,
    ),
    "table_room": _square(3.0, _TABLE, start=(0.1, -0.35, 0.0), height=TABLE_HEIGHT),
    "four_cells": _square(2.0, start=(-0.5, -0.5, 0.0)),
}


def arena_of(scene: Place) -> Arena:
    """The arena of this name, or the room as an arena."""
    if isinstance(scene, str):
        return ARENAS[scene]
    walls = []
    for x_min, y_min, x_max, y_max in scene.walls:
        middle_x = (x_min + x_max) / 2
        middle_y = (y_min + y_max) / 2
        walls.append(Wall(middle_x, middle_y, x_max - x_min, y_max - y_min))
    return Arena(tuple(walls), scene.bounds, scene.start, scene.goal)
