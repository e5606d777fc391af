"""A world of your own for a robot on wheels: a room that can be the scene of a task."""

from dataclasses import dataclass
from math import cos, isfinite, sin

Box = tuple[float, float, float, float]  # its least x and y, and its largest


@dataclass(frozen=True)
class Room:
    """A room seen from above: its walls, and where the robot starts. `tools.drawing` makes one of characters.

    Parameters
    ----------
    walls : tuple of tuple of float
        x_min, y_min, x_max, y_max of each wall [m]. They may overlap.
    bounds : tuple of float
        x_min, y_min, x_max, y_max of the floor [m].
    start : tuple of float
        x, y and theta of the robot at the beginning [m, m, rad].
    goal : tuple of float, optional
        x, y and radius of the goal [m]; the reward or the goal of a task may ask how far it is.

    Raises
    ------
    ValueError
        If a number is not finite, or a wall has no extent.
    """

    walls: tuple[Box, ...]
    bounds: Box
    start: tuple[float, float, float]
    goal: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        for x_min, y_min, x_max, y_max in (*self.walls, self.bounds):
            box = (x_min, y_min, x_max, y_max)
            is_finite = all(map(isfinite, box))
            if not is_finite or x_min >= x_max or y_min >= y_max:
                raise ValueError(
                    "each wall of a room is x_min, y_min, x_max, y_max in finite metres, and so are its bounds; "
                    f"got {box}"
                )
        for place in filter(None, (self.start, self.goal)):
            if len(place) != 3 or not all(map(isfinite, place)):
                raise ValueError(
                    f"start is x, y, theta and goal is x, y, radius in finite numbers; got {place}"
                )

    def __str__(self) -> str:
        x_min, y_min, x_max, y_max = self.bounds
        floor = f"x = {x_min:g} to {x_max:g} m, y = {y_min:g} to {y_max:g} m"
        return f"a room with {len(self.walls)} walls, {floor}"

    def check_start(self, length: float, width: float) -> None:
        """Check that a robot fits where it starts.

        Parameters
        ----------
        length, width : float [m]
            Its size; it looks along one of the axes.

        Raises
        ------
        ValueError
            If it would stand in a wall.
        """
        x, y, theta = self.start
        along_x = abs(sin(theta)) < abs(cos(theta))
        dx, dy = (length / 2, width / 2) if along_x else (width / 2, length / 2)
        for x_min, y_min, x_max, y_max in self.walls:
            if x_min < x + dx and x - dx < x_max and y_min < y + dy and y - dy < y_max:
                raise ValueError(
                    f"the robot, {length:g} m long and {width:g} m wide, does not fit where it starts, at "
                    f"x = {x:g} m, y = {y:g} m; let it start farther from the walls, or make the room larger"
                )
