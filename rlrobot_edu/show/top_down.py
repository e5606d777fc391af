"""Scenes from above, on matplotlib's axes: walls, robot and heading, laser beams and the robot's path."""

import math
from typing import Any, overload

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon, Rectangle
from matplotlib.text import Text
from scipy.spatial import ConvexHull

from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import Scenes, as_scenes, describe, path_of
from rlrobot_edu.show.painting.parts import (
    BY_NAME,
    grid_cell,
    ground,
    has_walls,
)
from rlrobot_edu.show.palette import LIGHT, ROLE, WOOD
from rlrobot_edu.show.picture import Picture, axes_or_new, plain, set_title
from rlrobot_edu.show.style import SMALLEST

# The higher number lies on top. Beams and wheels are drawn over the body, which would hide them.
_LAYER = {
    "wall": 1,
    "goal": 2,
    "path": 3,
    "object": 4,
    "robot": 5,
    "beam": 6,
    "wheel": 7,
    "text": 8,
}
_TURN = np.linspace(0, 2 * math.pi, 32, endpoint=False)
_CIRCLE = np.array([(math.cos(angle), math.sin(angle)) for angle in _TURN])


def footprint(solid: Solid) -> np.ndarray:
    """Outline of a solid's shadow under a light straight above; array (n, 2) [m]."""
    centre = solid.pose[:2, 3]
    if solid.shape == "sphere":
        return centre + solid.size[0] * _CIRCLE
    *base, height = solid.size
    if solid.shape == "box":
        rim = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)]) * base / 2
    elif solid.shape == "prism":
        rim = np.reshape(base, (-1, 2))
    else:
        rim = base[0] * _CIRCLE
    bottom = np.column_stack([rim, np.full(len(rim), -height / 2)])
    top = np.column_stack([rim, np.full(len(rim), height / 2)])
    points = np.vstack([bottom, top])
    shadow = centre + points @ solid.pose[:2, :3].T
    return np.asarray(shadow[ConvexHull(shadow).vertices])


def nose(body: Solid) -> np.ndarray:
    """A line from the middle of a robot's body nearly to its front; array (2, 2) [m]."""
    centre = body.pose[:2, 3]
    ahead = body.pose[:2, 0]
    front = np.max((footprint(body) - centre) @ ahead)
    return np.array([centre, centre + 0.9 * front * ahead])


class TopDown:
    """The artists of one picture. Walls are drawn once; `update` moves the `moving` artists.

    ax: the axes to draw on; scene: what to draw first
    """

    def __init__(self, ax: Axes, scene: Scene) -> None:
        self._ax = ax
        _frame(ax, scene)
        self.beams = LineCollection([], linewidths=0.9, label="laser")
        self.beams.set(color=ROLE["beam"], zorder=_LAYER["beam"])
        ax.add_collection(self.beams, autolim=False)
        self.hits = self._marks("beam", marker=".", markersize=5)
        self.path = self._line("path", ROLE["path"], linewidth=1.8, label="path")
        self.start = self._marks("path", marker="s", markersize=6)
        self.heading = self._line("wheel", "w", linewidth=2.5, solid_capstyle="round")
        self.patches: dict[str, Polygon] = {}
        self.words: dict[str, Text] = {}
        for solid in scene.solids:
            patch = self._patch(solid)
            if solid.role != "wall":
                self.patches[solid.name] = patch
            if solid.role in ("goal", "object"):
                self.words[solid.name] = self._text("\n" + plain(solid.name), "top")
        self.words["start"] = self._text("", "bottom")
        self.moving: list[Artist] = [self.beams]
        self.moving += [self.hits, self.path, self.start, self.heading]
        self.moving += [*self.patches.values(), *self.words.values()]
        self.moving.sort(key=Artist.get_zorder)
        self.update(scene, path_of([scene]))

    def _line(self, layer: str, colour: str, **look: Any) -> Line2D:
        """A line without points yet."""
        (line,) = self._ax.plot([], [], color=colour, zorder=_LAYER[layer], **look)
        return line

    def _marks(self, role: str, **look: Any) -> Line2D:
        """Marks in the colour of this role, nowhere yet."""
        return self._line(role, ROLE[role], linestyle="", **look)

    def _patch(self, solid: Solid) -> Polygon:
        """The shadow of a solid."""
        outline = footprint(solid)
        colour = BY_NAME.get(solid.name, ROLE[solid.role])
        patch = Polygon(outline, color=colour, linewidth=0, label=solid.name)
        self._ax.add_patch(patch)
        patch.set_zorder(_LAYER[solid.role])
        if solid.role == "goal":
            patch.set(alpha=0.45, hatch="//")
        return patch

    def _text(self, text: str, side: str) -> Text:
        """A text in small letters, whose `side` is at the place that `update` gives it."""
        layer = _LAYER["text"]
        written = self._ax.text(0, 0, text, ha="center", va=side, fontsize=9)
        written.set(zorder=layer, clip_on=True)
        return written

    def update(self, scene: Scene, path: np.ndarray) -> None:
        """Move everything to its place in `scene`; path: array (n, 2 or 3) [m], the way to there."""
        # The mark of the start is left out while the robot stands on it.
        is_covered = len(path) < 2
        for solid in scene.solids:
            if solid.name in self.patches:
                self.patches[solid.name].set_xy(footprint(solid))
            if solid.name in self.words:
                self.words[solid.name].set(position=solid.pose[:2, 3])
            if solid.name == "robot/body":
                line = nose(solid)
                self.heading.set_data(line[:, 0], line[:, 1])
                centre, front = line
                if not is_covered:
                    distance = math.dist(centre, path[0, :2])
                    is_covered = distance < math.dist(centre, front)
        self.beams.set(segments=scene.beams[:, :, :2])
        self.hits.set_data(scene.beams[:, 1, 0], scene.beams[:, 1, 1])
        self.path.set_data(path[:, 0], path[:, 1])
        if is_covered:
            self.start.set_data([], [])
            self.words["start"].set_text("")
        else:
            x, y = path[0, :2]
            self.start.set_data([x], [y])
            self.words["start"].set(text="start\n", position=(x, y))


