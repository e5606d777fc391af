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
MOST = 80  # lines, and characters in a line: a page
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
    starts = np.argwhere(np.isin(grid, [*HEADINGS])).tolist()
    goals = np.argwhere(grid == GOAL).tolist()
    if len(starts) != 1 or len(goals) > 1:
        expected = f"one start, {' '.join(HEADINGS)}, and at most one goal, {GOAL}"
        raise ValueError(
            f"a drawing needs {expected}; this one has {len(starts)} and {len(goals)}"
        )
    _check_room(grid, *starts, *goals)
    height, width = grid.shape

    def point(line: float, column: float) -> tuple[float, float]:
        x, y = (column - width / 2) * cell, (height / 2 - line) * cell
        return round(x, 9), round(y, 9)

    def middle(line: int, column: int) -> tuple[float, float]:
        return point(line + 0.5, column + 0.5)

    def box(top: int, left: int, bottom: int, right: int) -> Box:
        return *point(bottom, left), *point(top, right)

    return Room(
        walls=tuple(box(*wall) for wall in _walls(grid).tolist()),
        bounds=box(1, 1, height - 1, width - 1),
        start=(*middle(*starts[0]), HEADINGS[grid[*starts[0]]]),
        goal=(*middle(*goals[0]), cell / 2) if goals else None,
    )


def _grid(text: str) -> np.ndarray:
    """The characters of a drawing, array (lines, columns), in their one form. Raises ValueError if it is none."""
    text = "\n".join(text.expandtabs().splitlines())
    # A first line that follows the quotes at once lacks the indentation of the others, as in a docstring.
    lines = (
        inspect.cleandoc("\n" * text[:1].isspace() + text).translate(ALSO).split("\n")
    )
    width = max(len(line.rstrip(FREE)) for line in lines)
    if len(lines) > MOST or width > MOST:
        raise ValueError(
            f"the drawing is too big: {len(lines)} lines of {width} characters; at most {MOST}"
        )
    grid = np.array([[*line[:width].ljust(width, FREE)] for line in lines])
    drawn = np.argwhere(grid != FREE)
    if not len(drawn):
        raise ValueError(
            "the drawing is empty: draw walls around a free floor, on which the robot starts"
        )
    (top, left), (bottom, right) = drawn.min(axis=0), drawn.max(axis=0) + 1
    grid = grid[top:bottom, left:right]
    signs = [WALL, FREE, *HEADINGS, GOAL]
    for at in np.argwhere(~np.isin(grid, signs)):
        expected = f"expected one of {' '.join(signs)}"
        raise ValueError(
            f"{_place(*at)} of the drawing is {grid.item(*at)!r}, {expected}"
        )
    return grid


def _place(line: int, column: int) -> str:
    return f"line {line + 1}, column {column + 1}"


def _check_room(
    grid: np.ndarray, start: list[int], goal: list[int] | None = None
) -> None:
    """Raises ValueError unless walls close the room around the start, and the goal is in it."""
    region = ndimage.label(grid != WALL)[0]
    reached = region == region[*start]
    if goal and not reached[*goal]:
        raise ValueError(
            f"the goal, in {_place(*goal)} of the drawing, is walled off from the start"
        )
    reached[1:-1, 1:-1] = False
    for gap in np.argwhere(reached):
        raise ValueError(
            f"the room is not closed: it can be left in {_place(*gap)}; put a # there"
        )


def _walls(grid: np.ndarray) -> np.ndarray:
    """Few long walls that cover the wall cells: top, left, bottom and right of each, array (n, 4) of int.

    They overlap at corners, so that no straight face of a wall has a seam.
    """
    across = (
        (top, left, bottom, right) for left, top, right, bottom in _blocks(grid.T)
    )
    boxes = np.array(sorted({*_blocks(grid), *across}))
    # is the box of the row in the column's?
    inside = (boxes[:, None, :2] >= boxes[:, :2]).all(2) & (
        boxes[:, None, 2:] <= boxes[:, 2:]
    ).all(2)
    return np.asarray(
        boxes[inside.sum(1) == 1]
    )  # those that are in no box but themselves


def _blocks(grid: np.ndarray) -> Iterator[tuple[int, int, int, int]]:
    """Wall cells side by side in a line; where the next lines have the same, they are one block."""
    begun: dict[
        tuple[int, int], int
    ] = {}  # first line of the block between two columns
    for i, line in enumerate([*map("".join, grid), ""]):
        spans = {run.span() for run in re.finditer(f"{WALL}+", line)}
        for left, right in begun.keys() - spans:
            yield begun.pop((left, right)), left, i, right
        begun = dict.fromkeys(spans, i) | begun
