"""The room of lesson 12 from above: what each place is worth, heading by heading, and ways through it."""

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.patches import Circle, Polygon, Rectangle, Wedge

from rlrobot_course.figures.plots import BLUE, GREEN, GREY, RED, ROLE, Picture, centred
from rlrobot_course.lesson_12.episodes import Episode
from rlrobot_edu.robots.arenas import Arena, arena_of
from rlrobot_edu.show.palette import BLACK, LIGHT
from rlrobot_edu.show.style import SHADES_OF_WORTH
from rlrobot_edu.task.task import Task

HEADINGS = (
    "east →",
    "north-east ↗",
    "north ↑",
    "north-west ↖",
    "west ←",
    "south-west ↙",
    "south ↓",
    "south-east ↘",
)
SECTOR = 360 / len(HEADINGS)
GAP = 4  # degrees of a petal that are left free
# The ways from the first to the last: colour, width, opacity
WAYS = ((GREY, 0.9, 0.9), (ROLE["path"], 2.4, 1.0), (BLUE, 4.0, 1.0))


def draw_room(ax: Axes, arena: Arena) -> None:
    """Floor, walls, goal and a scale of one metre; no axes."""
    x_min, y_min, x_max, y_max = arena.bounds
    width, height = x_max - x_min, y_max - y_min
    floor = Rectangle((x_min, y_min), width, height, color=LIGHT["floor"], zorder=0)
    ax.add_patch(floor)
    for wall in arena.walls:
        ax.add_patch(Polygon(wall.corners(), color=ROLE["wall"], zorder=4))
    if arena.goal:
        x, y, radius = arena.goal
        look = {"fill": False, "edgecolor": GREEN, "linestyle": "--", "linewidth": 2}
        ax.add_patch(Circle((x, y), radius, zorder=5, **look))
        left, top = x - 0.78 * radius, y + 0.72 * radius
        ax.text(left, top, "goal", color=GREEN, weight="bold", ha="right", zorder=7)
    y = y_min - 0.22
    ax.plot([x_min, x_min + 1], [y, y], color=LIGHT["faint"], linewidth=2)
    ax.text(x_min + 1.08, y, "1 m", va="center", color=LIGHT["faint"])
    edge = 0.12
    ax.set(xlim=(x_min - edge, x_max + edge), ylim=(y_min - 0.36, y_max + edge))
    ax.set_aspect("equal")
    ax.set_axis_off()


def place_values(task: Task, q: np.ndarray, visits: np.ndarray) -> np.ndarray:
    """The value of each place and heading: the largest Q among its visited states; array (x, y, theta), nan if none.

    q, visits: arrays (S, A); task: its first inputs are x, y and theta in eight sectors
    """
    v = np.where(visits.sum(axis=1) > 0, q.max(axis=1), -np.inf)
    best: np.ndarray = v.reshape(*task.states.shape[:3], -1).max(axis=-1)
    return np.where(np.isinf(best), np.nan, best)


def values_finding(values: np.ndarray) -> str:
    """What the best place and heading is worth, and how many are worth little. values: of `place_values`"""
    known = values[np.isfinite(values)]
    most = float(known.max())
    share = np.mean(known < most / 10)
    return f"The best place and heading is worth {most:.0f} points; {share:.0%} are worth less than {most / 10:.1f}"


