"""What a room, the things in it and a robot look like in meshcat: geometries and materials of its own. Lengths in m."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import meshcat.geometry as g
import numpy as np

from rlrobot_edu.robots.scene import ON_ITS_SIDE, Scene, Solid, pose
from rlrobot_edu.show.palette import ROLE

Part = tuple[
    str, g.Geometry, g.Material, np.ndarray
]  # its name, and where it is in its solid's frame
UPRIGHT = ON_ITS_SIDE  # three.js's cylinders stand along y
DARK, METAL, RUBBER, FLOOR, GRID = "#24272c", "#a9b0b8", "#1b1c1e", "#d3cdbf", "#a39d90"
WOOD, WHITE = "#c08b55", "#ffffff"
FIELD, ASPECT = (
    35,
    1.5,
)  # of the camera: from bottom to top [degrees], width over height


class Name(str):
    """The name of a property as three.js has it: meshcat would write it in small letters."""

    def lower(self) -> str:
        """The name as it is."""
        return str(self)


def paint(code: str, opacity: float = 1.0) -> g.Material:
    """A material of the colour ``#rrggbb`` that shines a little."""
    return g.MeshPhongMaterial(
        color=int(code[1:], 16), opacity=opacity, shininess=40, specular=0x2A2A2A
    )


def matt(code: str) -> g.Material:
    """A material of the colour ``#rrggbb`` that does not shine."""
    return g.MeshLambertMaterial(color=int(code[1:], 16))


def flat(code: str) -> g.Material:
    """A material of the colour ``#rrggbb`` as it is, whatever the light."""
    return g.MeshBasicMaterial(color=int(code[1:], 16), opacity=0.7)


