"""The figures of lesson 17 on planning: robots in cells walk, what they know of the way, and what thinking saves."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    CURVES,
    ROLE,
    Picture,
    centred,
    chart,
    draw_arrow,
    draw_lattice,
    film_of,
    in_panels,
    name_rows,
    plain,
)
from rlrobot_course.lesson_17.cells import (
    GOAL,
    MOVES,
    SHAPE,
    START,
    WALLS,
    best_way,
    number,
)
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.images import image_of


def draw_cells(ax: Axes, shades: np.ndarray | None = None) -> None:
    """The cells, row 0 on top, with walls, start and goal. shades: array (rows, columns), nan or 0 to 1."""
    draw_lattice(ax, SHAPE)
    ax.set(xticks=[], yticks=[])
    if shades is not None:
        ax.imshow(
            np.ma.masked_invalid(shades),
            cmap="Blues",
            vmin=0,
            vmax=1.6,
            zorder=0,
        )
    for row, column in WALLS:
        ax.add_patch(
            Rectangle(
                (column - 0.5, row - 0.5),
                1,
                1,
                facecolor=ROLE["wall"],
                hatch="xx",
                alpha=0.7,
            )
        )
    for (row, column), word in ((START, "start"), (GOAL, "goal")):
        centred(ax, column, row + 0.36, word, color=BLACK)


@dataclass(frozen=True, eq=False)
class Walks(Displayed):
    """Robots in cells, side by side, as a moving picture: a frame a step, with the way of the last ten.

    walks: title of a panel -> what happened, with its transitions kept; steps: how many are shown
    """

    walks: Mapping[str, History]
    steps: int

    def __repr__(self) -> str:
        told = (
            f"{name}: {walk.terminated[: self.steps].sum()} arrivals"
            for name, walk in self.walks.items()
        )
        return f"<Robots in cells, {self.steps} steps. {'; '.join(told)}>"

    def still(self) -> Still:
        """All steps, and the last one longer."""
        figure, shots = Picture((3.4 * len(self.walks), 3.1)), []
        panels = figure.subplots(1, len(self.walks), squeeze=False)[0]
        trails = [
            ax.plot([], [], "-", color=BLUE, linewidth=4, alpha=0.4)[0] for ax in panels
        ]
        robots = [ax.plot([], [], "o", color=BLUE, markersize=13)[0] for ax in panels]
        for ax in panels:
            draw_cells(ax)
        for k in range(1, self.steps + 1):
            for ax, trail, robot, (name, walk) in zip(
                panels, trails, robots, self.walks.items(), strict=True
            ):
                ends = walk.terminated[:k]
                begin = max([k - 10, 0, *(np.flatnonzero(ends[:-1]) + 1)])
                y, x = np.divmod([walk.s[begin], *walk.s_next[begin:k]], SHAPE[1])
                trail.set_data(x, y - 0.1)
                robot.set_data(x[-1:], y[-1:] - 0.1)
                ax.set_title(
                    plain(f"{name}\nstep {k}, arrivals: {ends.sum()}"), fontsize=10
                )
            shots.append(image_of(figure.png()))
        return film_of(repr(self), shots, 64, 200)


def plot_beliefs(tables: Mapping[str, np.ndarray]) -> Picture:
    """An arrow in every cell of which something is known: the best action there, the darker the more it is worth.

    tables: title of a panel -> Q, array (35, 4)
    """
    figure, told = Picture(figsize=(3.4 * len(tables), 3.1)), []
    for ax, title, q in in_panels(figure, tables):
        values = q.max(axis=1).reshape(SHAPE)
        draw_cells(ax, np.where(values > 0, values, np.nan))
        for cell in np.argwhere(values > 0).tolist():
            down, right = MOVES[int(q[number((cell[0], cell[1]))].argmax())]
            tail = (cell[1] - 0.27 * right, cell[0] - 0.1 - 0.27 * down)
            head = (cell[1] + 0.27 * right, cell[0] - 0.1 + 0.27 * down)
            draw_arrow(ax, tail, head, BLACK, 1.3)
        way = best_way(q)
        leads = (
            f"the way from the start takes {len(way) - 1}"
            if way[-1] == GOAL
            else "no way from the start yet"
        )
        known = np.count_nonzero(values > 0)
        arrows = f"{known} cell{'s' * int(known != 1)} with an arrow"
        ax.set_title(plain(title))
        ax.set_xlabel(f"{arrows}\n{leads}")
        told.append(f"{title}: {arrows}, {leads}")
    figure.alt = (
        f"Grids of {SHAPE[0]} by {SHAPE[1]} cells with walls. {'; '.join(told)}."
    )
    return figure


def plot_real_steps(needed: Mapping[str, Sequence[int]], title: str) -> Picture:
    """Dots, one an agent: after how many real steps its way was the shortest; the middle one as a line."""
    size = (7.0, 1.6 + 0.55 * len(needed))
    figure, ax = chart(size, "real steps (logarithmic)", "", title, grid="x")
    for i, (values, (colour, _)) in enumerate(
        zip(needed.values(), CURVES, strict=False)
    ):
        sorted_values = np.sort(values)
        height = i + 0.28 * np.sin(
            2.4 * np.arange(len(values))
        )  # apart, so that each is seen
        ax.plot(sorted_values, height, "o", color=colour, alpha=0.6, markersize=5)
        ax.plot([np.median(values)] * 2, [i - 0.42, i + 0.42], color=BLACK, linewidth=2)
    name_rows(ax, list(needed))
    ax.set_xscale("log")
    ax.grid(axis="x", which="minor", alpha=0.3)
    told = [
        f"{name}: {len(n)} agents, the middle one {np.median(n):.0f}"
        for name, n in needed.items()
    ]
    figure.alt = f"Dots, one an agent: real steps until its way is the shortest. {'; '.join(told)}."
    return figure


def plot_order(firsts: Mapping[str, np.ndarray]) -> Picture:
    """In each cell the number of the thought that first taught the robot something there; 0 is the real step.

    firsts: title of a panel -> array (35,), -1 where nothing was learned
    """
    figure, told = Picture(figsize=(3.9 * len(firsts), 3.3)), []
    for ax, title, first in in_panels(figure, firsts):
        grid, last = first.reshape(SHAPE), max(int(first.max()), 1)
        draw_cells(ax, np.where(grid >= 0, 1 - 0.9 * grid / last, np.nan))
        for row, column in np.argwhere(grid >= 0).tolist():
            centred(ax, column, row - 0.08, str(grid[row, column]), color=BLACK)
        known = np.sort(first[first >= 0])
        told.append(
            f"{title}: {len(known)} cells have learned something, by thought {', '.join(map(str, known))}"
        )
        ax.set_title(plain(title))
        ax.set_xlabel(f"{len(known)} cells have learned something")
    figure.alt = f"Grids of cells with the number of the thought that first taught something there. {'; '.join(told)}."
    return figure
