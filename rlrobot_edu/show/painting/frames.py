"""The pictures of a film: a room, and below it a dark bar with the step, its reward and the sum so far."""

from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import losses
from rlrobot_edu.show.numerals import signed
from rlrobot_edu.show.painting.lens import eye
from rlrobot_edu.show.painting.mesh import mesh
from rlrobot_edu.show.painting.painter import placed
from rlrobot_edu.show.painting.room import ASPECT, Room
from rlrobot_edu.show.palette import BACKDROP, DARK, LIGHT
from rlrobot_edu.show.story import what_was_lost
from rlrobot_edu.show.style import font_file

LETTERS = 0.047  # size of the bar's letters, in parts of the picture's width
ROUND_IT = 0.08  # how much is shown round the robot, in the same parts
STRIP = 0.012  # height of the strip that shows how far the film is, in the same parts


def frames(
    scenes: Sequence[Scene],
    rewards: Sequence[float],
    notes: Sequence[str],
    width: int,
    *,
    is_map: bool = False,
) -> Iterator[Image.Image]:
    """The pictures of the steps, one after the other.

    scenes, rewards: of each step; notes: a line for each step, or none; width: of a picture [pixels]
    is_map: the room from above
    """
    room = Room(scenes[0], width, round(width / ASPECT), is_map=is_map, paper=BACKDROP)
    bar = Bar(len(scenes), width, has_notes=bool(notes))
    loses = losses(rewards)
    sums = np.cumsum(rewards)
    before = scenes[0]
    for i, scene in enumerate(scenes):
        room.lay_trail(before, scene, LIGHT[colour_of(rewards[i], loses[i])])
        before = scene
        above = room.picture(scene, loses=loses[i])
        if loses[i]:
            room.mark_loss(scene)
        word = what_was_lost(scene) if loses[i] else ""
        note = notes[i] if notes else ""
        below = bar.picture(i, rewards[i], loses[i], word, float(sums[i]), note)
        whole = Image.new("RGB", (width, above.height + below.height))
        whole.paste(above)
        whole.paste(below, (0, above.height))
        yield whole


def closer(
    scenes: Sequence[Scene], pictures: Sequence[Image.Image], width: int
) -> Iterator[Image.Image]:
    """The part of a film's pictures in which something moves, without the bar; the same part of each.

    width: of what is returned [pixels], at most that of the pictures
    """
    box = _window(scenes, pictures[0].width, width)
    for picture in pictures:
        part = picture.crop(box)
        yield part.resize((width, round(width / ASPECT)), Image.Resampling.LANCZOS)


def _window(
    scenes: Sequence[Scene], whole: int, least_width: int
) -> tuple[int, int, int, int]:
    """The part of a room's picture in which something moves: left, upper, right, lower [pixels].

    whole: width of the picture; least_width: of the part [pixels]
    """
    size = np.array([whole, whole / ASPECT])
    shown = []
    for scene in scenes:
        for solid in scene.solids:
            if solid.name == "robot/body" or solid.role in ("object", "goal"):
                shown.append(placed(mesh(solid.shape, solid.size).corners, solid.pose))
    if not shown:
        return (0, 0, whole, round(whole / ASPECT))
    seen = eye(scenes[0], whole, round(whole / ASPECT)).seen(np.vstack(shown))
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    across, down = high - low + 2 * ROUND_IT * whole
    wide = min(max(across, ASPECT * down, least_width), whole)
    part = np.array([wide, wide / ASPECT])
    corner = ((low + high - part) / 2).clip(0, size - part)
    left, upper = corner.round().astype(int).tolist()
    right, lower = (corner + part).round().astype(int).tolist()
    return left, upper, right, lower


def colour_of(reward: float, loses: bool) -> str:
    """The name of the colour of a step's way and number."""
    if loses:
        return "red"
    return "green" if reward > 0 else "grey"


class Bar:
    """The bar below the pictures of a film, dark on a light page and on a dark one.

    steps: how many there are; row: height of a line [pixels]
    """

    def __init__(self, steps: int, width: int, *, has_notes: bool) -> None:
        self._steps = steps
        self._done: list[str] = []  # the colour of each step so far
        self._width = width
        self._size = round(LETTERS * width)
        self.row = round(1.7 * self._size)
        self._strip = round(STRIP * width)
        self._height = self.row * (2 if has_notes else 1) + self._strip

    def picture(
        self, i: int, reward: float, loses: bool, word: str, total: float, note: str
    ) -> Image.Image:
        """The bar of step i, counted from 0, after those before. word: what happened; total: of the rewards so far"""
        image = Image.new("RGB", (self._width, self._height), DARK["paper"])
        pen = ImageDraw.Draw(image)
        y = self.row / 2
        edge = self._size / 2
        gap = 0.4 * self._size
        name = colour_of(reward, loses)
        ink = "faint" if name == "grey" else name
        pieces = [
            (f"step {i + 1}", True, "ink"),
            (f"of {self._steps}", False, "faint"),
            (signed(reward), True, ink),
            (word, True, ink),
        ]
        x = edge
        for text, bold, colour in pieces:
            font = letters(self._size, bold)
            pen.text((x, y), text, DARK[colour], font, "lm")
            x += font.getlength(text) + gap
        plain, strong = letters(self._size, False), letters(self._size, True)
        end = self._width - edge
        pen.text((end, y), signed(total), DARK["ink"], strong, "rm")
        end -= strong.getlength(signed(total)) + gap
        pen.text((end, y), "sum", DARK["faint"], plain, "rm")
        if note:
            pen.text((edge, 1.4 * self.row), note, DARK["ink"], plain, "lm")
        self._done.append(name)
        top = self._height - self._strip
        pen.rectangle((0, top, self._width, self._height), DARK["line"])
        for k, what in enumerate(self._done):
            start, end = (round(self._width * n / self._steps) for n in (k, k + 1))
            pen.rectangle((start, top, end - 1, self._height), DARK[what])
        return image


@lru_cache
def letters(size: int, bold: bool) -> ImageFont.FreeTypeFont:
    """The letters of all pictures. size: [pixels]"""
    return ImageFont.truetype(font_file(bold), size)
