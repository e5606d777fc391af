"""What a room, the things in it and a robot are drawn with: plain shapes and colours, for pictures and for meshcat."""

import math
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.painting.mesh import mesh
from rlrobot_edu.show.palette import (
    FIELD,
    GLASS,
    LIGHT,
    METAL,
    ROLE,
    SCREEN,
    WOOD,
)

UNTURNED = np.eye(4)
BY_NAME = {"table": WOOD, "field": FIELD}
THICK = 0.02  # of a floor [m]
TABLE_EDGE = 0.04  # how far a table reaches beyond where the arm works [m]


class Part(NamedTuple):
    """A part that a solid is drawn with.

    shape, size: as those of a `Solid`
    colour: ``#rrggbb``
    pose: array (4, 4), from the part to its solid [m]
    opacity: below 1 one sees through it
    shines: as metal or lacquer does
    """

    name: str
    shape: str
    size: tuple[float, ...]
    colour: str
    pose: np.ndarray = UNTURNED
    opacity: float = 1.0
    shines: bool = True


def at(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    """Moved by (x, y, z) [m] and not turned."""
    return pose(x, y, z)


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
    if solid.role == "goal":
        return [Part("disc", solid.shape, solid.size, ROLE["goal"], opacity=0.45)]
    if solid.name == "field":
        return [_paint(solid)]
    colour = BY_NAME.get(solid.name, ROLE[solid.role])
    is_wall = solid.role == "wall"
    return [Part("body", solid.shape, solid.size, colour, shines=not is_wall)]


def _wheel(solid: Solid) -> list[Part]:
    """A wheel of the base, or a servo in a joint of the arm; cap and spoke show that it turns."""
    radius, width = solid.size
    dark = LIGHT["ink"]
    cap = (0.6 * radius, 1.06 * width)
    found = [
        Part("tyre", "cylinder", (radius, width), dark),
        Part("cap", "cylinder", cap, METAL),
    ]
    if solid.name.endswith("_wheel"):
        spoke = (1.1 * radius, 0.2 * radius, 1.1 * width)
        # a cylinder stands along its own z
        found.append(Part("spoke", "box", spoke, dark))
    return found


def _arrow(solid: Solid) -> list[Part]:
    """An arrow on the robot, to tell front from back."""
    length, width, height = solid.size
    tip = (0.25 * length, 0.0)
    back = (-0.5 * length, 0.0)
    left = (-0.75 * length, width)
    right = (-0.75 * length, -width)
    on_top = at(z=0.014 - height / 2)
    # two triangles, because a prism's base is convex
    return [
        Part("left", "prism", (*tip, *left, *back, 0.012), LIGHT["paper"], on_top),
        Part("right", "prism", (*tip, *back, *right, 0.012), LIGHT["paper"], on_top),
    ]


def _pioneer(solid: Solid) -> list[Part]:
    """A slim body, and a deck as wide as the outline that bumps."""
    *outline, height = solid.size
    hull = np.reshape(outline, (-1, 2))
    waist = 0.66 * hull[:, 1].max()
    slim = np.column_stack((0.96 * hull[:, 0], hull[:, 1].clip(-waist, waist)))
    colour = ROLE["robot"]
    below = at(-0.2, 0, -height / 2 - 0.045)
    return [
        Part("body", "prism", (*slim.ravel().tolist(), height), colour),
        Part("deck", "prism", (*outline, 0.016), colour, at(z=height / 2)),
        Part("caster", "sphere", (0.035,), LIGHT["ink"], below),
    ]


def _disc(solid: Solid) -> list[Part]:
    """A round body, and a bumper around it."""
    radius, height = solid.size
    low = at(z=-0.2 * height)
    return [
        Part("body", "cylinder", (0.97 * radius, height), ROLE["robot"]),
        Part("bumper", "cylinder", (radius, 0.3 * height), LIGHT["ink"], low),
    ]


def _paint(solid: Solid) -> Part:
    """What is only painted on a table: so thin that it has no side, and the wood shows through."""
    length, width, _ = solid.size
    return Part("paint", "box", (length, width, 1e-4), FIELD, opacity=0.5, shines=False)


def _screen(solid: Solid) -> list[Part]:
    """Giraff's screen."""
    length, width, height = solid.size
    glass = (0.004, 0.85 * width, 0.85 * height)
    return [
        Part("case", "box", solid.size, SCREEN),
        Part("glass", "box", glass, GLASS, at(length / 2)),
    ]


def has_walls(scene: Scene) -> bool:
    """Whether the scene is a room, not a table alone."""
    return any(solid.name.startswith("wall") for solid in scene.solids)


def ground(scene: Scene) -> tuple[float, float, float, float]:
    """The floor of a room with what its walls stand on, or a table: x_min, y_min, x_max, y_max [m]."""
    bounds = np.reshape(scene.bounds, (2, 2))
    if not has_walls(scene):
        (x_min, y_min), (x_max, y_max) = bounds + TABLE_EDGE * np.array([[-1], [1]])
        return x_min, y_min, x_max, y_max
    corners = [bounds]
    for solid in scene.solids:
        if solid.role == "wall":
            placed = mesh(solid.shape, solid.size).corners @ solid.pose[:3, :3].T
            corners.append((placed + solid.pose[:3, 3])[:, :2])
    points = np.vstack(corners)
    x_min, y_min = points.min(axis=0).tolist()
    x_max, y_max = points.max(axis=0).tolist()
    return x_min, y_min, x_max, y_max


def floor(scene: Scene) -> Part:
    """The floor of a room, or the wood of a table; its pose is in the scene."""
    x_min, y_min, x_max, y_max = ground(scene)
    colour = LIGHT["floor"] if has_walls(scene) else WOOD
    size = (x_max - x_min, y_max - y_min, THICK)
    middle = at((x_min + x_max) / 2, (y_min + y_max) / 2, -0.6 * THICK)
    return Part("slab", "box", size, colour, middle, shines=False)


def grid_cell(scene: Scene) -> float:
    """The side of the squares on the floor [m]: a metre in a room."""
    x_min, y_min, x_max, y_max = scene.bounds
    span = max(x_max - x_min, y_max - y_min)
    if span > 1.8:
        return 1.0
    return 0.25 if span > 0.8 else 0.1


def squares(scene: Scene) -> str:
    """How wide the squares on the floor are, as a sentence."""
    side = grid_cell(scene)
    told = f"{side:g} m" if side >= 1 else f"{100 * side:g} cm"
    return f"A square of the {'floor' if has_walls(scene) else 'table'} is {told} wide."


def grid(scene: Scene) -> np.ndarray:
    """The lines of the squares on the floor, array (n, 2, 2): start and end of each [m]."""
    x_min, y_min, x_max, y_max = scene.bounds
    cell = grid_cell(scene)
    lines = []
    for x in np.arange(math.ceil(x_min / cell), x_max / cell) * cell:
        lines.append(((x, y_min), (x, y_max)))
    for y in np.arange(math.ceil(y_min / cell), y_max / cell) * cell:
        lines.append(((x_min, y), (x_max, y)))
    return np.reshape(lines, (-1, 2, 2))
