"""The figures of lesson 02: how values spread from a goal through a grid, and the ways that follow from them."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke

from rlrobot_course.plots import GREY, Picture

ARROWS = {0: (-1, 0), 1: (0, 1), 2: (1, 0), 3: (0, -1)}  # FrozenLake's actions: (columns to the right, rows down)


def plot_sweeps(values: Mapping[int, np.ndarray], desc: np.ndarray) -> Picture:
    """Small multiples of the values of a grid world, one panel a sweep.

    values: number of the sweep -> array (n_states,), the value of each state after it, states row by row, at most 1
    desc: array (rows, columns) of bytes, FrozenLake's map: S start, F free, H hole, G goal
    """
    columns = min(3, len(values))
    rows = -(-len(values) // columns)
    figure = Picture(figsize=(3.1 * columns, 3.2 * rows + 0.4))
    panels = np.ravel(figure.subplots(rows, columns, squeeze=False))
    for ax, (sweep, v) in zip(panels, values.items(), strict=False):
        draw_values(ax, v, desc)
        ax.set_title(f"after sweep {sweep}", fontsize=11)
    for ax in panels[len(values) :]:
        ax.set_axis_off()
    figure.colorbar(panels[0].images[0], ax=panels.tolist(), label="value V(s)", shrink=0.7)
    known = ", ".join(f"{np.count_nonzero(v)} after sweep {sweep}" for sweep, v in values.items())
    figure.suptitle("Each sweep carries the value one step further from the goal")
    figure.alt = (
        f"Maps of a world of {desc.shape[0]} by {desc.shape[1]} squares, coloured by value. The values spread from the "
        f"goal in the lower right corner and fade with distance. States with a value other than 0: {known}."
    )
    return figure


def plot_ways(q: np.ndarray, desc: np.ndarray) -> Picture:
    """Map of a grid world with an arrow for every best action; where two are equally good, both are drawn.

    q: array (n_states, 4), FrozenLake's actions left, down, right, up; desc: see `plot_sweeps`
    """
    figure = Picture(figsize=(5, 4.6))
    ax = figure.subplots()
    draw_values(ax, q.max(axis=1), desc, numbers=False)
    best = {s: np.flatnonzero(np.isclose(q[s], q[s].max())) for s in np.flatnonzero(np.isin(desc, [b"S", b"F"]))}
    for s, actions in best.items():
        y, x = divmod(s, desc.shape[1])
        for a in actions:
            right, down = ARROWS[int(a)]
            arrow = {"arrowstyle": "-|>", "color": "white", "linewidth": 2, "shrinkA": 0, "shrinkB": 0}
            drawn = ax.annotate("", (x + 0.45 * right, y + 0.45 * down), (x, y), arrowprops=arrow)
            drawn.arrow_patch.set_path_effects([withStroke(linewidth=4, foreground="black")])
    figure.colorbar(ax.images[0], ax=ax, label="Q(s, a) of the best action")
    ax.set_title("The best actions lead uphill in value")
    several = sum(len(actions) > 1 for actions in best.values())
    figure.alt = (
        f"The same map with an arrow for every best action. {several} of {len(best)} squares have more than one; holes "
        "are hatched, and the goal is in the lower right corner."
    )
    return figure


def draw_values(ax: Axes, v: np.ndarray, desc: np.ndarray, numbers: bool = True) -> None:
    """Draw the values `v`, array (n_states,), as colours on the map `desc`, and as numbers where they are not 0."""
    grid = v.reshape(desc.shape)
    ax.imshow(grid, cmap="cividis", vmin=0, vmax=1)
    ax.set(xticks=[], yticks=[])
    for (y, x), square in np.ndenumerate(desc):
        if square == b"H":
            hole = Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=GREY, edgecolor="white", hatch="////", linewidth=0)
            ax.add_patch(hole)
        elif square in (b"S", b"G") and not grid[y, x]:
            ax.text(x, y, square.decode(), ha="center", va="center", color="white", fontsize=11, weight="bold")
        elif numbers and grid[y, x]:
            colour = "black" if grid[y, x] > 0.55 else "white"
            ax.text(x, y, f"{grid[y, x]:.2f}".lstrip("0"), ha="center", va="center", color=colour, fontsize=8.5)
