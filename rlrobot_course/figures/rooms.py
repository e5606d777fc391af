"""A room without axes: a floor, walls, and one bar that is a metre long."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.top_down import footprint


def take_axes_off(ax: Axes, scene: Scene, bar: bool = True) -> None:
    """Put a floor in place of the axes of a room, and below it a bar of one metre.

    ax: on which `plot_scene` has drawn the scene
    """
    ax.set_axis_off()
    walls = [footprint(solid) for solid in scene.solids if solid.role == "wall"]
    corners = np.vstack([*walls, np.reshape(scene.bounds, (2, 2))])
    left, bottom = corners.min(axis=0)
    right, top = corners.max(axis=0)
    width, height = right - left, top - bottom
    floor = Rectangle((left, bottom), width, height, color=LIGHT["floor"], zorder=0)
    ax.add_patch(floor)
    edge = 0.01 * width
    below = 0.1 * height if bar else edge
    ax.set(xlim=(left - edge, right + edge), ylim=(bottom - below, top + edge))
    if bar:
        y = bottom - 0.06 * height
        ax.plot([left, left + 1], [y, y], color=LIGHT["faint"], linewidth=2)
        ax.text(left + 1.02 + edge, y, "1 m", va="center", color=LIGHT["faint"])
