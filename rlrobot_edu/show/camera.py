"""Pictures of one room from above, one after another: for films, and for environments that are asked to render."""

from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.show.scenes import path_of
from rlrobot_edu.show.top_down import TopDown

DPI = 90


class Camera:
    """Looks down on the room of `scene`. Walls and axes are drawn once and then copied under every frame.

    pixels: width and height of the frames
    view: the artists that move
    """

    def __init__(self, scene: Scene, pixels: int = 360) -> None:
        self._figure = Picture((pixels / DPI, pixels / DPI), dpi=DPI)
        canvas: Any = FigureCanvasAgg(self._figure)  # its methods have no types
        ax = self._figure.add_subplot()
        self._caption = ax.set_title("0", fontsize=11)
        self.view = TopDown(ax, scene)
        self._moving = [*self.view.moving, self._caption]
        for artist in self._moving:
            artist.set_animated(True)  # left out of the background
        canvas.draw()
        self._canvas, self._background = canvas, canvas.copy_from_bbox(self._figure.bbox)

    def frame(self, scene: Scene, caption: str, path: np.ndarray | None = None) -> np.ndarray:
        """The room as it is in `scene`, under a caption; array (pixels, pixels, 3) of uint8.

        path: array (n, 2 or 3) [m], the way there; None draws none
        """
        self._canvas.restore_region(self._background)
        self.view.update(scene, path_of([scene]) if path is None else path)
        self._caption.set_text(caption)
        for artist in self._moving:
            self._figure.draw_artist(artist)
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()
