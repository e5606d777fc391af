"""Where meshcat's camera stands, and its light."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import meshcat.geometry as g
import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.in3d.looks import Name
from rlrobot_edu.show.painting.lens import FIELD_OF_VIEW, stand_for

ASPECT = 1.5  # width over height
MARGIN = 1.13  # distance of the camera, in parts of the least one
HIDDEN_PATHS = (  # meshcat's own background and lights
    "/Background",
    "/Grid",
    "/Axes",
    "/Lights/PointLightPositiveX",
    "/Lights/PointLightNegativeX",
)


def camera(
    scene: Scene, way: np.ndarray | None = None
) -> tuple[g.PerspectiveCamera, np.ndarray, np.ndarray]:
    """A camera that sees the floor, the walls and, in the middle of the room, what is high.

    way: if given, array (n, 3) [m], it sees the part of a room around it.

    Returns the lens, the point at which it looks, and its position from there, arrays (3,) [m].
    """
    stand = stand_for(scene, ASPECT, MARGIN, way)
    distance = stand.distance
    lens = g.PerspectiveCamera(FIELD_OF_VIEW, ASPECT, distance / 100, 10 * distance)
    return lens, stand.target, distance * stand.axes[2]


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
