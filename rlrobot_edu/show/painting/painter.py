"""A painter: faces, lines and shadows in space on a picture, on which each pixel shows what is nearest."""

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageColor, ImageDraw
from scipy.spatial import ConvexHull

from rlrobot_edu.show.painting.lens import Lens
from rlrobot_edu.show.painting.mesh import Mesh

FINE = 2  # the painter's pixels in each direction for one of the picture, so that edges are smooth
SUN = np.array([-0.45, -0.35, 1.0])  # where the light comes from
AMBIENT = 0.6  # part of its colour that a face has which the sun does not reach
SHADE = 0.88  # part of its colour that a floor has in a shadow
ROUND = 16  # corners of a dot

Window = tuple[slice, slice]  # rows and columns of a part of the picture


def rgb(code: str) -> np.ndarray:
    """Red, green and blue of the colour ``#rrggbb``, array (3,) from 0 to 255."""
    return np.array(ImageColor.getrgb(code), dtype=float)


class Painter:
    """Paints what a lens sees.

    lens: what it sees has FINE pixels in each direction for one of the picture
    width, height: of the picture [pixels]
    paper: the colour ``#rrggbb`` where nothing is
    """

    def __init__(self, lens: Lens, width: int, height: int, paper: str) -> None:
        self._lens = lens
        size = (FINE * height, FINE * width)
        self._colours = np.empty((*size, 3), dtype=np.uint8)
        self._colours[:] = rgb(paper)
        self._nearness = np.full(size, -np.inf, dtype=np.float32)
        self._is_sunny = np.zeros(size, dtype=bool)  # floor that no shadow falls on

    def copy(self) -> "Painter":
        """Another painter with the same picture so far."""
        twin = object.__new__(Painter)
        twin._lens = self._lens
        twin._colours = self._colours.copy()
        twin._nearness = self._nearness.copy()
        twin._is_sunny = self._is_sunny.copy()
        return twin

    def picture(self) -> Image.Image:
        """What has been painted so far."""
        return Image.fromarray(self._colours).reduce(FINE)

    def place(self, point: np.ndarray) -> tuple[float, float]:
        """Where a point, array (3,) [m], is on the picture: to the right and downwards [pixels]."""
        x, y, _ = self._lens.seen(point[None])[0] / FINE
        return float(x), float(y)

    def body(
        self, mesh: Mesh, pose: np.ndarray, colour: str, opacity: float = 1.0
    ) -> None:
        """Paint the faces of a body that look this way, where nothing nearer is.

        pose: array (4, 4), of the body in the scene [m]; colour: ``#rrggbb``
        """
        corners = self._lens.seen(placed(mesh.corners, pose))
        lights = light_on(mesh.normals @ pose[:3, :3].T)
        for face, light in zip(mesh.faces, lights, strict=True):
            seen = corners[face]
            if _faces_us(seen):
                self._fill(seen, light * rgb(colour), opacity)

    def catch_shadows(self, corners: np.ndarray) -> None:
        """From now on shadows fall on what is seen inside of an outline, array (n, 3) [m]: on a floor."""
        window, inside = self._inside(self._lens.seen(corners))
        self._is_sunny[window] |= inside

    def shadows(self, outlines: Sequence[np.ndarray]) -> None:
        """Darken the floor inside of outlines, arrays (n, 3) [m], where it is seen; no place twice."""
        for outline in outlines:
            window, inside = self._inside(self._lens.seen(outline))
            falls = inside & self._is_sunny[window]
            colours = self._colours[window]
            colours[falls] = SHADE * colours[falls]
            self._is_sunny[window] &= ~falls

    def line(
        self, start: np.ndarray, end: np.ndarray, colour: str, width: float
    ) -> None:
        """Paint a line, where nothing nearer is.

        start, end: arrays (3,) [m]; width: on the picture [pixels]
        """
        first, last = self._lens.seen(np.stack((start, end)))
        along = last[:2] - first[:2]
        half = FINE * width / 2
        along *= half / max(float(np.hypot(*along)), 1e-9)
        ahead = np.array([along[0], along[1], 0.0])
        aside = np.array([along[1], -along[0], 0.0])
        first, last = first - ahead, last + ahead
        corners = [first - aside, last - aside, last + aside, first + aside]
        self._fill(np.array(corners), rgb(colour))

    def dot(self, point: np.ndarray, colour: str, width: float) -> None:
        """Paint a dot, where nothing nearer is. point: array (3,) [m]; width: on the picture [pixels]"""
        angles = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
        rim = np.column_stack((np.cos(angles), np.sin(angles), np.zeros(ROUND)))
        middle = self._lens.seen(point[None])
        self._fill(middle + FINE * width / 2 * rim, rgb(colour))

    def _fill(self, seen: np.ndarray, colour: np.ndarray, opacity: float = 1.0) -> None:
        """Paint a polygon, array (n, 3) as a lens sees it, where nothing nearer is."""
        window, inside = self._inside(seen)
        nearness = _nearness_in(seen, window)
        before = self._nearness[window]
        shows = inside & (nearness > before)
        colours = self._colours[window]
        colours[shows] = (1 - opacity) * colours[shows] + opacity * colour
        before[shows] = nearness[shows]
        self._is_sunny[window] &= ~shows

    def _inside(self, seen: np.ndarray) -> tuple[Window, np.ndarray]:
        """The part of the picture that holds a polygon, and which of its pixels are inside."""
        height, width = self._nearness.shape
        left, top = np.floor(seen[:, :2].min(axis=0)).astype(int).clip(0, None)
        right, bottom = np.ceil(seen[:, :2].max(axis=0)).astype(int) + 1
        columns = slice(left, max(min(right, width), left))
        rows = slice(top, max(min(bottom, height), top))
        size = (columns.stop - left, rows.stop - top)
        if 0 in size:
            return (rows, columns), np.zeros((size[1], size[0]), dtype=bool)
        mask = Image.new("1", size)
        corners = [(x - left, y - top) for x, y in seen[:, :2].tolist()]
        ImageDraw.Draw(mask).polygon(corners, fill=1)
        return (rows, columns), np.asarray(mask)


