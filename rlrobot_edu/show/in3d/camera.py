"""Where meshcat's camera stands, and its light."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import meshcat.geometry as g

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.in3d.looks import Name
from rlrobot_edu.show.painting.lens import FIELD_OF_VIEW, stand_for

ASPECTS = (1.04, 1.25, 1.6)  # width over height of the pictures that have a camera
MARGIN = 1.08  # distance of the camera, in parts of the least one
HIDDEN_PATHS = (  # meshcat's own background and lights
    "/Background",
    "/Grid",
    "/Axes",
    "/Lights/PointLightPositiveX",
    "/Lights/PointLightNegativeX",
)


def camera(scene: Scene) -> tuple[g.PerspectiveCamera, dict[str, Any]]:
    """A camera that sees the floor, the walls and, in the middle of the room, what is high.

    Two views of a room see it from the same place, wherever its robot was.

    Returns its lens, and the command that tells a page where it stands on a picture of each shape: the point at which
    it looks, and from there its position [m].
    """
    stands = []
    farthest = 0.0
    for aspect in ASPECTS:
        stand = stand_for(scene, aspect, MARGIN)
        eye = stand.distance * stand.axes[2]
        stands.append(
            {"aspect": aspect, "target": stand.target.tolist(), "eye": eye.tolist()}
        )
        farthest = max(farthest, stand.distance)
    lens = g.PerspectiveCamera(FIELD_OF_VIEW, 1.0, farthest / 100, 10 * farthest)
    return lens, {"type": "stands", "path": "/Cameras/default", "stands": stands}


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
