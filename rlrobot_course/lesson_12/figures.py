"""The figures of lesson 12: episodes as ways, values as maps, what to do in a corridor, and a robot in its lane."""

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.patches import Circle, Polygon, Rectangle

from rlrobot_course.figures.paths import plot_paths
from rlrobot_course.figures.plots import (
    GREEN,
    GREY,
    RED,
    ROLE,
    Picture,
    centred,
    plain,
)
from rlrobot_course.lesson_12.episodes import Episode
from rlrobot_course.lesson_12.worlds import NEARER, lane_scene
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.arenas import arena_of
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import robot_of
from rlrobot_edu.show.display import Displayed
from rlrobot_edu.show.in3d.visualizer import show_scene
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


def place_values(task: Task, q: np.ndarray, visits: np.ndarray) -> np.ndarray:
    """The value of each place and heading: the largest Q among its visited states; array (x, y, theta), nan if none.

    q, visits: arrays (S, A); task: its first inputs are x, y and theta in eight sectors
    """
    v = np.where(visits.sum(axis=1) > 0, q.max(axis=1), -np.inf)
    best: np.ndarray = v.reshape(*task.states.shape[:3], -1).max(axis=-1)
    return np.where(np.isinf(best), np.nan, best)


def plot_values(
    task: Task, q: np.ndarray, visits: np.ndarray, way: np.ndarray, title: str
) -> Picture:
    """Maps of the arena, one for each heading: the value of each place as a colour and a number, hatched if unknown.

    way: array (n, 2), places of a robot that drives forward; each step is drawn into the map of its direction, and
        each piece of two steps or more in one direction has its number at its end
    """
    values, arena = place_values(task, q, visits), arena_of(task.scene)
    shades, cividis = (
        Normalize(min(0.0, float(np.nanmin(values))), float(np.nanmax(values))),
        "cividis",
    )
    edges = [[low, *(variable.cuts or ()), high] for variable, low, high in
             zip(task.inputs[:2], arena.bounds[:2], arena.bounds[2:], strict=True)]  # fmt: skip
    figure, mappable = Picture(figsize=(9.2, 5.4)), ScalarMappable(shades, cividis)
    axes = figure.subplots(2, 4, sharex=True, sharey=True).flat
    moves = np.diff(way, axis=0)
    sectors = np.round(np.arctan2(moves[:, 1], moves[:, 0]) / (math.pi / 4)) % 8
    driven = np.flatnonzero(np.hypot(*moves.T) > 0.03)  # the others turn
    pieces = [
        p
        for p in np.split(driven, np.flatnonzero(np.diff(sectors[driven])) + 1)
        if len(p) > 1
    ]
    for heading, ax in enumerate(axes):
        for (i, j), value in np.ndenumerate(values[:, :, heading]):
            corner, (x, y) = (
                (edges[0][i], edges[1][j]),
                (edges[0][i + 1], edges[1][j + 1]),
            )
            unknown = math.isnan(value)
            look = (
                {"facecolor": "white", "hatch": "///"}
                if unknown
                else {"facecolor": mappable.to_rgba(value)}
            )
            ax.add_patch(
                Rectangle(
                    corner,
                    x - corner[0],
                    y - corner[1],
                    linewidth=0.5,
                    edgecolor=GREY,
                    **look,
                )
            )
            if not unknown:
                ink = "white" if shades(value) < 0.5 else "black"
                centred(
                    ax,
                    (corner[0] + x) / 2,
                    (corner[1] + y) / 2,
                    f"{value:z.0f}".replace("-", "−"),
                    color=ink,
                    fontsize=9.5,
                )
        for wall in arena.walls:
            ax.add_patch(Polygon(wall.corners(), color="black", zorder=4))
        for k in driven[sectors[driven] == heading]:
            ax.plot(*way[k : k + 2].T, color=RED, linewidth=3, alpha=0.8)
        for number, piece in enumerate(pieces, start=1):
            if sectors[piece[0]] == heading:
                ax.annotate(str(number), way[piece[-1] + 1], (3, 3), textcoords="offset points", fontsize=8.5, zorder=6,
                            weight="bold", bbox={"facecolor": "white", "edgecolor": RED, "pad": 1})  # fmt: skip
        if arena.goal:
            x, y, radius = arena.goal
            ax.add_patch(
                Circle(
                    (x, y),
                    radius,
                    fill=False,
                    edgecolor=ROLE["goal"],
                    linewidth=2.2,
                    zorder=5,
                )
            )
        ax.set(xlim=arena.bounds[::2], ylim=arena.bounds[1::2], aspect="equal")
        ax.set_title(f"heading {HEADINGS[heading]}", fontsize=10.5)
    figure.supxlabel("x (m)")
    figure.supylabel("y (m)")
    figure.colorbar(mappable, ax=figure.axes, label="value V (reward)", shrink=0.8)
    figure.headline(title)
    told = []
    for heading in range(values.shape[2]):
        known = values[:, :, heading]
        told.append(f"heading {HEADINGS[heading][:-2]}: {np.isfinite(known).sum()} of {known.size} "
                    f"places known, the best worth {np.nanmax(known, initial=0):.0f}")  # fmt: skip
    figure.alt = (
        f"Maps of the arena, one a heading, coloured by value. {'; '.join(told)}."
    )
    return figure


