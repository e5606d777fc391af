"""A room drawn with characters, one for each square of its floor, as the scene of a task."""

import inspect
import math
import re
from collections.abc import Collection
from typing import NamedTuple

import numpy as np
from scipy import ndimage

from rlrobot_edu.checks import check_between
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.task.room import Box, Room

WALL = "#"
FREE = "."
GOAL = "G"
HEADINGS = {">": 0.0, "^": math.pi / 2, "<": math.pi, "v": -math.pi / 2}  # [rad]
SIGNS = [WALL, FREE, *HEADINGS, GOAL]
SYNONYMS = str.maketrans({"+": WALL, "-": WALL, "|": WALL, " ": FREE})
MOST = 80  # lines, and characters in a line: a page
SMALLEST_CELL = 0.05  # [m]
LARGEST_CELL = 10.0  # [m]


class Block(NamedTuple):
    """A rectangle of cells: lines `top` to `bottom` and columns `left` to `right`, without the last of each."""

    top: int
    left: int
    bottom: int
    right: int

    def turned(self) -> "Block":
        """The same rectangle in a drawing whose columns are the lines of this one."""
        return Block(self.left, self.top, self.right, self.bottom)


@suggests_keywords
def draw_room(text: str, cell: float = 0.6) -> Room:
    '''A room seen from above, drawn with one character for each square cell of its floor.

    =============== ==============================================================
    character       what is in its cell
    =============== ==============================================================
    ``#``           a wall; ``+``, ``-`` and ``|`` are walls, too
    ``.`` or space  free floor
    ``> ^ < v``     where the robot starts, and which way it looks; there is one
    ``G``           free floor, marked as the goal; there may be one
    =============== ==============================================================

    Indentation, blank lines around the drawing and spaces at the ends of its lines do not matter.
    The room may have any form; what lies outside of its walls is left blank.

    Parameters
    ----------
    text : str
        The drawing, the top line first: x points to the right, y up, and (0, 0) is the middle of the drawing.
    cell : float [m]
        Width of a cell, and so of a wall and of the narrowest corridor: from 0.05 to 10. In cells of 0.6 the mobile
        base can just turn round.

    Returns
    -------
    Room
        Wall cells side by side are one long wall, and crossing walls overlap. The goal is as wide as a cell.

    Raises
    ------
    ValueError
        In one sentence, with line and column in the drawing, for an unknown character, no start or two, two goals or
        one that is walled off, or a room that is not closed; for a drawing that is empty or too big, and a bad `cell`.

    Examples
    --------
    >>> room = draw_room("""
    ...     ########
    ...     #>    G#
    ...     ########
    ... """, cell=0.6)
    >>> room.bounds
    (-1.8, -0.3, 1.8, 0.3)
    '''
    if not isinstance(text, str):
        raise ValueError(f"a drawing is a text of lines, got {text!r:.200}")
    check_between(
        "the cell of a drawing", cell, SMALLEST_CELL, LARGEST_CELL, unit=" of metres"
    )
    grid = _grid(text)
    starts = _places_of(HEADINGS, grid)
    goals = _places_of(GOAL, grid)
    _check_counts(len(starts), len(goals))
    start_line, start_column = starts[0]
    _check_closed(_room_around(grid, start_line, start_column), goals)
    height, width = grid.shape

    def point(line: float, column: float) -> tuple[float, float]:
        x = (column - width / 2) * cell
        y = (height / 2 - line) * cell
        return round(x, 9), round(y, 9)

    def box(block: Block) -> Box:
        x_min, y_min = point(block.bottom, block.left)
        x_max, y_max = point(block.top, block.right)
        return x_min, y_min, x_max, y_max

    x, y = point(start_line + 0.5, start_column + 0.5)
    theta = HEADINGS[grid[start_line, start_column]]
    goal = None
    for line, column in goals:
        goal_x, goal_y = point(line + 0.5, column + 0.5)
        goal = (goal_x, goal_y, cell / 2)
    return Room(
        walls=tuple(box(wall) for wall in _walls(grid)),
        bounds=box(Block(1, 1, height - 1, width - 1)),
        start=(x, y, theta),
        goal=goal,
    )


