"""A scene seen from above: walls, robot and heading, laser beams and the way the robot came."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Polygon
from scipy.spatial import ConvexHull

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.palette import ROLE
from rlrobot_edu.show.picture import Picture

# what lies on top when seen from above; wheels are drawn over the body that hides them
_LAYER = {"wall": 1, "goal": 2, "path": 3, "beam": 4, "object": 5, "robot": 6, "wheel": 7, "text": 8}
_CIRCLE = np.array([(math.cos(t), math.sin(t)) for t in np.linspace(0, 2 * math.pi, 32, endpoint=False)])


def as_scenes(scenes: Scene | Sequence[Scene]) -> list[Scene]:
    """One scene or several as a list. Raises ValueError for anything else, or for none."""
    found = [scenes] if isinstance(scenes, Scene) else list(scenes) if isinstance(scenes, Sequence) else []
    if not found or not all(isinstance(scene, Scene) for scene in found):
        raise ValueError("a picture needs one scene or several: give it env.unwrapped.robot.scene()")
    return found


def half_height(solid: Solid) -> float:
    """From the solid's centre to its top along its own z [m]."""
    return solid.size[0] if solid.shape == "sphere" else solid.size[-1] / 2


def footprint(solid: Solid) -> np.ndarray:
    """Outline of a solid's shadow under a light straight above; array (n, 2) [m]."""
    centre = solid.pose[:2, 3]
    if solid.shape == "sphere":
        return centre + solid.size[0] * _CIRCLE
    corners = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)]) * np.array(solid.size[:2]) / 2
    rim = solid.size[0] * _CIRCLE if solid.shape == "cylinder" else corners
    top = half_height(solid)
    points = np.vstack([np.column_stack([rim, np.full(len(rim), z)]) for z in (-top, top)])
    shadow = centre + points @ solid.pose[:2, :3].T
    return shadow[ConvexHull(shadow).vertices]


def path_of(scenes: Sequence[Scene]) -> np.ndarray:
    """Where ``robot/body`` was in each scene; array (n, 3) [m], n = 0 where there is no such solid."""
    return np.array([s.pose[:3, 3] for scene in scenes for s in scene.solids if s.name == "robot/body"]).reshape(-1, 3)


def describe(scene: Scene) -> str:
    """The scene in one sentence, for those who hear a page instead of seeing it."""
    x_min, y_min, x_max, y_max = scene.bounds
    text = f"A room of {x_max - x_min:.1f} by {y_max - y_min:.1f} metres"
    for solid in scene.solids:
        if solid.name == "robot/body":
            yaw = math.degrees(math.atan2(solid.pose[1, 0], solid.pose[0, 0]))
            text += f", the robot at x = {solid.pose[0, 3]:.1f}, y = {solid.pose[1, 3]:.1f}, heading {yaw:.0f} degrees"
    return text + "."


class TopDown:
    """The artists of one picture: walls are drawn once, the `moving` artists follow `update`.

    ax: the axes to draw on; scene: what to draw first
    """

    def __init__(self, ax: Axes, scene: Scene) -> None:
        x_min, y_min, x_max, y_max = scene.bounds
        margin = 0.03 * max(x_max - x_min, y_max - y_min)
        ax.set(xlim=(x_min - margin, x_max + margin), ylim=(y_min - margin, y_max + margin), aspect="equal")
        ax.set(xlabel="x (m)", ylabel="y (m)")
        ax.locator_params(nbins=5)
        self.beams = LineCollection([], colors=ROLE["beam"], linewidths=0.9, zorder=_LAYER["beam"], label="laser")
        ax.add_collection(self.beams, autolim=False)
        (self.hits,) = ax.plot([], [], ".", color=ROLE["beam"], markersize=5, zorder=_LAYER["beam"])
        (self.path,) = ax.plot([], [], color=ROLE["path"], linewidth=1.8, zorder=_LAYER["path"], label="path")
        (self.start,) = ax.plot([], [], "s", color=ROLE["path"], markersize=6, zorder=_LAYER["path"])
        (self.heading,) = ax.plot([], [], color="white", linewidth=2.5, zorder=_LAYER["wheel"], solid_capstyle="round")
        self.patches, self.words = {}, {}
        for solid in scene.solids:
            faint = solid.role == "goal"
            patch = Polygon(footprint(solid), color=ROLE[solid.role], linewidth=0, alpha=0.45 if faint else 1,
                            hatch="//" if faint else None, zorder=_LAYER[solid.role], label=solid.name)  # fmt: skip
            ax.add_patch(patch)
            if solid.role != "wall":
                self.patches[solid.name] = patch
            if solid.role in ("goal", "object"):
                self.words[solid.name] = ax.text(0, 0, solid.name, ha="center", va="center", fontsize=8,
                                                 zorder=_LAYER["text"])  # fmt: skip
        self.words["start"] = ax.text(0, 0, "", ha="center", va="bottom", fontsize=8, zorder=_LAYER["text"])
        artists = [self.beams, self.hits, self.path, self.start, self.heading]
        self.moving = sorted([*artists, *self.patches.values(), *self.words.values()], key=lambda a: a.get_zorder())
        self.update(scene, path_of([scene]))

    def update(self, scene: Scene, path: np.ndarray) -> None:
        """Move everything to where it is in `scene`; path: array (n, 2 or 3) [m], the way to there."""
        covered = len(path) < 2  # no start to be seen: the robot has not left it, or stands on it again
        for solid in scene.solids:
            if solid.name in self.patches:
                self.patches[solid.name].set_xy(footprint(solid))
            if solid.name in self.words:
                self.words[solid.name].set_position(solid.pose[:2, 3])
            if solid.name == "robot/body":
                centre, ahead = solid.pose[:2, 3], solid.pose[:2, 0]
                reach = np.max((footprint(solid) - centre) @ ahead)
                self.heading.set_data(*np.array([centre, centre + 0.9 * reach * ahead]).T)
                covered = covered or math.dist(centre, path[0, :2]) < reach
        self.beams.set_segments(scene.beams[:, :, :2])
        self.hits.set_data(scene.beams[:, 1, 0], scene.beams[:, 1, 1])
        self.path.set_data(path[:, 0], path[:, 1])
        start = path[: 0 if covered else 1, :2]
        self.start.set_data(start[:, 0], start[:, 1])
        self.words["start"].set_text("" if covered else "start\n")
        if not covered:
            self.words["start"].set_position(path[0, :2])


def plot_scene(scenes: Scene | Sequence[Scene], ax: Axes | None = None, title: str | None = None) -> Picture | Axes:
    """Picture of a scene from above, axes in metres.

    scenes: one Scene, or several in the order of time: the last is drawn in full, with the path through all
    ax: axes to draw on; None makes a figure of its own
    Returns the figure, or `ax` where one was given.
    Raises ValueError for an empty sequence.
    """
    scenes = as_scenes(scenes)
    figure = None
    if ax is None:
        figure = Picture(figsize=(4.5, 4.5), layout="constrained")
        figure.alt = describe(scenes[-1])
        ax = figure.subplots()
    TopDown(ax, scenes[-1]).update(scenes[-1], path_of(scenes))
    ax.set_title(title or "The robot's world from above")
    return figure or ax
