"""The figure of lesson 00: the laser beams that count, among all that the robot has."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patheffects import withStroke

from rlrobot_course.figures.plots import GREY, ORANGE, Picture, centred, plain
from rlrobot_edu import InputVariable, plot_scene
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.top_down import footprint

ASIDE = 0.38  # of a reading from its beam [m]
ALONG = (0.45, 0.55, 0.65, 0.75)  # where on its beam a reading may stand


def plot_lasers(
    scene: Scene, readings: Mapping[str, float], inputs: Sequence[InputVariable]
) -> Picture:
    """Picture of a robot and its beams, those of `inputs` drawn thick, with their names and readings.

    readings: by the sensors' names, the lasers in the order of the scene's beams
    """
    names = [name for name in readings if name.startswith("laser")]
    counted = [variable.name for variable in inputs]
    figure = Picture(figsize=(6.2, 6.8))
    nearest = min(counted, key=lambda name: readings[name])
    figure.headline(
        f"{len(counted)} of {len(names)} lasers count; the nearest wall they see "
        f"is {readings[nearest]:.2f} m away ({short_name(nearest)})",
        "thick: beams that make up the state, with what they measure; dotted: the others",
    )
    ax = figure.subplots()
    plot_scene(scene, ax)
    ax.set_title("")
    counts = [name in counted for name in names]
    beams = next(
        thing
        for thing in ax.collections
        if isinstance(thing, LineCollection) and thing.get_label() == "laser"
    )
    beams.set(
        colors=[ORANGE if count else GREY for count in counts],
        linewidths=[3 if count else 1 for count in counts],
        linestyles=["-" if count else ":" for count in counts],
    )
    lines = dict(zip(names, scene.beams[:, :, :2], strict=True))
    for name in counted:
        others = [line for other, line in lines.items() if other != name]
        at = free_place(lines[name], [*others, *walls_of(scene)])
        _write(ax, at, f"{short_name(name)}\n{readings[name]:.2f} m")
    told = ", ".join(f"{name} {readings[name]:.2f} m" for name in counted)
    figure.alt = f"The robot in its maze with {len(names)} laser beams. {len(counted)} of them are thick: {told}."
    return figure


def short_name(laser: str) -> str:
    """The name of a laser in words, such as ``front left``."""
    return laser.removeprefix("laser_").replace("_", " ")


def walls_of(scene: Scene) -> list[np.ndarray]:
    """The outline of each wall, arrays (n, 2) [m], closed."""
    outlines = []
    for solid in scene.solids:
        if solid.role == "wall":
            corners = footprint(solid)
            outlines.append(np.vstack([corners, corners[:1]]))
    return outlines


def free_place(beam: np.ndarray, obstacles: Sequence[np.ndarray]) -> np.ndarray:
    """A place beside a beam, array (2, 2) [m], that is as far as possible from obstacles, arrays (n, 2) [m]."""
    start, end = beam
    along = (end - start) / np.linalg.norm(end - start)
    across = np.array([-along[1], along[0]])
    points = np.vstack([_points_on(line) for line in obstacles])
    places = [
        start + share * (end - start) + side * ASIDE * across
        for share in ALONG
        for side in (-1, 1)
    ]
    rooms = [np.linalg.norm(points - place, axis=1).min() for place in places]
    return places[int(np.argmax(rooms))]


def _points_on(line: np.ndarray) -> np.ndarray:
    """Points on a line of straight pieces, close to each other; array (m, 2) [m]."""
    shares = np.linspace(0, 1, 30)[:, None]
    pieces = [a + shares * (b - a) for a, b in pairwise(line)]
    return np.vstack(pieces)


def _write(ax: Axes, at: np.ndarray, text: str) -> None:
    """A text on the floor, with a border in the floor's colour."""
    x, y = at
    border = withStroke(linewidth=3, foreground=LIGHT["floor"])
    look = {"weight": "bold", "linespacing": 1.05, "zorder": 9}
    centred(ax, x, y, plain(text), path_effects=[border], **look)