def plot_values(
    task: Task, q: np.ndarray, visits: np.ndarray, way: np.ndarray
) -> Picture:
    """The arena with a rose in each field: a petal for each heading, the darker the more it is worth.

    way: array (n, 2), the places of a robot
    """
    values, arena = place_values(task, q, visits), arena_of(task.scene)
    figure = Picture(figsize=(6.8, 7.6))
    note = (
        "a petal: what it is worth to stand in this field and look that way; none: never met; "
        "the darker the more; in the middle the largest; line: the way of the last episode"
    )
    figure.headline(values_finding(values), note)
    ax = figure.subplots()
    draw_room(ax, arena)
    shades = ScalarMappable(Normalize(0, float(np.nanmax(values))), SHADES_OF_WORTH)
    edges = [
        [low, *(variable.cuts or ()), high]
        for variable, low, high in zip(
            task.inputs[:2], arena.bounds[:2], arena.bounds[2:], strict=True
        )
    ]
    for (i, j), petals in zip(np.ndindex(values.shape[:2]), values.reshape(-1, 8), strict=True):  # fmt: skip
        x, y = (edges[0][i] + edges[0][i + 1]) / 2, (edges[1][j] + edges[1][j + 1]) / 2
        _draw_rose(ax, x, y, petals, shades)
    for x in edges[0][1:-1]:
        ax.plot([x, x], arena.bounds[1::2], color=LIGHT["paper"], zorder=1)
    for y in edges[1][1:-1]:
        ax.plot(arena.bounds[::2], [y, y], color=LIGHT["paper"], zorder=1)
    ax.plot(*way.T, color=RED, linewidth=2, zorder=6)
    ax.plot(*way[0], "o", color=RED, markersize=7, zorder=7)
    x, y = way[0]
    look = {"color": RED, "weight": "bold", "zorder": 7}
    ax.text(x, y - 0.14, "start", ha="center", va="top", **look)
    told = []
    for heading in range(values.shape[2]):
        known = values[:, :, heading]
        told.append(f"heading {HEADINGS[heading][:-2]}: {np.isfinite(known).sum()} of {known.size} "
                    f"places known, the best worth {np.nanmax(known, initial=0):.0f}")  # fmt: skip
    figure.alt = f"The arena with a rose in each field, its petals coloured by value. {'; '.join(told)}."
    return figure


def _draw_rose(
    ax: Axes, x: float, y: float, petals: np.ndarray, shades: ScalarMappable
) -> None:
    """The values of one field, array (8,), as petals in their directions; the largest as a number in the middle."""
    for heading, value in enumerate(petals):
        if math.isnan(value):
            continue
        middle = SECTOR * heading
        ends = (middle - SECTOR / 2 + GAP / 2, middle + SECTOR / 2 - GAP / 2)
        colour = shades.to_rgba(max(value, 0.0))
        petal = Wedge((x, y), 0.46, *ends, width=0.31, color=colour, linewidth=0)
        ax.add_patch(petal)
        petal.set_zorder(2)
    if np.isfinite(petals).any():
        text = f"{np.nanmax(petals):z.0f}".replace("-", "−")
        halo = {"facecolor": LIGHT["floor"], "edgecolor": "none", "boxstyle": "circle,pad=0.1"}  # fmt: skip
        centred(ax, x, y, text, color=BLACK, zorder=8, bbox=halo)


def ways_finding(episodes: Sequence[Episode], numbers: Sequence[int]) -> str:
    """How many steps the first and the last of these episodes took. numbers: counted from 1"""
    first, last = len(episodes[numbers[0] - 1]), len(episodes[numbers[-1] - 1])
    word = "From" if last < first else "Still no shorter: from"
    return f"{word} {first} steps in episode {numbers[0]} to {last} in episode {numbers[-1]}"


def plot_ways(
    task: Task, episodes: Sequence[Episode], numbers: Sequence[int]
) -> Picture:
    """The ways of three episodes in one room, the later the thicker. numbers: of the episodes, counted from 1"""
    figure = Picture(figsize=(6.2, 6.3))
    steps = [f"{number}: {len(episodes[number - 1])} steps" for number in numbers]
    note = f"the robot's way; thin, middle, thick: episodes {', '.join(steps)}"
    figure.headline(ways_finding(episodes, numbers), note)
    ax = figure.subplots()
    arena = arena_of(task.scene)
    draw_room(ax, arena)
    for number, (colour, width, alpha) in zip(numbers, WAYS, strict=False):
        path = episodes[number - 1].path
        look = {"color": colour, "linewidth": width, "alpha": alpha}
        ax.plot(*path.T, zorder=3 + number / 1000, solid_joinstyle="round", **look)
    start = episodes[numbers[0] - 1].path[0]
    ax.plot(*start, "s", color=BLACK, markersize=9, zorder=7)
    ax.text(start[0] - 0.12, start[1], "start", ha="right", va="center", weight="bold", zorder=7)  # fmt: skip
    told = "; ".join(
        f"episode {number} took {len(episodes[number - 1])} steps" for number in numbers
    )
    figure.alt = f"Ways of a robot through the arena from above: {told}."
    return figure
