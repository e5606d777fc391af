"""Scenes seen from above: walls, robot and heading, laser beams and the way the robot came; and a camera for films."""

import math
from typing import Any, overload

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.patches import Polygon
from matplotlib.text import Text
from scipy.spatial import ConvexHull

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import Scenes, as_scenes, describe, path_of
from rlrobot_edu.show.palette import ROLE
from rlrobot_edu.show.picture import DPI, Picture, axes_or_new, plain

# what lies on top when seen from above; beams and wheels are drawn over the body that hides where they are
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
_CIRCLE = np.array(
    [
        (math.cos(t), math.sin(t))
        for t in np.linspace(0, 2 * math.pi, 32, endpoint=False)
    ]
)


def footprint(solid: Solid) -> np.ndarray:
    """Outline of a solid's shadow under a light straight above; array (n, 2) [m]."""
    centre = solid.pose[:2, 3]
    if solid.shape == "sphere":
        return centre + solid.size[0] * _CIRCLE
    *base, height = solid.size
    if solid.shape == "box":
        rim = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)]) * base / 2
    else:
        rim = np.reshape(base, (-1, 2)) if solid.shape == "prism" else base[0] * _CIRCLE
    points = np.vstack(
        [
            np.column_stack([rim, np.full(len(rim), z)])
            for z in (-height / 2, height / 2)
        ]
    )
    shadow = centre + points @ solid.pose[:2, :3].T
    return np.asarray(shadow[ConvexHull(shadow).vertices])


def nose(body: Solid) -> np.ndarray:
    """A line from the middle of a robot's body nearly to its front; array (2, 2) [m]."""
    centre, ahead = body.pose[:2, 3], body.pose[:2, 0]
    return np.array(
        [centre, centre + 0.9 * np.max((footprint(body) - centre) @ ahead) * ahead]
    )


class TopDown:
    """The artists of one picture: walls are drawn once, the `moving` artists follow `update`.

    ax: the axes to draw on; scene: what to draw first
    """

    def __init__(self, ax: Axes, scene: Scene) -> None:
        x_min, y_min, x_max, y_max = scene.bounds
        margin = 0.03 * max(x_max - x_min, y_max - y_min)
        ax.set(
            xlim=(x_min - margin, x_max + margin),
            ylim=(y_min - margin, y_max + margin),
            aspect="equal",
        )
        ax.set(xlabel="x (m)", ylabel="y (m)")
        ax.locator_params(nbins=5)
        beam: dict[str, Any] = {"color": ROLE["beam"], "zorder": _LAYER["beam"]}
        self.beams = LineCollection([], linewidths=0.9, label="laser", **beam)
        ax.add_collection(self.beams, autolim=False)
        (self.hits,) = ax.plot([], [], ".", markersize=5, **beam)
        (self.path,) = ax.plot(
            [],
            [],
            color=ROLE["path"],
            linewidth=1.8,
            zorder=_LAYER["path"],
            label="path",
        )
        (self.start,) = ax.plot(
            [], [], "s", color=ROLE["path"], markersize=6, zorder=_LAYER["path"]
        )
        (self.heading,) = ax.plot(
            [], [], color="w", lw=2.5, zorder=_LAYER["wheel"], solid_capstyle="round"
        )
        self.patches: dict[str, Polygon] = {}
        self.words: dict[str, Text] = {}
        letters: dict[str, Any] = {
            "ha": "center",
            "fontsize": 9,
            "zorder": _LAYER["text"],
        }
        for solid in scene.solids:
            look = {"alpha": 0.45, "hatch": "//"} if solid.role == "goal" else {}
            patch = Polygon(
                footprint(solid), color=ROLE[solid.role], linewidth=0, label=solid.name
            )
            ax.add_patch(patch).set(zorder=_LAYER[solid.role], **look)
            if solid.role != "wall":
                self.patches[solid.name] = patch
            if solid.role in ("goal", "object"):
                self.words[solid.name] = ax.text(
                    0, 0, "\n" + plain(solid.name), va="top", **letters
                )
        self.words["start"] = ax.text(0, 0, "", va="bottom", **letters)
        drawn: list[Artist] = [
            self.beams,
            self.hits,
            self.path,
            self.start,
            self.heading,
        ]
        self.moving = sorted(
            [*drawn, *self.patches.values(), *self.words.values()],
            key=Artist.get_zorder,
        )
        self.update(scene, path_of([scene]))

    def update(self, scene: Scene, path: np.ndarray) -> None:
        """Move everything to where it is in `scene`; path: array (n, 2 or 3) [m], the way to there."""
        covered = (
            len(path) < 2
        )  # the start is hidden: the robot has not left it, or stands on it again
        for solid in scene.solids:
            if solid.name in self.patches:
                self.patches[solid.name].set_xy(footprint(solid))
            if solid.name in self.words:
                self.words[solid.name].set(position=solid.pose[:2, 3])
            if solid.name == "robot/body":
                line = nose(solid)
                self.heading.set_data(*line.T)
                covered = covered or math.dist(line[0], path[0, :2]) < math.dist(*line)
        self.beams.set(segments=scene.beams[:, :, :2])
        self.hits.set_data(scene.beams[:, 1, 0], scene.beams[:, 1, 1])
        self.path.set_data(path[:, 0], path[:, 1])
        self.start.set_data(*path[: 0 if covered else 1, :2].T)
        self.words["start"].set_text("" if covered else "start\n")
        if not covered:
            self.words["start"].set(position=path[0, :2])


