"""An environment of square cells, such as Gymnasium's frozen lake, and where in it the agent is."""

from __future__ import annotations

import gymnasium
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.show.palette import BLUE, GREEN, GREY, PURPLE, VERMILION

_FILL = {"S": GREY, "G": GREEN, "H": VERMILION, "C": VERMILION}
_WORDS = {"S": "start", "G": "goal", "H": "hole", "C": "cliff"}


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
    if isinstance(shape, tuple) and len(shape) == 2 and np.prod(shape) == env.observation_space.n:
        letters = np.full(shape, " ")
        letters[getattr(grid, "_cliff", np.zeros(shape, dtype=bool))] = "C"
        if hasattr(grid, "start_state_index"):  # CliffWalking, whose goal is the last cell
            letters.flat[[grid.start_state_index, -1]] = ["S", "G"]
        return letters
    return None


class GridView:
    """Pictures of an agent in a grid of cells; state s is the cell in row s // columns."""

    heading = "The world"

    def __init__(self, letters: np.ndarray) -> None:
        self._letters = letters
        cells = []
        for (row, column), letter in np.ndenumerate(letters):
            fill = f' fill="{_FILL[letter]}" fill-opacity="0.45"' if letter in _FILL else ' fill="none"'
            s = row * letters.shape[1] + column
            label = letter if letter in _FILL else s
            cells.append(
                f'<rect x="{column}" y="{row}" width="1" height="1"{fill}><title>state {s} {_WORDS.get(letter, "")}'
                f'</title></rect><text x="{column + 0.06}" y="{row + 0.3}">{label}</text>'
            )
        self._background = "".join(cells)

    def look(self, s: int) -> int:
        """The agent's cell."""
        return s

    def html(self, looks: list[int]) -> str:
        """The grid, the agent and the way it came."""
        rows, columns = self._letters.shape
        centres = self._centres(looks)
        path = " ".join(f"{x},{y}" for x, y in centres.tolist())
        x, y = centres[-1]
        return (
            f'<svg class="cells" viewBox="-0.05 -0.05 {columns + 0.1} {rows + 0.1}" role="img" '
            f'aria-label="A grid of {rows} by {columns} cells, the agent in cell {looks[-1]}.">{self._background}'
            f'<polyline class="path" points="{path}"/><circle cx="{x}" cy="{y}" r="0.28" fill="{BLUE}"/></svg>'
        )

    def draw(self, ax: Axes, looks: list[int]) -> None:
        """The same on matplotlib axes."""
        rows, columns = self._letters.shape
        for (row, column), letter in np.ndenumerate(self._letters):
            colour = _FILL.get(letter, "white")
            ax.add_patch(Rectangle((column, row), 1, 1, facecolor=colour, alpha=0.45, edgecolor="black", linewidth=0.6))
            name = letter if letter in _FILL else str(row * columns + column)
            ax.text(column + 0.06, row + 0.08, name, ha="left", va="top", fontsize=7)
        centres = self._centres(looks)
        ax.plot(*centres.T, color=PURPLE, linewidth=1.8)
        ax.plot(*centres[-1], "o", color=BLUE, markersize=9)
        ax.set(xlim=(-0.05, columns + 0.05), ylim=(rows + 0.05, -0.05), aspect="equal")
        ax.set_axis_off()

    def _centres(self, looks: list[int]) -> np.ndarray:
        row, column = np.divmod(np.array(looks), self._letters.shape[1])
        return np.column_stack([column, row]) + 0.5
