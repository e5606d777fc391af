"""A world of one's own, drawn with characters: a small value that can be the scene of a task."""

import math
import re
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass, field
from numbers import Real

import numpy as np

WALL, FREE, GOAL = "#", ".", "G"
HEADINGS = {">": 0.0, "^": math.pi / 2, "<": math.pi, "v": -math.pi / 2}  # [rad]
ALSO = str.maketrans("+-| ", "###.")  # what may stand for walls and for free floor, too
MOST = 80  # lines, and characters in a line: a page
SMALLEST, LARGEST = 0.05, 10.0  # size of a cell [m]

Place = tuple[int, int]  # number of a line, of a character in it, from 0
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Drawing:
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
    What is outside of the walls does not matter either, so a room may have any form.

    Parameters
    ----------
    text : str
        The drawing, the top line first: x points to the right, y up, and (0, 0) is the middle of the drawing.
        It is kept in one form, with ``#`` for walls and ``.`` for free floor, so that equal drawings are equal.
    cell : float [m]
        Width of a cell, and so of a wall and of the narrowest corridor: from 0.05 to 10.

    Attributes
    ----------
    start : tuple of float
        x, y and theta of the robot at the beginning [m, m, rad].
    goal : tuple of float, or None
        x, y and radius of the goal [m]; the reward or the goal of a task may ask how far it is.
    walls : tuple of tuple of float
        x_min, y_min, x_max, y_max of each wall [m]. Cells side by side are one long wall; crossing walls overlap.
    bounds : tuple of float
        x_min, y_min, x_max, y_max of the floor that can be reached from the start [m].

    Raises
    ------
    ValueError
        In one sentence, with line and column in the drawing, for an unknown character, no start or two, two goals or
        one that is walled off, or a room that is not closed; for a drawing that is empty or too big, and a bad `cell`.

    Examples
    --------
    >>> room = Drawing("""
    ...     ########
    ...     #>    G#
    ...     ########
    ... """, cell=0.6)
    >>> room.bounds
    (-1.8, -0.3, 1.8, 0.3)
    '''

    text: str
    cell: float = 0.6  # in which the mobile base can just turn round
    start: tuple[float, float, float] = field(init=False, repr=False, compare=False)
    goal: tuple[float, float, float] | None = field(init=False, repr=False, compare=False)
    walls: tuple[Box, ...] = field(init=False, repr=False, compare=False)
    bounds: Box = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        if not isinstance(self.text, str):
            raise ValueError(f"a drawing is a text of lines, got {self.text!r:.200}")
        if not (isinstance(self.cell, Real) and SMALLEST <= self.cell <= LARGEST):
            expected = f"a number of metres, at least {SMALLEST:g} and at most {LARGEST:g}"
            raise ValueError(f"the cell of a drawing must be {expected}, got {self.cell!r:.200}")
        rows, cell = _rows(self.text), float(self.cell)
        start, goal = _place(rows, "".join(HEADINGS), "start"), _place(rows, GOAL, "goal")
        if start is None:
            raise ValueError(f"the drawing has no start: put one of {' '.join(HEADINGS)} where the robot begins")
        reached = _reached(rows, start)
        if goal is not None and goal not in reached:
            raise ValueError(f"the goal, in {_words(*goal)}, is walled off from the start")
        (top, left), (bottom, right) = np.min([*reached], axis=0).tolist(), np.max([*reached], axis=0).tolist()

        def point(line: float, column: float) -> tuple[float, float]:
            return (column - len(rows[0]) / 2) * cell, (len(rows) / 2 - line) * cell

        def middle(place: Place) -> tuple[float, float]:
            return point(place[0] + 0.5, place[1] + 0.5)

        def box(top: int, left: int, bottom: int, right: int) -> Box:
            return (*point(bottom, left), *point(top, right))

        # as they are from now on: the dataclass is frozen for everybody else
        vars(self).update(
            text="\n".join(rows),
            cell=cell,
            start=(*middle(start), HEADINGS[rows[start[0]][start[1]]]),
            goal=None if goal is None else (*middle(goal), cell / 2),
            walls=tuple(box(*wall) for wall in _walls(rows)),
            bounds=box(top, left, bottom + 1, right + 1),
        )

    def __str__(self) -> str:
        return f"{self.text}\n(each character {self.cell!r} m)"

    def check_start(self, length: float, width: float) -> None:
        """Raises ValueError if a robot of this length and width [m] would stand in a wall at its start."""
        x, y, theta = self.start
        half_x, half_y = (length / 2, width / 2) if theta in (0.0, math.pi) else (width / 2, length / 2)
        for x_min, y_min, x_max, y_max in self.walls:
            if x_min < x + half_x and x - half_x < x_max and y_min < y + half_y and y - half_y < y_max:
                raise ValueError(
                    f"the robot, {length:g} m long and {width:g} m wide, does not fit where it starts in the drawing; "
                    f"make its cells larger than {self.cell:g} m, or let it start farther from the walls"
                )


def _rows(text: str) -> list[str]:
    """The lines of a drawing, of equal length, in the characters that are kept. Raises ValueError if it is none."""
    first, *others = text.expandtabs().splitlines() or [""]
    if first[:1].strip():  # it follows the quotes, so it has not the indentation of the others
        others = textwrap.dedent("\n".join(others)).split("\n")
    rows = [line.translate(ALSO).rstrip(FREE) for line in (first, *others)]
    drawn = [i for i, row in enumerate(rows) if row]
    if not drawn:
        raise ValueError("the drawing is empty: draw walls around a free floor, on which the robot starts")
    rows = rows[drawn[0] : drawn[-1] + 1]
    margin = min(len(row) - len(row.lstrip(FREE)) for row in rows if row)
    width = max(map(len, rows)) - margin
    if len(rows) > MOST or width > MOST:
        raise ValueError(
            f"the drawing is too big: {len(rows)} lines of {width} characters, where {MOST} of {MOST} are allowed"
        )
    rows = [row[margin:].ljust(width, FREE) for row in rows]
    for i, row in enumerate(rows):
        if odd := re.search(f"[^{WALL}{FREE}{GOAL}{re.escape(''.join(HEADINGS))}]", row):
            known = f"# for a wall, . for free floor, {' '.join(HEADINGS)} for the start and {GOAL} for a goal"
            raise ValueError(f"the drawing has an unknown character in {_words(i, odd.start())}: {odd[0]!r}; {known}")
    return rows


def _words(line: int, column: int) -> str:
    """Where that is in the drawing, counted as people do."""
    return f"line {line + 1}, column {column + 1}"


def _place(rows: list[str], characters: str, what: str) -> Place | None:
    """The only place of one of these characters, if there is any. Raises ValueError if there are several."""
    places = [(i, j) for i, row in enumerate(rows) for j, character in enumerate(row) if character in characters]
    if len(places) > 1:
        raise ValueError(f"the drawing has a second {what} in {_words(*places[1])}; leave one of them")
    return places[0] if places else None


def _reached(rows: list[str], start: Place) -> set[Place]:
    """All places to which free floor leads. Raises ValueError if one is at the edge of the drawing."""
    reached, ahead = {start}, [start]
    while ahead:
        i, j = ahead.pop()
        if i in (0, len(rows) - 1) or j in (0, len(rows[0]) - 1):
            raise ValueError(f"the room is not closed: it can be left in {_words(i, j)} of the drawing; put a # there")
        near = {(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)}
        new = [(i, j) for i, j in near - reached if rows[i][j] != WALL]
        reached.update(new)
        ahead += new
    return reached


def _walls(rows: list[str]) -> list[tuple[int, int, int, int]]:
    """Few long walls that cover the wall cells: top, left, bottom and right of each.

    Runs along the lines and runs along the columns, where those that lie side by side and are equally long are one.
    They overlap at corners, so that no straight face of a wall has a seam.
    """
    columns = ["".join(column) for column in zip(*rows, strict=True)]
    boxes = {*_runs(rows), *((top, left, bottom, right) for left, top, right, bottom in _runs(columns))}
    grid = np.array(sorted(boxes)).reshape(-1, 1, 4)
    begins, ends = grid[..., :2], grid[..., 2:]
    inside = (begins >= begins[:, 0]).all(2) & (ends <= ends[:, 0]).all(2)  # the box of the row in that of the column
    kept: list[tuple[int, int, int, int]] = [tuple(box) for box in grid[inside.sum(1) == 1, 0].tolist()]
    return kept


def _runs(rows: list[str]) -> Iterator[tuple[int, int, int, int]]:
    """Walls along the rows: first row, first column, and those after the last."""
    open_: dict[tuple[int, int], int] = {}  # first row of the run between two columns
    for i, row in enumerate([*rows, ""]):
        spans = {run.span() for run in re.finditer(f"{WALL}+", row)}
        for left, right in open_.keys() - spans:
            yield open_.pop((left, right)), left, i, right
        for span in spans:
            open_.setdefault(span, i)