class Camera:
    """Looks down on the room of `scene`. Walls and axes are drawn once and then copied under every frame.

    pixels: width and height of the frames
    view: the artists that move
    """

    def __init__(self, scene: Scene, pixels: int = 360) -> None:
        self._figure = Picture((pixels / DPI, pixels / DPI), dpi=DPI)
        canvas: Any = FigureCanvasAgg(self._figure)  # its methods have no types
        ax = self._figure.add_subplot()
        self._caption = ax.set_title("0", fontsize=11)
        self.view = TopDown(ax, scene)
        self._moving = [*self.view.moving, self._caption]
        for artist in self._moving:
            artist.set_animated(True)  # left out of the background
        canvas.draw()
        self._canvas, self._background = (
            canvas,
            canvas.copy_from_bbox(self._figure.bbox),
        )

    def frame(
        self, scene: Scene, caption: str, path: np.ndarray | None = None
    ) -> np.ndarray:
        """The room as it is in `scene`, under a caption; array (pixels, pixels, 3) of uint8.

        path: array (n, 2 or 3) [m], the way there; None draws none
        """
        self._canvas.restore_region(self._background)
        self.view.update(scene, path_of([scene]) if path is None else path)
        self._caption.set_text(caption)
        for artist in self._moving:
            self._figure.draw_artist(artist)
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()


@overload
def plot_scene(
    scenes: Scenes, ax: None = None, title: str | None = None
) -> Picture: ...
@overload
def plot_scene(scenes: Scenes, ax: Axes, title: str | None = None) -> Axes: ...
def plot_scene(
    scenes: Scenes, ax: Axes | None = None, title: str | None = None
) -> Picture | Axes:
    """Picture of a scene from above, axes in metres.

    Parameters
    ----------
    scenes : Scene or sequence of Scene
        One scene, or several in the order of time: the last is drawn in full, with the path through all.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; by default those of a new figure.
    title : str, optional
        The line above the picture.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        The new figure, or `ax` where it was given.

    Raises
    ------
    ValueError
        If there is no scene in `scenes`.
    """
    scenes = as_scenes(scenes)
    ax, drawn = axes_or_new(ax, describe(scenes[-1]), (4.5, 4.5))
    TopDown(ax, scenes[-1]).update(scenes[-1], path_of(scenes))
    ax.set_title(plain(title or "The robot's world from above"))
    return drawn
