"""How a scene is seen on a picture: from above, as on a map, or by a camera that stands before it."""

import math
from typing import NamedTuple, Protocol

import numpy as np

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.painting.parts import ground, has_walls

FIELD_OF_VIEW = 35  # of a camera, from bottom to top [degrees]
MARGIN = 1.06  # distance of a camera, in parts of the least one
ROUNDS = 12  # until the picture's frame no longer changes
# Turned to the left and raised [rad]: a room with walls hides what is in it, unless it is seen from above.
OVER_WALLS = (0.0, 1.0)
STEEPLY = (0.0, 1.25)  # on a narrow picture, which a floor seen from above fills better
NARROW = 1.2  # width over height
FROM_THE_SIDE = (0.35, 0.55)
WALL_SHOWN = 0.4  # height up to which walls are in the picture [m]
INNER = 0.6  # part of the floor's width in which high things are in the picture


class Lens(Protocol):
    """From places in the scene to places on a picture."""

    def seen(self, points: np.ndarray) -> np.ndarray:
        """Where points are on the picture: array (n, 3).

        Each row is x to the right and y downwards [pixels], and how near the point is: the larger, the nearer. On the
        picture of a plane, nearness changes evenly.

        points: array (n, 3) [m]
        """


class FromAbove(NamedTuple):
    """A map: x to the right, y upwards, the same scale for both. scale: pixels for a metre; middle: of the map [m]"""

    scale: float
    middle: tuple[float, float]
    width: int
    height: int

    def seen(self, points: np.ndarray) -> np.ndarray:
        """See `Lens`; what is higher is nearer."""
        x = self.width / 2 + self.scale * (points[:, 0] - self.middle[0])
        y = self.height / 2 - self.scale * (points[:, 1] - self.middle[1])
        return np.column_stack((x, y, points[:, 2]))


class Eye(NamedTuple):
    """A camera. position: array (3,) [m]; axes: array (3, 3), its directions to the right, up and back

    focal: pixels for an angle whose tangent is 1
    """

    position: np.ndarray
    axes: np.ndarray
    focal: float
    width: int
    height: int

    def seen(self, points: np.ndarray) -> np.ndarray:
        """See `Lens`; a point at twice the distance is half as near."""
        right, up, back = ((points - self.position) @ self.axes.T).T
        nearness = -1 / back
        x = self.width / 2 + self.focal * right * nearness
        y = self.height / 2 - self.focal * up * nearness
        return np.column_stack((x, y, nearness))


class Stand(NamedTuple):
    """Where a camera stands: target, at which it looks [m], distance [m], axes as those of an `Eye`."""

    target: np.ndarray
    distance: float
    axes: np.ndarray


def from_above(scene: Scene, width: int, height: int) -> FromAbove:
    """The map of a scene's floor, as large as fits into the picture [pixels]."""
    x_min, y_min, x_max, y_max = ground(scene)
    scale = min(width / (x_max - x_min), height / (y_max - y_min))
    middle = ((x_min + x_max) / 2, (y_min + y_max) / 2)
    return FromAbove(scale, middle, width, height)


def eye(scene: Scene, width: int, height: int) -> Eye:
    """A camera whose picture, in pixels, holds the floor, the walls and, in the middle of the room, what is high."""
    stand = stand_for(scene, width / height, MARGIN)
    position = stand.target + stand.distance * stand.axes[2]
    focal = height / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
    return Eye(position, stand.axes, focal, width, height)


def stand_for(scene: Scene, aspect: float, margin: float) -> Stand:
    """Where a camera stands.

    aspect: width over height; margin: its distance, in parts of the least one
    """
    corners = _corners(scene)
    points = _points_to_see(scene, corners)
    turn, rise = FROM_THE_SIDE
    if has_walls(scene):
        turn, rise = STEEPLY if aspect < NARROW else OVER_WALLS
    axes = _axes(turn, rise)
    half_height = math.tan(math.radians(FIELD_OF_VIEW / 2))  # at a distance of 1
    half_picture = np.array([aspect * half_height, half_height])
    target = np.append(corners.mean(axis=0), 0.0)
    # Each round comes as near as all points allow, then moves their middle to that of the picture.
    for _ in range(ROUNDS):
        seen = (points - target) @ axes.T  # to the right, up, towards the camera
        # a point is in the picture if |right|, |up| ≤ half_picture · (distance − towards)
        needed = seen[:, 2] + np.abs(seen[:, :2] / half_picture).max(axis=1)
        distance = margin * needed.max()
        slopes = seen[:, :2] / (distance - seen[:, 2:])
        middle = (slopes.max(axis=0) + slopes.min(axis=0)) / 2
        target = target + middle * distance @ axes[:2]
    return Stand(target, float(distance), axes)


def _corners(scene: Scene) -> np.ndarray:
    """The corners of the floor, array (4, 2) [m]."""
    x_min, y_min, x_max, y_max = ground(scene)
    return np.array([(x_min, y_min), (x_min, y_max), (x_max, y_min), (x_max, y_max)])


def _points_to_see(scene: Scene, corners: np.ndarray) -> np.ndarray:
    """What must be in the picture: the corners of the floor and of the walls, and what is high; array (n, 3) [m].

    corners: array (4, 2), of the floor [m]
    """
    tops = [solid.pose[2, 3] + solid.size[-1] / 2 for solid in scene.solids]
    high = max(tops)
    middle = corners.mean(axis=0)
    inner = middle + INNER * (corners - middle)
    floor = np.insert(corners, 2, 0.0, axis=1)
    if not has_walls(scene):
        places = np.array([solid.pose[:3, 3] for solid in scene.solids])
        places[:, 2] = tops
        return np.vstack([floor, places])
    walls = np.insert(corners, 2, min(high, WALL_SHOWN), axis=1)
    inside = np.insert(inner, 2, high, axis=1)
    return np.vstack([floor, walls, inside])


def _axes(turn: float, rise: float) -> np.ndarray:
    """Directions to the right, up and back of a camera that is turned to the left and raised [rad]; array (3, 3)."""
    level = math.cos(rise)
    back = np.array([math.sin(turn) * level, -math.cos(turn) * level, math.sin(rise)])
    right = np.array([math.cos(turn), math.sin(turn), 0.0])
    return np.stack((right, np.cross(back, right), back))
