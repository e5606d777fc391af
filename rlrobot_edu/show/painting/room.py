"""A room and the robot in it, painted: floor, walls, things, the robot's way and what its lasers find near it."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from PIL import Image

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import NEAR, body_of, describe, jumps
from rlrobot_edu.show.display import Still
from rlrobot_edu.show.images import in_few_colours, png_of
from rlrobot_edu.show.painting import lens
from rlrobot_edu.show.painting.mesh import mesh
from rlrobot_edu.show.painting.painter import FINE, Painter, placed, shadow_of
from rlrobot_edu.show.painting.parts import floor, grid, has_walls, parts
from rlrobot_edu.show.palette import LIGHT, ROLE

ASPECT = 1.45  # width over height of a picture
COLOURS = 64  # of a still
ON_FLOOR = 0.01  # height of what is painted on the floor [m]
CROSS = 0.07  # half the width of the cross where it bumped, [m]
LEAST_LINE = 1.5  # width of a line [pixels]
RING = 1.5  # radius of the ring round a robot that loses, in parts of the robot's


class Room:
    """Pictures of one room. What does not move is painted once.

    scene: the room; width, height: of the pictures [pixels]; is_map: from above, not as a camera sees it
    paper: the colour round the room
    """

    def __init__(
        self,
        scene: Scene,
        width: int,
        height: int,
        *,
        is_map: bool = False,
        paper: str = LIGHT["paper"],
    ) -> None:
        look = lens.from_above if is_map else lens.eye
        seen_by = look(scene, FINE * width, FINE * height)
        self._painter = Painter(seen_by, width, height, paper)
        self._line_width = max(LEAST_LINE, width / 300)
        self._on_floor = has_walls(scene)  # an arm on a table moves in the air
        slab = floor(scene)
        its_mesh = mesh(slab.shape, slab.size)
        self._painter.body(its_mesh, slab.pose, slab.colour)
        top = its_mesh.corners[its_mesh.faces[0]]
        if not is_map:  # on a map one would take shadows for things
            self._painter.catch_shadows(placed(top, slab.pose))
        for ends in grid(scene):
            start, end = np.insert(ends, 2, ON_FLOOR / 2, axis=1)
            self._painter.line(start, end, LIGHT["line"], 1.0)
        self._paint(self._painter, [s for s in scene.solids if s.role == "wall"])

    def lay_trail(self, before: Scene, after: Scene, colour: str) -> None:
        """Paint the way from one scene to the next, in all pictures from now on."""
        self._trail(self._painter, before, after, colour)

    def mark_loss(self, scene: Scene) -> None:
        """Paint a cross where the robot is, in all pictures from now on."""
        foot = self._foot_of(scene)
        if foot is None:
            return
        for aside in ((CROSS, CROSS, 0), (CROSS, -CROSS, 0)):
            self._painter.line(
                foot - aside, foot + aside, LIGHT["red"], 1.5 * self._line_width
            )

    def picture(
        self, scene: Scene, way: Sequence[Scene] = (), *, loses: bool = False
    ) -> Image.Image:
        """The room as it is in a scene.

        way: scenes in the order of time; the robot's way through them is shown in this picture alone
        loses: the robot is red, with a ring
        """
        painter = self._painter.copy()
        for before, after in pairwise(way):
            self._trail(painter, before, after, LIGHT["green"])
        moving = [solid for solid in scene.solids if solid.role != "wall"]
        self._paint(painter, moving, robot=LIGHT["red"] if loses else ROLE["robot"])
        for start, end in scene.beams:
            if math.dist(start, end) < NEAR:
                painter.line(start, end, LIGHT["orange"], self._line_width)
                painter.dot(end, LIGHT["orange"], 3 * self._line_width)
        if loses:
            self._ring(painter, scene)
        return painter.picture()

    def still(self, scene: Scene, way: Sequence[Scene] = ()) -> Still:
        """The picture, for a page on which it is half as wide as in its file."""
        image = self.picture(scene, way)
        few = in_few_colours(image, COLOURS)
        return Still(describe(scene), png_of(few), image.width // 2)

    def _trail(
        self, painter: Painter, before: Scene, after: Scene, colour: str
    ) -> None:
        """Paint the way from one scene to the next, unless the robot was put there."""
        start, end = self._foot_of(before), self._foot_of(after)
        if start is None or end is None or jumps(before, after):
            return
        wide = 1.5 if self._on_floor else 3  # in the air much of it is hidden
        painter.line(start, end, colour, wide * self._line_width)

    def _foot_of(self, scene: Scene) -> np.ndarray | None:
        """Where the robot's way passes: on the floor, or in the air if it is an arm; array (3,) [m]."""
        body = body_of(scene)
        if body is None:
            return None
        place = body.pose[:3, 3].copy()
        if self._on_floor:
            place[2] = ON_FLOOR
        return np.asarray(place)

    def _paint(
        self, painter: Painter, solids: list[Solid], robot: str = ROLE["robot"]
    ) -> None:
        """Paint things and their shadows; robot: the colour of a robot's body."""
        ready, shadows = [], []
        for solid in solids:
            for part in parts(solid):
                colour = robot if part.colour == ROLE["robot"] else part.colour
                its_mesh = mesh(part.shape, part.size)
                pose = solid.pose @ part.pose
                ready.append((its_mesh, pose, colour, part.opacity))
                shadows.append(shadow_of(placed(its_mesh.corners, pose)))
        painter.shadows(shadows)
        for body in ready:
            painter.body(*body)

    def _ring(self, painter: Painter, scene: Scene) -> None:
        """Paint a ring on the floor round the robot."""
        body, foot = body_of(scene), self._foot_of(scene)
        if body is None or foot is None:
            return
        reach = np.abs(mesh(body.shape, body.size).corners[:, :2]).max()
        angles = np.linspace(0, 2 * math.pi, 33)
        circle = np.column_stack((np.cos(angles), np.sin(angles), 0 * angles))
        points = foot + RING * reach * circle
        for start, end in pairwise(points):
            painter.line(start, end, LIGHT["red"], 1.5 * self._line_width)


def painted(way: Sequence[Scene], width: int = 560) -> Still:
    """The last of some scenes and the robot's way through all, as a picture to keep; width: [pixels of a page]"""
    room = Room(way[-1], 2 * width, round(2 * width / ASPECT))
    return room.still(way[-1], way)
