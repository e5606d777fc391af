"""What can be seen around a robot at one instant: solids and laser beams, for any viewer to draw."""

import math
from typing import NamedTuple

import numpy as np

ON_ITS_SIDE = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


class Solid(NamedTuple):
    """One rigid body.

    name: unique in its scene, a path such as ``robot/body``
    shape: ``box``, ``cylinder`` or ``prism`` (upright along their own z) or ``sphere``
    size: box (length, width, height), cylinder (radius, height), sphere (radius,), prism (x, y of each corner of its
        convex base, counter-clockwise, height) [m]
    pose: array (4, 4), the homogeneous transform from the solid's centre to the scene's origin [m]
    role: ``wall``, ``robot``, ``wheel``, ``object`` or ``goal``; the viewer chooses the colour by it. Walls never move.
    """

    name: str
    shape: str
    size: tuple[float, ...]
    pose: np.ndarray
    role: str


class Scene(NamedTuple):
    """All that a viewer draws of one instant.

    solids: everything with a body; the one named ``robot/body`` leaves the path
    beams: array (n, 2, 3), start and end of every laser beam [m]
    bounds: (x_min, y_min, x_max, y_max) [m]
    bumped: whether the robot has run into something, as far as it knows
    """

    solids: tuple[Solid, ...]
    beams: np.ndarray
    bounds: tuple[float, float, float, float]
    bumped: bool = False


def pose(x: float, y: float, z: float, yaw: float = 0.0) -> np.ndarray:
    """Homogeneous transform of a body at (x, y, z) [m], turned by `yaw` [rad] about the vertical; array (4, 4)."""
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array(
        [
            [c, -s, 0, x],
            [s, c, 0, y],
            [0, 0, 1, z],
            [0, 0, 0, 1.0],
        ]
    )
