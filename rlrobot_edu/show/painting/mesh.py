"""The shapes that a scene is made of, as corners and flat faces."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

SIDES = 18  # of a cylinder, and of a sphere's equator
RINGS = 6  # of a sphere's faces, from pole to pole


class Mesh(NamedTuple):
    """A convex body about its own middle.

    corners: array (n, 3) [m]
    faces: the numbers of each face's corners, counter-clockwise for who looks at it from outside
    normals: array (faces, 3), of length 1, to the outside
    """

    corners: np.ndarray
    faces: list[list[int]]
    normals: np.ndarray


@lru_cache(maxsize=256)
def mesh(shape: str, size: tuple[float, ...]) -> Mesh:
    """The mesh of a shape. shape, size: as those of a `Solid`"""
    if shape == "sphere":
        return _ball(size[0])
    *base, height = size
    if shape == "box":
        length, width = base
        corners = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
        outline = corners * (length / 2, width / 2)
    elif shape == "cylinder":
        outline = base[0] * _circle()
    else:
        outline = np.reshape(base, (-1, 2))
    return _upright(outline, height)


def _upright(outline: np.ndarray, height: float) -> Mesh:
    """An upright prism; outline: array (n, 2), convex, counter-clockwise [m]."""
    n = len(outline)
    low = np.column_stack((outline, np.full(n, -height / 2)))
    high = low + (0, 0, height)
    faces = [list(range(n, 2 * n)), list(range(n))[::-1]]
    for i in range(n):
        j = (i + 1) % n
        faces.append([i, j, n + j, n + i])
    return _mesh_of(np.vstack((low, high)), faces)


def _ball(radius: float) -> Mesh:
    """A sphere as rings of faces, from its south to its north pole."""
    rings = []
    for rise in np.linspace(-math.pi / 2, math.pi / 2, RINGS + 1):
        level = math.cos(rise) * _circle()
        rings.append(np.column_stack((level, np.full(SIDES, math.sin(rise)))))
    faces = []
    for ring in range(RINGS):
        low, high = ring * SIDES, (ring + 1) * SIDES
        for i in range(SIDES):
            j = (i + 1) % SIDES
            faces.append([low + i, low + j, high + j, high + i])
    return _mesh_of(radius * np.vstack(rings), faces)


def _circle() -> np.ndarray:
    """Points on a circle of radius 1, array (SIDES, 2)."""
    angles = np.linspace(0, 2 * math.pi, SIDES, endpoint=False)
    return np.column_stack((np.cos(angles), np.sin(angles)))


def _mesh_of(corners: np.ndarray, faces: list[list[int]]) -> Mesh:
    """The mesh with these faces."""
    normals = []
    for face in faces:
        here = corners[face]
        # the sum over all sides has the face's direction, also if two of its corners are one
        normal = np.cross(here, np.roll(here, -1, axis=0)).sum(axis=0)
        normals.append(normal / np.linalg.norm(normal))
    return Mesh(corners, faces, np.array(normals))
