"""A world of square cells, such as Gymnasium's frozen lake: where the agent is, and what it thinks of each cell."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon, Rectangle

from rlrobot_edu.show.palette import BLUE, GREEN, GREY, PURPLE
from rlrobot_edu.widgets.stepper.colours import largest, tint
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import short
from rlrobot_edu.widgets.stepper.tape import Tape

_FILL = {"G": GREEN, "H": GREY, "C": GREY}
_WORDS = {"S": "start", "G": "goal", "H": "hole", "C": "cliff"}
_AHEAD = {"↑": (0, -1), "→": (1, 0), "↓": (0, 1), "←": (-1, 0)}
WIDE = 8  # columns; with more of them a cell has less room


def letters_of(env: gymnasium.Env) -> np.ndarray | None:
    """One letter for each cell, array (rows, columns), if the states of `env` are the cells of a grid, else None.

    S start, G goal, H hole, C cliff, anything else: free.
    """
    grid = env.unwrapped
    if not isinstance(env.observation_space, gymnasium.spaces.Discrete):
        return None
    desc, shape = getattr(grid, "desc", None), getattr(grid, "shape", None)
    if isinstance(desc, np.ndarray) and desc.size == env.observation_space.n:
        return desc.astype(str)
    if (
        isinstance(shape, tuple)
        and len(shape) == 2
        and np.prod(shape) == env.observation_space.n
    ):
        letters = np.full(shape, " ")
        letters[getattr(grid, "_cliff", np.zeros(shape, dtype=bool))] = "C"
        if hasattr(
            grid, "start_state_index"
        ):  # CliffWalking, whose goal is the last cell
            letters.flat[[grid.start_state_index, -1]] = ["S", "G"]
        return letters
    return None


class GridView:
    """Pictures of an agent in a grid of cells; state s is the cell in row s // columns.

    A cell that was visited says the value of its best action, and triangles say which that is.
    """

    def __init__(self, letters: np.ndarray, names: Names) -> None:
        self._letters, self._names, self.wide = letters, names, letters.shape[1] > WIDE
        self.heading = "The world: value of each cell" + (
            ", ▴ its best action" if names.arrows else ""
        )

    def look(self, s: int) -> int:
        """The agent's cell."""
        return s

    def constant_data(self) -> dict[str, Any]:
        """The letters of the cells, row by row."""
        return {
            "kind": "grid",
            "letters": "".join(self._letters.ravel()),
            "shape": self._letters.shape,
        }

    def look_data(self, look: int) -> None:
        """Nothing: the cell is the state."""

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The grid, the agent and the way it came, on matplotlib axes."""
        looks, (rows, columns) = tape.looks(), self._letters.shape
        most, size = (
            largest(tape.q, tape.agent.parameters.r_max),
            8.5 if not self.wide else 8,
        )
        for (row, column), letter in np.ndenumerate(self._letters):
            s = row * columns + column
            value, best = self._best(tape, s)
            colour, opacity = (
                (_FILL[letter], 0.45) if letter in _FILL else tint(value or 0.0, most)
            )
            ax.add_patch(
                Rectangle((column, row), 1, 1, facecolor=colour, alpha=opacity)
            )
            ax.add_patch(
                Rectangle(
                    (column, row), 1, 1, fill=False, edgecolor="black", linewidth=0.6
                )
            )
            name = f"{s} {letter if letter in _WORDS else ''}"
            ax.text(
                column + 0.05,
                row + 0.05,
                name,
                ha="left",
                va="top",
                fontsize=size - 1.5,
                color="#444",
            )
            if value is not None:
                ax.text(
                    column + 0.5,
                    row + 0.72,
                    short(value),
                    ha="center",
                    va="center",
                    fontsize=size,
                )
            for step in self._steps(best):
                ax.add_patch(
                    Polygon(_triangle(row, column, *step), color="black", linewidth=0)
                )
        centres = self._centres(looks)
        ax.plot(*centres.T, color=PURPLE, linewidth=1.2, zorder=0.5)
        ax.add_patch(
            Circle(
                centres[-1] - [0, 0.1], 0.22, fill=False, edgecolor=BLUE, linewidth=2.5
            )
        )
        ax.set(xlim=(-0.05, columns + 0.05), ylim=(rows + 0.05, -0.05), aspect="equal")
        ax.set_axis_off()

    def _best(self, tape: Tape, s: int) -> tuple[float | None, list[int]]:
        """Value of state `s` and all actions that are worth it; None and no actions where the agent never acted."""
        if not tape.visits[s].any():
            return None, []
        value = tape.q[s].max()
        return float(value), np.flatnonzero(tape.q[s] == value).tolist()

    def _steps(self, actions: list[int]) -> list[tuple[int, int]]:
        return (
            [_AHEAD[self._names.arrows[a]] for a in actions]
            if self._names.arrows
            else []
        )

    def _centres(self, looks: list[int]) -> np.ndarray:
        row, column = np.divmod(np.array(looks), self._letters.shape[1])
        return np.column_stack([column, row]) + 0.5


def _triangle(row: int, column: int, dx: int, dy: int) -> np.ndarray:
    """Corners of a triangle in a cell that points over its edge; array (3, 2)."""
    tip, side = np.array([dx, dy]), np.array([-dy, dx])
    return np.array([column + 0.5, row + 0.5]) + [
        0.48 * tip,
        0.37 * tip + 0.11 * side,
        0.37 * tip - 0.11 * side,
    ]