def plot_ways(
    scene: Scene, episodes: Sequence[Episode], numbers: Sequence[int], title: str
) -> Picture:
    """The way of some episodes, each in a room of its own. numbers: of the episodes, counted from 1"""
    figure = Picture(figsize=(3.4 * len(numbers), 3.9))
    for number, ax in zip(
        numbers, figure.subplots(1, len(numbers), squeeze=False)[0], strict=True
    ):
        episode = episodes[number - 1]
        plot_paths(
            scene, {"way": episode.path}, f"episode {number}: {len(episode)} steps", ax
        )
        ax.get_legend().remove()
    figure.headline(title)
    told = "; ".join(
        f"episode {number} took {len(episodes[number - 1])} steps" for number in numbers
    )
    figure.alt = f"Ways of a robot through the arena from above: {told}."
    return figure


def plot_corridor(tables: Mapping[str, np.ndarray], title: str) -> Picture:
    """What to do in each cell of a corridor, and what it is worth. tables: label -> Q, array (cells + 1, 2)"""
    n = len(next(iter(tables.values()))) - 1
    figure, told = Picture(figsize=(7.2, 0.9 + 1.25 * len(tables))), []
    for (label, q), ax in zip(
        tables.items(),
        figure.subplots(len(tables), 1, squeeze=False)[:, 0],
        strict=True,
    ):
        for cell in range(n):
            ax.add_patch(Rectangle((cell, 0), 1, 1, facecolor="white", edgecolor=GREY))
            nearer = q[cell].argmax() == NEARER
            tail, head = ((0.2, 0.8), (0.8, 0.2))[not nearer]
            look = {
                "arrowstyle": "-|>",
                "linewidth": 2.4,
                "color": GREEN if nearer else RED,
            }
            ax.annotate("", (cell + head, 0.68), (cell + tail, 0.68), arrowprops=look)
            centred(
                ax,
                cell + 0.5,
                0.26,
                f"{q[cell].max():.1f}".replace("-", "−"),
                fontsize=10,
            )
        ax.add_patch(
            Rectangle(
                (n, 0),
                1,
                1,
                facecolor=ROLE["goal"],
                alpha=0.35,
                hatch="//",
                edgecolor=GREY,
            )
        )
        centred(ax, n + 0.5, 0.5, "goal", fontsize=10)
        ax.set(xlim=(0, n + 1), ylim=(0, 1), xticks=[], yticks=[], aspect="equal")
        ax.set_title(plain(label), fontsize=10, loc="left")
        ways = ["nearer" if q[cell].argmax() == NEARER else "away" for cell in range(n)]
        told.append(f"{label}: {', '.join(ways)}")
    figure.headline(title)
    figure.alt = f"A corridor of {n} cells before a goal, with the best action in each cell. {'; '.join(told)}."
    return figure


def film_in_lane(q: np.ndarray, env: Env, steps: int) -> tuple[Displayed, list[float]]:
    """The robot in its lane with the best action of a table, array (S, A), up to its goal or for so many steps.

    Returns the film and the rewards of its steps.
    """
    s, scenes, rewards, terminated = env.reset()[1]["state"], [], [], False
    while len(scenes) < steps and not terminated:
        _, reward, terminated, _, info = env.step(int(q[s].argmax()))
        s = info["state"]
        scenes.append(lane_scene(robot_of(env).scene()))
        rewards.append(float(reward))
    return show_scene(scenes, rewards), rewards
