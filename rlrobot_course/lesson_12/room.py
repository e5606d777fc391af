"""The room of lesson 12 from above, and ways through it."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon, Rectangle

from rlrobot_course.figures.plots import BLUE, GREEN, GREY, ROLE, Picture
from rlrobot_course.lesson_12.episodes import Episode
from rlrobot_edu.robots.arenas import Arena, arena_of
from rlrobot_edu.show.palette import BLACK, LIGHT
from rlrobot_edu.task.task import Task

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