def placed(corners: np.ndarray, pose: np.ndarray) -> np.ndarray:
    """Corners, array (n, 3), of a body that stands at this pose, array (4, 4) [m]."""
    return np.asarray(corners @ pose[:3, :3].T + pose[:3, 3])


def light_on(normals: np.ndarray) -> np.ndarray:
    """Part of its colour that a face has, by its direction, array (n, 3); what lies level has all of it."""
    towards_sun = (normals @ SUN / SUN[2]).clip(0, 1)
    return np.asarray(AMBIENT + (1 - AMBIENT) * towards_sun)


def shadow_of(corners: np.ndarray) -> np.ndarray:
    """The outline of the shadow that falls on the floor from what these points span, arrays (n, 3) and (m, 3) [m]."""
    fall = corners - corners[:, 2:] * SUN / SUN[2]
    return np.asarray(fall[ConvexHull(fall[:, :2]).vertices])


def _faces_us(seen: np.ndarray) -> bool:
    """Whether we look at the outside of a face, array (n, 3) as a lens sees it: its corners go round to the left."""
    area = 0.0
    x_before, y_before, _ = seen[-1].tolist()
    for x, y, _ in seen.tolist():
        area += x_before * y - x * y_before
        x_before, y_before = x, y
    return area < 0


def _nearness_in(seen: np.ndarray, window: Window) -> np.ndarray:
    """How near each pixel of a part of the picture is on the plane through a polygon's corners."""
    rows, columns = window
    middle = seen.mean(axis=0)
    x, y, near = (seen - middle).T
    # the slopes that fit the corners best; a polygon that is a line on the picture has none
    xx, xy, yy = x @ x, x @ y, y @ y
    determinant = xx * yy - xy * xy
    slope_x, slope_y = 0.0, 0.0
    if determinant > 1e-6:
        slope_x = (yy * (x @ near) - xy * (y @ near)) / determinant
        slope_y = (xx * (y @ near) - xy * (x @ near)) / determinant
    across = slope_x * (np.arange(columns.start, columns.stop) - middle[0])
    down = slope_y * (np.arange(rows.start, rows.stop) - middle[1])
    return np.asarray(middle[2] + across + down[:, None], dtype=np.float32)