def _grid(text: str) -> np.ndarray:
    """The characters of a drawing without blank edges, array (lines, columns). Raises ValueError if it is none."""
    lines = _lines(text)
    width = max(len(line) for line in lines)
    if len(lines) > MOST or width > MOST:
        raise ValueError(
            f"the drawing is too big: {len(lines)} lines of {width} characters; at most {MOST}"
        )
    grid = np.array([list(line.ljust(width, FREE)) for line in lines])
    drawn = np.argwhere(grid != FREE)
    if not drawn.size:
        raise ValueError(
            "the drawing is empty: draw walls around a free floor, on which the robot starts"
        )
    top, left = drawn.min(axis=0)
    bottom, right = drawn.max(axis=0)
    grid = grid[top : bottom + 1, left : right + 1]
    unknown = np.argwhere(~np.isin(grid, SIGNS))
    if unknown.size:
        line, column = unknown[0].tolist()
        raise ValueError(
            f"{_place(line, column)} of the drawing is {grid.item(line, column)!r}, "
            f"expected one of {' '.join(SIGNS)}"
        )
    return grid


def _lines(text: str) -> list[str]:
    """The lines without their common indentation, with one character for each kind of cell."""
    text = "\n".join(text.expandtabs().splitlines())
    # cleandoc takes the first line for that of a docstring, which follows the quotes and has no indentation. A drawing
    # may begin so, too; where its first line is indented, it is one of the others.
    if text[:1].isspace():
        text = "\n" + text
    text = inspect.cleandoc(text).translate(SYNONYMS)
    return [line.rstrip(FREE) for line in text.split("\n")]


def _places_of(signs: Collection[str], grid: np.ndarray) -> list[tuple[int, int]]:
    """Line and column of each cell with one of these characters."""
    found = np.argwhere(np.isin(grid, list(signs)))
    return [(line, column) for line, column in found.tolist()]


def _place(line: int, column: int) -> str:
    return f"line {line + 1}, column {column + 1}"


def _check_counts(n_starts: int, n_goals: int) -> None:
    if n_starts != 1 or n_goals > 1:
        raise ValueError(
            f"a drawing needs one start, {' '.join(HEADINGS)}, and at most one goal, {GOAL}; "
            f"this one has {n_starts} and {n_goals}"
        )


def _room_around(grid: np.ndarray, line: int, column: int) -> np.ndarray:
    """Which cells can be reached from this one, array (lines, columns) of bool."""
    region, _ = ndimage.label(grid != WALL)
    return np.asarray(region == region[line, column])


def _check_closed(reached: np.ndarray, goals: list[tuple[int, int]]) -> None:
    """Raises ValueError if a goal cannot be reached, or if the edge of the drawing can."""
    for line, column in goals:
        if not reached[line, column]:
            raise ValueError(
                f"the goal, in {_place(line, column)} of the drawing, is walled off from the start"
            )
    is_edge = np.ones_like(reached)
    is_edge[1:-1, 1:-1] = False
    gaps = np.argwhere(reached & is_edge)
    if gaps.size:
        line, column = gaps[0].tolist()
        raise ValueError(
            f"the room is not closed: it can be left in {_place(line, column)}; put a # there"
        )


def _walls(grid: np.ndarray) -> list[Block]:
    """Few long walls that cover the wall cells. They overlap at corners, so that no straight face has a seam."""
    of_lines = _blocks(grid)
    of_columns = [block.turned() for block in _blocks(grid.T)]
    blocks = sorted({*of_lines, *of_columns})
    corners = np.array(blocks)
    walls = []
    for block in blocks:
        begins_before = (corners[:, :2] <= block[:2]).all(axis=1)
        ends_after = (corners[:, 2:] >= block[2:]).all(axis=1)
        n_around = np.count_nonzero(begins_before & ends_after)
        if n_around == 1:  # the block itself; all others lie within a longer one
            walls.append(block)
    return walls


def _blocks(grid: np.ndarray) -> list[Block]:
    """Wall cells side by side in a line; where the next lines have the same, they are one block."""
    blocks = []
    begun: dict[tuple[int, int], int] = {}  # first line of each block, by its columns
    lines = ["".join(line) for line in grid]
    for i, line in enumerate([*lines, ""]):  # in the empty one, all blocks end
        runs = {run.span() for run in re.finditer(f"{WALL}+", line)}
        for run in begun.keys() - runs:
            left, right = run
            blocks.append(Block(begun.pop(run), left, i, right))
        for run in runs:
            begun.setdefault(run, i)
    return blocks
