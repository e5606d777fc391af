"""Where meshcat's camera stands, and its light."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import meshcat.geometry as g
import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.in3d.looks import Name, has_walls

FIELD_OF_VIEW = 35  # from bottom to top [degrees]
ASPECT = 1.5  # width over height
MARGIN = 1.13  # distance of the camera, in parts of the least one
ROUNDS = 12  # until the picture's frame no longer changes
# Turned to the left and raised [rad]: a room with walls hides what is in it, unless it is seen from above.
OVER_WALLS = (0.0, 1.0)
FROM_THE_SIDE = (0.35, 0.55)
WALL_SHOWN = 0.4  # height up to which walls are in the picture [m]
EDGE = 0.04  # of a table, around its floor [m]
INNER = 0.6  # part of the floor's width in which high things are in the picture
HIDDEN_PATHS = (  # meshcat's own background and lights
    "/Background",
    "/Grid",
    "/Axes",
    "/Lights/PointLightPositiveX",
    "/Lights/PointLightNegativeX",
)


def camera(scene: Scene) -> tuple[g.PerspectiveCamera, np.ndarray, np.ndarray]:
    """A camera that sees the floor, the walls and, in the middle of the room, what is high.

    Returns the lens, the point at which it looks, and its position from there, arrays (3,) [m].
    """
    points = _points_to_see(scene)
    turn, rise = OVER_WALLS if has_walls(scene) else FROM_THE_SIDE
    axes = _axes(turn, rise)
    back = axes[2]
    half_height = math.tan(math.radians(FIELD_OF_VIEW / 2))  # at a distance of 1
    half_picture = np.array([ASPECT * half_height, half_height])
    target = np.append(_corners(scene).mean(axis=0), 0.0)
    # Each round comes as near as all points allow, then moves their middle to that of the picture.
    for _ in range(ROUNDS):
        seen = (points - target) @ axes.T  # to the right, up, towards the camera
        # a point is in the picture if |right|, |up| ≤ half_picture · (distance − towards)
        needed = seen[:, 2] + np.abs(seen[:, :2] / half_picture).max(axis=1)
        distance = MARGIN * needed.max()
        slopes = seen[:, :2] / (distance - seen[:, 2:])
        middle = (slopes.max(axis=0) + slopes.min(axis=0)) / 2
        target = target + middle * distance @ axes[:2]
    lens = g.PerspectiveCamera(FIELD_OF_VIEW, ASPECT, distance / 100, 10 * distance)
    return lens, target, distance * back


def _corners(scene: Scene) -> np.ndarray:
    """The corners of the floor, array (4, 2) [m]."""
    x_min, y_min, x_max, y_max = scene.bounds
    return np.array([(x_min, y_min), (x_min, y_max), (x_max, y_min), (x_max, y_max)])


def _points_to_see(scene: Scene) -> np.ndarray:
    """What must be in the picture: the corners of the floor and of the walls, and what is high; array (n, 3) [m]."""
    tops = [solid.pose[2, 3] + solid.size[-1] / 2 for solid in scene.solids]
    high = max(tops)
    corners = _corners(scene)
    if not has_walls(scene):
        middle = corners.mean(axis=0)
        table = np.insert(corners + EDGE * np.sign(corners - middle), 2, 0.0, axis=1)
        places = np.array([solid.pose[:3, 3] for solid in scene.solids])
        places[:, 2] = tops
        return np.vstack([table, places])
    middle = corners.mean(axis=0)
    inner = middle + INNER * (corners - middle)
    floor = np.insert(corners, 2, 0.0, axis=1)
    walls = np.insert(corners, 2, min(high, WALL_SHOWN), axis=1)
    inside = np.insert(inner, 2, high, axis=1)
    return np.vstack([floor, walls, inside])


def _axes(turn: float, rise: float) -> np.ndarray:
    """Directions to the right, up and back of a camera that is turned to the left and raised [rad]; array (3, 3)."""
    level = math.cos(rise)
    back = np.array([math.sin(turn) * level, -math.cos(turn) * level, math.sin(rise)])
    right = np.array([math.cos(turn), math.sin(turn), 0.0])
    return np.stack((right, np.cross(back, right), back))


def surroundings(scene: Scene) -> Iterator[tuple[str, str, object]]:
    """Properties of meshcat's own background and lights: (path, name, value)."""
    for path in HIDDEN_PATHS:
        yield path, "visible", False
    yield "/Lights/SpotLight", "visible", True
    x_min, y_min, x_max, y_max = scene.bounds
    span = max(x_max - x_min, y_max - y_min)
    sun: dict[str, Any] = {
        "position": [-0.7 * span, -0.5 * span, 1.9 * span],
        "intensity": 0.5,
        "distance": 0,
        "angle": 0.45,
        "penumbra": 0.3,
        "castShadow": True,
    }
    for name, value in sun.items():
        yield "/Lights/SpotLight/<object>", Name(name), value
