"""What a room, the things in it and a robot look like in meshcat: geometries and materials of its own. Lengths in m."""

from __future__ import annotations

import math

import meshcat.geometry as g
import numpy as np

from rlrobot_edu.robots.scene import ON_ITS_SIDE
from rlrobot_edu.show.describe import CLEAR
from rlrobot_edu.show.painting.parts import Part
from rlrobot_edu.show.palette import LIGHT, SHINE

UPRIGHT = ON_ITS_SIDE  # three.js's cylinders stand along y
UNPAID = LIGHT["grey"]  # of a trail


class Name(str):
    """The name of a property as three.js has it: meshcat would write it in small letters."""

    def lower(self) -> str:
        """The name as it is."""
        return str(self)


def material(part: Part) -> g.Material:
    """What a part is made of: it shines a little, or not at all."""
    colour = _number(part.colour)
    if not part.shines:
        return g.MeshLambertMaterial(color=colour, opacity=part.opacity)
    return g.MeshPhongMaterial(
        color=colour, opacity=part.opacity, shininess=40, specular=_number(SHINE)
    )


def flat(code: str) -> g.Material:
    """A material of the colour ``#rrggbb`` as it is, whatever the light."""
    return g.MeshBasicMaterial(color=_number(code), opacity=0.7)


def grid_lines(lines: np.ndarray) -> g.LineSegments:
    """Lines on the floor; array (n, 2, 2), start and end of each."""
    points = np.insert(lines.reshape(-1, 2), 2, 0.0, axis=1)
    thin = g.LineBasicMaterial(color=_number(LIGHT["line"]))
    return g.LineSegments(g.PointsGeometry(points.T.astype(np.float32)), thin)


def _number(code: str) -> int:
    """The colour ``#rrggbb`` as meshcat takes it."""
    return int(code.removeprefix("#"), 16)


def _rgb(code: str) -> np.ndarray:
    """Red, green and blue of the colour ``#rrggbb``, array (3,) from 0 to 1."""
    return np.array(bytearray.fromhex(code.removeprefix("#"))) / 255


def prism(base: np.ndarray, height: float) -> g.Geometry:
    """An upright prism about the origin; base: array (n, 2), its convex outline counter-clockwise."""
    n = len(base)
    low = np.column_stack((base, np.full(n, -height / 2)))
    high = np.column_stack((base, np.full(n, height / 2)))
    triangles = []
    for i in range(1, n - 1):  # of the base and the top
        triangles.append((low[0], low[i + 1], low[i]))
        triangles.append((high[0], high[i], high[i + 1]))
    for i in range(n):  # of the sides
        j = (i + 1) % n
        triangles.append((low[i], low[j], high[j]))
        triangles.append((low[i], high[j], high[i]))
    # No two triangles share a corner, so that each face has a normal of its own.
    corners = np.reshape(triangles, (-1, 3))
    return g.TriangularMeshGeometry(corners, np.arange(len(corners)).reshape(-1, 3))


def geometry(shape: str, size: tuple[float, ...]) -> tuple[g.Geometry, np.ndarray]:
    """A part's geometry, and how meshcat's is turned to it."""
    if shape == "box":
        return g.Box(size), np.eye(4)
    if shape == "sphere":
        return g.Sphere(size[0]), np.eye(4)
    if shape == "cylinder":
        radius, height = size
        return g.Cylinder(height, radius), UPRIGHT
    *outline, height = size
    return prism(np.reshape(outline, (-1, 2)), height), np.eye(4)


def beam(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Where a cylinder of length 1 along y becomes the beam from start to end [m]; array (4, 4)."""
    length = max(math.dist(start, end), 1e-6)
    x, y, z = 1.0, 0.0, 0.0
    if length > 1e-6:
        x, y, z = ((end - start) / length).tolist()
    level = math.hypot(x, y)
    u, v = 1.0, 0.0  # a level direction across the beam
    if level > 1e-9:
        u, v = y / level, -x / level
    start_x, start_y, start_z = start.tolist()
    end_x, end_y, end_z = end.tolist()
    return np.array(
        [
            [u, length * x, v * z, (start_x + end_x) / 2],
            [v, length * y, -u * z, (start_y + end_y) / 2],
            [0, length * z, u * y - v * x, (start_z + end_z) / 2],
            [0, 0, 0, 1],
        ]
    )


def trail(
    points: np.ndarray, rewards: np.ndarray, most: float, width: float
) -> g.Geometry:
    """A band along points, array (n + 1, 3) [m]: green for reward, red and wider for a loss, else grey.

    rewards: array (n,), of the step to each point but the first; NaN where the robot was put there, which leaves a gap
    most: what is paid or lost at most; a loss is at least a part of this, see `loss_of`
    width: of the band where nothing is paid [m]
    """
    was_put = np.isnan(rewards)[:, None]
    rewards = np.nan_to_num(rewards)[:, None]
    is_bad = (rewards < 0) & (CLEAR * -rewards >= most)
    strength = np.where(is_bad | (rewards > 0), 1.0, 0.0)
    full = np.where(is_bad, _rgb(LIGHT["red"]), _rgb(LIGHT["green"]))
    unpaid = _rgb(UNPAID)
    tint = unpaid + strength * (full - unpaid)
    # Each piece overlaps the next, so that bends have no gaps.
    a, b = points[:-1], points[1:]
    along = (b - a) * (1, 1, 0)
    along *= width / 2 / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    beside = along[:, [1, 0, 2]] * (-1, 1, 0) * (1 + 2 * strength * is_bad)
    start = a - along
    end = np.where(was_put, start, b + along)
    left, right = start + beside, start - beside
    far_left, far_right = end + beside, end - beside
    corners = np.stack((left, right, far_right, left, far_right, far_left), axis=1)
    faces = np.arange(6 * len(a)).reshape(-1, 3)
    colours = np.repeat(tint, 6, axis=0)
    return g.TriangularMeshGeometry(corners.reshape(-1, 3), faces, colours)
