"""A room drawn with characters, one for each square of its floor, as the scene of a task."""

import inspect
import math
import re
from collections.abc import Iterator

import numpy as np
from scipy import ndimage

from rlrobot_edu.checks import check_between
from rlrobot_edu.task.room import Box, Room

WALL, FREE, GOAL = "#", ".", "G"
HEADINGS = {">": 0.0, "^": math.pi / 2, "<": math.pi, "v": -math.pi / 2}  # [rad]
ALSO = str.maketrans("+-| ", "###.")  # what may stand for walls and for free floor, too
MOST = 80  # lines, and characters in a line
CELL = (0.05, 10.0)  # the smallest and the largest [m]


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
    check_between("the cell of a drawing", cell, *CELL, unit=" of metres")
    grid = _grid(text)
    starts = np.argwhere(np.isin(grid, list(HEADINGS))).tolist()
    goals = np.argwhere(grid == GOAL).tolist()
    if len(starts) != 1 or len(goals) > 1:
        raise ValueError(
            f"a drawing needs one start, {' '.join(HEADINGS)}, and at most one goal, {GOAL}; "
            f"this one has {len(starts)} and {len(goals)}"
        )
    _check_room(grid, *starts, *goals)
    height, width = grid.shape

    def point(line: float, column: float) -> tuple[float, float]:
        x = (column - width / 2) * cell
        y = (height / 2 - line) * cell
        return round(x, 9), round(y, 9)

    def box(top: int, left: int, bottom: int, right: int) -> Box:
        x_min, y_min = point(bottom, left)
        x_max, y_max = point(top, right)
        return x_min, y_min, x_max, y_max

    line, column = starts[0]
    x, y = point(line + 0.5, column + 0.5)
    start = (x, y, HEADINGS[grid[line, column]])
    goal = None
    for line, column in goals:
        x, y = point(line + 0.5, column + 0.5)
        goal = (x, y, cell / 2)
    return Room(
        walls=tuple(box(*wall) for wall in _walls(grid).tolist()),
        bounds=box(1, 1, height - 1, width - 1),
        start=start,
        goal=goal,
    )


def _grid(text: str) -> np.ndarray:
    """The characters of a drawing in their standard form, array (lines, columns).

    Raises ValueError if it is not a drawing.
    """
    text = "\n".join(text.expandtabs().splitlines())
    # A first line that follows the quotes at once lacks the indentation of the others, as in a docstring.
    if text[:1].isspace():
        text = "\n" + text
    lines = inspect.cleandoc(text).translate(ALSO).split("\n")
    width = max(len(line.rstrip(FREE)) for line in lines)
    if len(lines) > MOST or width > MOST:
        raise ValueError(
            f"the drawing is too big: {len(lines)} lines of {width} characters; at most {MOST}"
        )
    grid = np.array([list(line[:width].ljust(width, FREE)) for line in lines])
    drawn = np.argwhere(grid != FREE)
    if not len(drawn):
        raise ValueError(
            "the drawing is empty: draw walls around a free floor, on which the robot starts"
        )
    top, left = drawn.min(axis=0)
    bottom, right = drawn.max(axis=0) + 1
    grid = grid[top:bottom, left:right]
    signs = [WALL, FREE, *HEADINGS, GOAL]
    unknown = np.argwhere(~np.isin(grid, signs)).tolist()
    if unknown:
        line, column = unknown[0]
        raise ValueError(
            f"{_place(line, column)} of the drawing is {grid.item(line, column)!r}, "
            f"expected one of {' '.join(signs)}"
        )
    return grid


def _place(line: int, column: int) -> str:
    return f"line {line + 1}, column {column + 1}"


def _check_room(
    grid: np.ndarray, start: list[int], goal: list[int] | None = None
) -> None:
    """Raises ValueError unless walls close the room around the start, and the goal is in it."""
    region, _ = ndimage.label(grid != WALL)
    reached = region == region[*start]
    if goal and not reached[*goal]:
        raise ValueError(
            f"the goal, in {_place(*goal)} of the drawing, is walled off from the start"
        )
    on_the_edge = np.ones_like(reached)
    on_the_edge[1:-1, 1:-1] = False
    gaps = np.argwhere(reached & on_the_edge).tolist()
    if gaps:
        raise ValueError(
            f"the room is not closed: it can be left in {_place(*gaps[0])}; put a # there"
        )


def _walls(grid: np.ndarray) -> np.ndarray:
    """Few long walls that cover the wall cells: top, left, bottom and right of each, array (n, 4) of int.

    They overlap at corners, so that no straight face of a wall has a seam.
    """
    found = set(_blocks(grid))
    for left, top, right, bottom in _blocks(grid.T):
        found.add((top, left, bottom, right))
    boxes = np.array(sorted(found))
    # Array (boxes, boxes): whether the box of the row is inside the box of the column
    begins_inside = (boxes[:, None, :2] >= boxes[:, :2]).all(2)
    ends_inside = (boxes[:, None, 2:] <= boxes[:, 2:]).all(2)
    containers = (begins_inside & ends_inside).sum(1)
    is_only_in_itself = containers == 1
    return np.asarray(boxes[is_only_in_itself])


def _blocks(grid: np.ndarray) -> Iterator[tuple[int, int, int, int]]:
    """The blocks of wall cells, as top, left, bottom and right.

    Cells side by side in a line are one block, and so are the same cells of the lines below.
    """
    lines = ["".join(cells) for cells in grid]
    begun: dict[tuple[int, int], int] = {}  # the top of each block, by left and right
    for i, line in enumerate([*lines, ""]):
        spans = {run.span() for run in re.finditer(f"{WALL}+", line)}
        for left, right in begun.keys() - spans:
            top = begun.pop((left, right))
            yield top, left, i, right
        for span in spans:
            begun.setdefault(span, i)
