"""What a room, the things in it and a robot look like in meshcat: geometries and materials of its own. Lengths in m."""

from __future__ import annotations

import math
from typing import NamedTuple

import meshcat.geometry as g
import numpy as np

from rlrobot_edu.robots.scene import ON_ITS_SIDE, Scene, Solid, pose
from rlrobot_edu.show.palette import LIGHT, ROLE

UPRIGHT = ON_ITS_SIDE  # three.js's cylinders stand along y
DARK = LIGHT["ink"]
METAL = "#a9b0b8"
RUBBER = LIGHT["ink"]
WHITE = LIGHT["paper"]
WALL = LIGHT["wall"]
FLOOR = LIGHT["floor"]
GRID = LIGHT["line"]
WOOD = "#c08b55"
SCREEN = "#dfe3e8"
GLASS = "#8fc7ea"
UNPAID = LIGHT["grey"]  # of a trail
BY_NAME = {"table": WOOD, "field": "#e6dfc8"}


class Part(NamedTuple):
    """A part that a solid is drawn with; pose: array (4, 4), from the part to its solid."""

    name: str
    geometry: g.Geometry
    material: g.Material
    pose: np.ndarray


class Name(str):
    """The name of a property as three.js has it: meshcat would write it in small letters."""

    def lower(self) -> str:
        """The name as it is."""
        return str(self)


def paint(code: str, opacity: float = 1.0) -> g.Material:
    """A material of the colour ``#rrggbb`` that shines a little."""
    return g.MeshPhongMaterial(
        color=_number(code), opacity=opacity, shininess=40, specular=0x2A2A2A
    )


def matt(code: str) -> g.Material:
    """A material of the colour ``#rrggbb`` that does not shine."""
    return g.MeshLambertMaterial(color=_number(code))


def flat(code: str) -> g.Material:
    """A material of the colour ``#rrggbb`` as it is, whatever the light."""
    return g.MeshBasicMaterial(color=_number(code), opacity=0.7)


def _number(code: str) -> int:
    """The colour ``#rrggbb`` as meshcat takes it."""
    return int(code.removeprefix("#"), 16)


def _rgb(code: str) -> np.ndarray:
    """Red, green and blue of the colour ``#rrggbb``, array (3,) from 0 to 1."""
    return np.array(bytearray.fromhex(code.removeprefix("#"))) / 255