def at(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """Moved by (x, y, z) and not turned."""
    return pose(x, y, z)


def prism(base: np.ndarray, height: float) -> g.Geometry:
    """An upright prism about the origin; base: array (n, 2), its convex outline counter-clockwise."""
    low, high = (
        np.column_stack((base, np.full(len(base), z)))
        for z in (-height / 2, height / 2)
    )
    lids = [
        lid
        for i in range(1, len(base) - 1)
        for lid in ((low[0], low[i + 1], low[i]), (high[0], high[i], high[i + 1]))
    ]
    ring = [*range(len(base)), 0]
    sides = [
        side
        for i, j in pairwise(ring)
        for side in ((low[i], low[j], high[j]), (low[i], high[j], high[i]))
    ]
    corners = np.reshape(
        [*lids, *sides], (-1, 3)
    )  # no corner is shared: so each face has a normal of its own
    return g.TriangularMeshGeometry(corners, np.arange(len(corners)).reshape(-1, 3))


def geometry(shape: str, size: tuple[float, ...]) -> tuple[g.Geometry, np.ndarray]:
    """A solid's geometry, and how meshcat's is turned to it."""
    if shape == "box":
        return g.Box(size), np.eye(4)
    if shape == "sphere":
        return g.Sphere(size[0]), np.eye(4)
    if shape == "cylinder":
        return g.Cylinder(size[1], size[0]), UPRIGHT
    return prism(np.reshape(size[:-1], (-1, 2)), size[-1]), np.eye(4)


def parts(solid: Solid) -> Iterator[Part]:
    """What a solid is made of."""
    name, shape, size, _, role = solid
    plain, turned = geometry(shape, size)
    if role == "goal":
        yield "disc", plain, paint(ROLE["goal"], 0.45), turned
    elif (
        role == "wheel" and shape == "cylinder"
    ):  # of the base, or a servo in a joint; its cap shows that it turns
        radius, width = size
        yield "tyre", plain, paint(RUBBER if name.endswith("_wheel") else DARK), turned
        yield "cap", g.Cylinder(1.06 * width, 0.6 * radius), paint(METAL), turned
        if name.endswith("_wheel"):
            yield (
                "spoke",
                g.Box((1.1 * radius, 0.2 * radius, 1.1 * width)),
                paint(DARK),
                np.eye(4),
            )
    elif role == "wheel":
        yield "finger", plain, paint(DARK), turned
    elif name == "robot/nose":  # an arrow, to tell front from back
        length, width, height = size
        outline = np.array([[0.25, 0], [-0.75, 1], [-0.5, 0], [-0.75, -1]]) * (
            length,
            width,
        )
        yield "arrow", prism(outline, 0.012), paint(WHITE), at(z=0.014 - height / 2)
    elif (
        name == "robot/body" and shape == "prism"
    ):  # a Pioneer: a slim body, and a deck as wide as what bumps
        hull, height = np.reshape(size[:-1], (-1, 2)), size[-1]
        waist = 0.66 * hull[:, 1].max()
        slim = np.column_stack((0.96 * hull[:, 0], hull[:, 1].clip(-waist, waist)))
        yield "body", prism(slim, height), paint(ROLE["robot"]), np.eye(4)
        yield "deck", prism(hull, 0.016), paint(DARK), at(z=height / 2)
        yield "caster", g.Sphere(0.035), paint(RUBBER), at(-0.2, 0, -height / 2 - 0.045)
    elif name == "robot/body" and shape == "cylinder":
        radius, height = size
        yield "body", g.Cylinder(height, 0.97 * radius), paint(ROLE["robot"]), turned
        yield (
            "bumper",
            g.Cylinder(0.3 * height, radius),
            paint(DARK),
            at(z=-0.2 * height) @ turned,
        )
    elif name == "robot/screen":
        length, width, height = size
        yield "case", plain, paint("#dfe3e8"), turned
        yield (
            "glass",
            g.Box((0.004, 0.85 * width, 0.85 * height)),
            paint("#8fc7ea"),
            at(length / 2),
        )
    else:
        colour = {"table": WOOD, "field": "#e6dfc8"}.get(
            name, "#8793a1" if role == "wall" else ROLE[role]
        )
        yield "body", plain, (matt if role == "wall" else paint)(colour), turned


def floor(scene: Scene) -> Iterator[Part]:
    """A floor with a line every half metre, or finer; the wood of a table where there are no walls."""
    x0, y0, x1, y1 = scene.bounds
    span, walls = max(x1 - x0, y1 - y0), _has_walls(scene)
    cell, edge = (
        (0.5 if span > 1.8 else 0.25 if span > 0.8 else 0.05),
        0.12 if walls else 0.04,
    )
    slab = g.Box((x1 - x0 + 2 * edge, y1 - y0 + 2 * edge, 0.02))
    yield (
        "slab",
        slab,
        matt(FLOOR if walls else WOOD),
        at((x0 + x1) / 2, (y0 + y1) / 2, -0.012),
    )
    lines = [
        ((x, y0, 0), (x, y1, 0))
        for x in np.arange(math.ceil(x0 / cell), x1 / cell) * cell
    ]
    lines += [
        ((x0, y, 0), (x1, y, 0))
        for y in np.arange(math.ceil(y0 / cell), y1 / cell) * cell
    ]
    grid = g.PointsGeometry(np.reshape(lines, (-1, 3)).T.astype(np.float32))
    yield "grid", grid, g.LineBasicMaterial(color=int(GRID[1:], 16)), at(z=span / 2000)


def beam(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Where a cylinder of length 1 along y becomes the beam from start to end [m]; array (4, 4)."""
    length = max(math.dist(start, end), 1e-6)
    x, y, z = ((end - start) / length).tolist() if length > 1e-6 else (1.0, 0.0, 0.0)
    level = math.hypot(x, y)
    u, v = (
        (y / level, -x / level) if level > 1e-9 else (1.0, 0.0)
    )  # across the beam, and level
    (a, b, c), (d, e, f) = start.tolist(), end.tolist()
    return np.array([[u, length * x, v * z, (a + d) / 2], [v, length * y, -u * z, (b + e) / 2],
                     [0, length * z, u * y - v * x, (c + f) / 2], [0, 0, 0, 1]])  # fmt: skip


def trail(
    points: np.ndarray, rewards: np.ndarray, most: float, width: float
) -> g.Geometry:
    """A band along points, array (n + 1, 3) [m]: green for reward, orange and wider for punishment.

    rewards: array (n,), of the step to each point but the first; nan where the robot was put there, which leaves a gap
    most: what is coloured fully, of a punishment already a fifth of it; width: of the band where nothing is paid [m]
    """
    put, rewards = np.isnan(rewards)[:, None], np.nan_to_num(rewards)[:, None]
    strength = np.sqrt(
        np.where(rewards < 0, 5, 1) * np.abs(rewards) / (most or 1.0)
    ).clip(0, 1)
    good, bad, none = (
        np.array(bytearray.fromhex(code[1:])) / 255
        for code in (ROLE["goal"], ROLE["beam"], "#4d5258")
    )
    tint = none + strength * (np.where(rewards < 0, bad, good) - none)
    a, b = points[:-1], points[1:]
    along = (b - a) * (1, 1, 0)
    along *= width / 2 / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    beside = along[:, [1, 0, 2]] * (-1, 1, 0) * (1 + 2 * strength * (rewards < 0))
    a, b = (
        a - along,
        np.where(put, a - along, b + along),
    )  # each piece overlaps the next, so that bends have no gaps
    corners = np.stack(
        (a + beside, a - beside, b - beside, a + beside, b - beside, b + beside), axis=1
    )
    faces = np.arange(6 * len(a)).reshape(-1, 3)
    return g.TriangularMeshGeometry(
        corners.reshape(-1, 3), faces, np.repeat(tint, 6, axis=0)
    )


def camera(scene: Scene) -> tuple[g.PerspectiveCamera, np.ndarray, np.ndarray]:
    """A camera that sees the floor, the walls and, in the middle of the room, what is high.

    Returns the camera, where it looks and where it is from there, arrays (3,) [m].
    """
    x0, y0, x1, y1 = scene.bounds
    high = max(solid.pose[2, 3] + solid.size[-1] / 2 for solid in scene.solids)
    corners = np.array([(x, y) for x in (x0, x1) for y in (y0, y1)])
    middle, walls = corners.mean(axis=0), _has_walls(scene)
    inner = middle + 0.6 * (corners - middle)
    points = np.vstack([np.insert(base, 2, z, axis=1)
                        for base, z in ((corners, 0.0), (corners, min(high, 0.4)), (inner, high))])  # fmt: skip
    turn, rise = (0.0, 1.0) if walls else (0.35, 0.55)
    back = np.array(
        [
            math.sin(turn) * math.cos(rise),
            -math.cos(turn) * math.cos(rise),
            math.sin(rise),
        ]
    )
    right = np.array([math.cos(turn), math.sin(turn), 0.0])
    axes = np.stack((right, np.cross(back, right), back))
    tall = math.tan(math.radians(FIELD / 2))
    reach = np.array([ASPECT * tall, tall])
    target = np.append(middle, 0.0)
    for _ in range(12):  # as near as all are in the picture, and in its middle
        seen = (points - target) @ axes.T
        distance = 1.13 * (seen[:, 2] + np.abs(seen[:, :2] / reach).max(axis=1)).max()
        slopes = seen[:, :2] / (distance - seen[:, 2:])
        target = (
            target + (slopes.max(axis=0) + slopes.min(axis=0)) / 2 * distance @ axes[:2]
        )
    return (
        g.PerspectiveCamera(FIELD, ASPECT, distance / 100, 10 * distance),
        target,
        distance * back,
    )


def surroundings(scene: Scene) -> Iterator[tuple[str, str, object]]:
    """Properties of meshcat's own background and lights: (path, name, value)."""
    x0, y0, x1, y1 = scene.bounds
    span = max(x1 - x0, y1 - y0)
    for path in (
        "/Background",
        "/Grid",
        "/Axes",
        "/Lights/PointLightPositiveX",
        "/Lights/PointLightNegativeX",
    ):
        yield path, "visible", False
    yield "/Lights/SpotLight", "visible", True
    sun = {"position": [-0.7 * span, -0.5 * span, 1.9 * span], "intensity": 0.5, "distance": 0, "angle": 0.45,
           "penumbra": 0.3, "castShadow": True}  # fmt: skip
    for name, value in sun.items():
        yield "/Lights/SpotLight/<object>", Name(name), value


def _has_walls(scene: Scene) -> bool:
    return any(solid.name.startswith("wall") for solid in scene.solids)