def _frame(ax: Axes, scene: Scene) -> None:
    """Put a floor in place of axes, and below it a bar as long as a square of the floor in 3D."""
    x_min, y_min, x_max, y_max = ground(scene)
    width = x_max - x_min
    height = y_max - y_min
    colour = LIGHT["floor"] if has_walls(scene) else WOOD
    floor = Rectangle((x_min, y_min), width, height, color=colour, linewidth=0)
    floor.set_zorder(0)
    ax.add_patch(floor)
    edge = 0.01 * width
    ax.set_axis_off()
    ax.set(
        xlim=(x_min - edge, x_max + edge),
        ylim=(y_min - 0.1 * height, y_max + edge),
        aspect="equal",
    )
    length = grid_cell(scene)
    said = f"{length:g} m" if length >= 1 else f"{100 * length:g} cm"
    y = y_min - 0.06 * height
    end = x_min + length
    ax.plot([x_min, end], [y, y], color=LIGHT["faint"], linewidth=2)
    written = ax.text(end + 2 * edge, y, said, va="center", color=LIGHT["faint"])
    written.set(
        fontsize=SMALLEST, clip_on=True
    )  # not where a part of the room is shown


@overload
def plot_scene(
    scenes: Scenes | Env, ax: None = None, title: str | None = None
) -> Picture: ...
@overload
def plot_scene(scenes: Scenes | Env, ax: Axes, title: str | None = None) -> Axes: ...
@suggests_keywords
def plot_scene(
    scenes: Scenes | Env, ax: Axes | None = None, title: str | None = None
) -> Picture | Axes:
    """Picture of a scene from above, with a bar of one metre.

    Parameters
    ----------
    scenes : Scene, sequence of Scene or gymnasium.Env
        One scene, or several in the order of time: the last is drawn in full, with the path through all. Of an
        environment with a robot, what can be seen there now.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; by default those of a new figure.
    title : str, optional
        The line above the picture.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        The new figure, or `ax` if it was given.

    Raises
    ------
    ValueError
        If there is no scene in `scenes`, or no robot in the environment.
    """
    way = as_scenes(scenes)
    last = way[-1]
    ax, drawn = axes_or_new(ax, describe(last), (4.5, 4.5))
    view = TopDown(ax, last)
    view.update(last, path_of(way))
    set_title(ax, drawn, title or "The robot's world from above")
    return drawn
