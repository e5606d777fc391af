"""The figures of lesson 17 on planning: what a robot in cells knows of its way, and what thinking saves."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.lesson_17.cells import GOAL, MOVES, SHAPE, START, WALLS, best_way, number
from rlrobot_course.plots import BLACK, CURVES, ROLE, Picture, chart, draw_curves, name_rows, plain


def draw_cells(ax: Axes, shades: np.ndarray | None = None, most: float = 1.0) -> None:
    """The cells, row 0 on top, with walls, start and goal. shades: array (rows, columns), nan or 0 to `most`."""
    rows, columns = SHAPE
    ax.set(xlim=(-0.5, columns - 0.5), ylim=(rows - 0.5, -0.5), aspect="equal", xticks=[], yticks=[])
    ax.set_xticks(np.arange(columns) - 0.5, minor=True)
    ax.set_yticks(np.arange(rows) - 0.5, minor=True)
    ax.grid(which="minor", alpha=0.4)
    ax.tick_params(which="both", length=0)
    if shades is not None:
        ax.imshow(np.ma.masked_invalid(shades), cmap="Blues", vmin=0, vmax=1.6 * most, zorder=0)
    for row, column in WALLS:
        ax.add_patch(Rectangle((column - 0.5, row - 0.5), 1, 1, facecolor=ROLE["wall"], hatch="xx", alpha=0.7))
    for (row, column), word in ((START, "start"), (GOAL, "goal")):
        ax.text(column, row + 0.36, word, ha="center", va="center", color=BLACK)


def plot_beliefs(tables: Mapping[str, np.ndarray]) -> Picture:
    """An arrow in every cell of which something is known: the best action there, the darker the more it is worth.

    tables: title of a panel -> Q, array (35, 4)
    """
    figure, told = Picture(figsize=(3.4 * len(tables), 3.1)), []
    for ax, (title, q) in zip(figure.subplots(1, len(tables), squeeze=False)[0], tables.items(), strict=True):
        values = q.max(axis=1).reshape(SHAPE)
        draw_cells(ax, np.where(values > 0, values, np.nan))
        for cell in np.argwhere(values > 0).tolist():
            down, right = MOVES[int(q[number((cell[0], cell[1]))].argmax())]
            ax.annotate(
                "", (cell[1] + 0.27 * right, cell[0] - 0.1 + 0.27 * down),
                (cell[1] - 0.27 * right, cell[0] - 0.1 - 0.27 * down),
                arrowprops={"arrowstyle": "-|>", "color": BLACK, "linewidth": 1.3, "shrinkA": 0, "shrinkB": 0},
            )  # fmt: skip
        way = best_way(q)
        leads = f"the way from the start takes {len(way) - 1}" if way[-1] == GOAL else "no way from the start yet"
        known = np.count_nonzero(values > 0)
        arrows = f"{known} cell{'s' * int(known != 1)} with an arrow"
        ax.set_title(plain(title))
        ax.set_xlabel(f"{arrows}\n{leads}")
        told.append(f"{title}: {arrows}, {leads}")
    figure.alt = f"Grids of {SHAPE[0]} by {SHAPE[1]} cells with walls. {'; '.join(told)}."
    return figure


def plot_arrivals(ended: Mapping[str, Sequence[bool]]) -> Picture:
    """How often the goal has been reached, over the real steps; one curve a learner.

    ended: label -> whether each step reached the goal
    """
    title = "From the start to the goal, again and again"
    figure, ax = chart((6.5, 3.8), "real step", "arrivals at the goal so far", title)
    arrivals = {label: np.cumsum(at_goal) for label, at_goal in ended.items()}
    draw_curves(ax, arrivals)
    figure.legend(loc="outside lower center", ncols=len(ended))
    told = [f"{name}: first in step {np.argmax(n > 0) + 1}, {n[-1]} in all" for name, n in arrivals.items()]
    steps = max(map(len, arrivals.values()))
    figure.alt = f"Arrivals at the goal over {steps} real steps. {'; '.join(told)}."
    return figure


def plot_real_steps(needed: Mapping[str, Sequence[int]], title: str) -> Picture:
    """Dots, one an agent: after how many real steps its way was the shortest; the middle one as a line."""
    size = (7.0, 1.6 + 0.55 * len(needed))
    figure, ax = chart(size, "real steps (logarithmic)", "", title, grid="x")
    for i, (values, (colour, _)) in enumerate(zip(needed.values(), CURVES, strict=False)):
        sorted_values = np.sort(values)
        height = i + 0.28 * np.sin(2.4 * np.arange(len(values)))  # apart, so that each is seen
        ax.plot(sorted_values, height, "o", color=colour, alpha=0.6, markersize=5)
        ax.plot([np.median(values)] * 2, [i - 0.42, i + 0.42], color=BLACK, linewidth=2)
    name_rows(ax, list(needed))
    ax.set_xscale("log")
    ax.grid(axis="x", which="minor", alpha=0.3)
    told = [f"{name}: {len(n)} agents, the middle one {np.median(n):.0f}" for name, n in needed.items()]
    figure.alt = f"Dots, one an agent: real steps until its way is the shortest. {'; '.join(told)}."
    return figure


def plot_order(firsts: Mapping[str, np.ndarray]) -> Picture:
    """In each cell the number of the thought that first taught the robot something there; 0 is the real step.

    firsts: title of a panel -> array (35,), -1 where nothing was learned
    """
    figure, told = Picture(figsize=(3.9 * len(firsts), 3.3)), []
    for ax, (title, first) in zip(figure.subplots(1, len(firsts), squeeze=False)[0], firsts.items(), strict=True):
        grid, last = first.reshape(SHAPE), max(int(first.max()), 1)
        draw_cells(ax, np.where(grid >= 0, 1 - 0.9 * grid / last, np.nan))
        for row, column in np.argwhere(grid >= 0).tolist():
            ax.text(column, row - 0.08, str(grid[row, column]), ha="center", va="center", color=BLACK)
        known = np.sort(first[first >= 0])
        told.append(f"{title}: {len(known)} cells have learned something, by thought {', '.join(map(str, known))}")
        ax.set_title(plain(title))
        ax.set_xlabel(f"{len(known)} cells have learned something")
    figure.alt = f"Grids of cells with the number of the thought that first taught something there. {'; '.join(told)}."
    return figure
