"""Several ways through one room, seen from above."""

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    CURVES,
    Picture,
    axes_or_new,
    legend_below,
    plain,
)
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import robot_of
from rlrobot_edu.show.picture import set_title
from rlrobot_edu.show.top_down import TopDown


def drive(env: Env, actions: Sequence[int]) -> np.ndarray:
    """The positions of a robot that does these actions from its start; array (n + 1, 2) [m], the start first."""
    env.reset()
    places = [robot_of(env).readings]
    for a in actions:
        env.step(a)
        places.append(robot_of(env).readings)
    return np.array([(place["x"], place["y"]) for place in places])


def length_of(path: np.ndarray) -> float:
    """Length of a path, array (n, 2) [m]."""
    return sum(math.dist(a, b) for a, b in pairwise(path))


def plot_paths(
    scene: Scene, paths: Mapping[str, np.ndarray], title: str, ax: Axes | None = None
) -> Picture | Axes:
    """The room of `scene` with a line for each path. paths: label -> array (n, 2) [m], in the order of time."""
    ends = "; ".join(
        f"{label}: {length_of(path):.1f} m in {len(path) - 1} steps"
        for label, path in paths.items()
    )
    ax, shown = axes_or_new(
        ax, f"Ways through the room from above. {ends}.", (5.2, 5.2)
    )
    view = TopDown(ax, scene)

    for name, patch in view.patches.items():
        patch.set_visible(not name.startswith("robot"))
    for artist in (view.beams, view.hits, view.heading):
        artist.set_visible(False)
    handles = ax.plot(
        *next(iter(paths.values()))[0],
        "s",
        color="black",
        markersize=7,
        zorder=7,
        label="start",
    )
    for (label, path), (colour, dashes) in zip(paths.items(), CURVES, strict=False):
        handles += ax.plot(
            *path.T,
            color=colour,
            linestyle=dashes,
            linewidth=2,
            zorder=6,
            label=plain(label),
        )
        ax.plot(
            *path[-1],
            "o",
            color=colour,
            markersize=7,
            markeredgecolor="white",
            zorder=7,
        )
    set_title(ax, shown, title)
    if shown is ax:
        ax.legend(handles=handles, loc="best")
    else:
        legend_below(shown, 3, handles=handles)
    return shown