def at(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """Moved by (x, y, z) and not turned."""
    return pose(x, y, z)


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
    """A solid's geometry, and how meshcat's is turned to it."""
    if shape == "box":
        return g.Box(size), np.eye(4)
    if shape == "sphere":
        return g.Sphere(size[0]), np.eye(4)
    if shape == "cylinder":
        radius, height = size
        return g.Cylinder(height, radius), UPRIGHT
    *outline, height = size
    return prism(np.reshape(outline, (-1, 2)), height), np.eye(4)


def parts(solid: Solid) -> list[Part]:
    """The parts that a solid is drawn with."""
    is_body = solid.name == "robot/body"
    if solid.role == "wheel" and solid.shape == "cylinder":
        return _wheel(solid)
    if solid.name == "robot/nose":
        return _arrow(solid)
    if is_body and solid.shape == "prism":
        return _pioneer(solid)
    if is_body and solid.shape == "cylinder":
        return _disc(solid)
    if solid.name == "robot/screen":
        return _screen(solid)
    plain, turned = geometry(solid.shape, solid.size)
    if solid.role == "goal":
        return [Part("disc", plain, paint(ROLE["goal"], 0.45), turned)]
    if solid.role == "wheel":
        return [Part("finger", plain, paint(DARK), turned)]
    if solid.role == "wall":
        look = matt(BY_NAME.get(solid.name, WALL))
    else:
        look = paint(BY_NAME.get(solid.name, ROLE[solid.role]))
    return [Part("body", plain, look, turned)]


def _wheel(solid: Solid) -> list[Part]:
    """A wheel of the base, or a servo in a joint of the arm; cap and spoke show that it turns."""
    radius, width = solid.size
    is_wheel = solid.name.endswith("_wheel")
    tyre = g.Cylinder(width, radius)
    cap = g.Cylinder(1.06 * width, 0.6 * radius)
    found = [
        Part("tyre", tyre, paint(RUBBER if is_wheel else DARK), UPRIGHT),
        Part("cap", cap, paint(METAL), UPRIGHT),
    ]
    if is_wheel:
        spoke = g.Box((1.1 * radius, 0.2 * radius, 1.1 * width))
        found.append(Part("spoke", spoke, paint(DARK), np.eye(4)))
    return found


def _arrow(solid: Solid) -> list[Part]:
    """An arrow on the robot, to tell front from back."""
    length, width, height = solid.size
    outline = np.array([[0.25, 0], [-0.75, 1], [-0.5, 0], [-0.75, -1]])
    arrow = prism(outline * (length, width), 0.012)
    return [Part("arrow", arrow, paint(WHITE), at(z=0.014 - height / 2))]


def _pioneer(solid: Solid) -> list[Part]:
    """A slim body, and a deck as wide as the outline that bumps."""
    *outline, height = solid.size
    hull = np.reshape(outline, (-1, 2))
    waist = 0.66 * hull[:, 1].max()
    slim = np.column_stack((0.96 * hull[:, 0], hull[:, 1].clip(-waist, waist)))
    below = at(-0.2, 0, -height / 2 - 0.045)
    return [
        Part("body", prism(slim, height), paint(ROLE["robot"]), np.eye(4)),
        Part("deck", prism(hull, 0.016), paint(ROLE["robot"]), at(z=height / 2)),
        Part("caster", g.Sphere(0.035), paint(RUBBER), below),
    ]


def _disc(solid: Solid) -> list[Part]:
    """A round body, and a bumper around it."""
    radius, height = solid.size
    body = g.Cylinder(height, 0.97 * radius)
    bumper = g.Cylinder(0.3 * height, radius)
    low = at(z=-0.2 * height) @ UPRIGHT
    return [
        Part("body", body, paint(ROLE["robot"]), UPRIGHT),
        Part("bumper", bumper, paint(DARK), low),
    ]


def _screen(solid: Solid) -> list[Part]:
    """Giraff's screen."""
    length, width, height = solid.size
    glass = g.Box((0.004, 0.85 * width, 0.85 * height))
    return [
        Part("case", g.Box(solid.size), paint(SCREEN), np.eye(4)),
        Part("glass", glass, paint(GLASS), at(length / 2)),
    ]


def floor(scene: Scene) -> list[Part]:
    """A floor with a grid of lines; without walls it is the wood of a table."""
    x_min, y_min, x_max, y_max = scene.bounds
    width = x_max - x_min
    depth = y_max - y_min
    edge, colour = (0.12, FLOOR) if has_walls(scene) else (0.04, WOOD)
    slab = g.Box((width + 2 * edge, depth + 2 * edge, 0.02))
    middle = at((x_min + x_max) / 2, (y_min + y_max) / 2, -0.012)
    span = max(width, depth)
    cell = _grid_cell(span)
    lines = []
    for x in np.arange(math.ceil(x_min / cell), x_max / cell) * cell:
        lines.append(((x, y_min, 0), (x, y_max, 0)))
    for y in np.arange(math.ceil(y_min / cell), y_max / cell) * cell:
        lines.append(((x_min, y, 0), (x_max, y, 0)))
    points = np.reshape(lines, (-1, 3)).T
    grid = g.PointsGeometry(points.astype(np.float32))
    thin = g.LineBasicMaterial(color=_number(GRID))
    return [
        Part("slab", slab, matt(colour), middle),
        Part("grid", grid, thin, at(z=span / 2000)),
    ]


def _grid_cell(span: float) -> float:
    """How far apart the lines of a floor are that is so wide [m]."""
    if span > 1.8:
        return 0.5
    return 0.25 if span > 0.8 else 0.05


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
    """A band along points, array (n + 1, 3) [m]: green for reward, red and wider for punishment.

    rewards: array (n,), of the step to each point but the first; NaN where the robot was put there, which leaves a gap
    most: the reward that has the full colour; a punishment has it from a fifth of this on
    width: of the band where nothing is paid [m]
    """
    was_put = np.isnan(rewards)[:, None]
    rewards = np.nan_to_num(rewards)[:, None]
    is_bad = rewards < 0
    weight = np.where(is_bad, 5, 1)
    strength = np.sqrt(weight * np.abs(rewards) / (most or 1.0)).clip(0, 1)
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


def has_walls(scene: Scene) -> bool:
    """Whether the scene is a room, not a table alone."""
    return any(solid.name.startswith("wall") for solid in scene.solids)
