"""The pictures of a film: a room, and below it a bar with the step, its reward and the sum so far."""

from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import best_step, losses, path_of
from rlrobot_edu.show.numerals import signed
from rlrobot_edu.show.painting.parts import grid_cell
from rlrobot_edu.show.painting.room import ASPECT, Room
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.style import font_file

EDGE = 8  # pixels at both ends of the bar
LETTERS = 21  # [pixels]; on a phone a picture has two thirds of its width
FEW_LETTERS = 14  # in a narrow picture [pixels]
NARROW = 400  # pixels; in a narrower picture only what is needed stands in the bar
TINY = 300  # pixels; in a narrower picture the letters are smaller


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
    room = Room(scenes[0], width, round(width / ASPECT), is_map=is_map)
    bar = Bar(scenes[0], len(scenes), width, has_notes=bool(notes))
    loses = losses(rewards)
    sums = np.cumsum(rewards)
    before = scenes[0]
    for i, scene in enumerate(scenes):
        room.lay_trail(before, scene, colour_of(rewards[i], loses[i]))
        before = scene
        above = room.picture(scene, loses=loses[i])
        if loses[i]:
            room.mark_loss(scene)
        word = ""
        if loses[i]:
            word = "bump!" if scene.bumped else "a loss"
        note = notes[i] if notes else ""
        below = bar.picture(i, rewards[i], loses[i], word, float(sums[i]), note)
        whole = Image.new("RGB", (width, above.height + below.height))
        whole.paste(above)
        whole.paste(below, (0, above.height))
        yield whole


def colour_of(reward: float, loses: bool) -> str:
    """The colour of a step's way and number."""
    if loses:
        return LIGHT["red"]
    return LIGHT["green"] if reward > 0 else LIGHT["grey"]


class Bar:
    """The bar below the pictures of a film. steps: how many there are"""

    def __init__(
        self, scene: Scene, steps: int, width: int, *, has_notes: bool
    ) -> None:
        self._steps = steps
        self._done: list[str] = []  # the colour of each step so far
        self._width = width
        self._is_narrow = width < NARROW
        self._size = FEW_LETTERS if self._is_narrow else LETTERS
        if width < TINY:
            self._size = 12
        self._row = 2 * self._size
        self._height = self._row * (2 if has_notes else 1) + 5
        side = grid_cell(scene)
        self._squares = (
            f"squares: {side:g} m" if side >= 1 else f"squares: {100 * side:g} cm"
        )

    def picture(
        self, i: int, reward: float, loses: bool, word: str, total: float, note: str
    ) -> Image.Image:
        """The bar of step i, counted from 0, after those before. word: what happened; total: of the rewards so far"""
        image = Image.new("RGB", (self._width, self._height), LIGHT["paper"])
        pen = ImageDraw.Draw(image)
        y = self._row / 2
        x: float = EDGE
        colour = colour_of(reward, loses)
        if colour == LIGHT["grey"]:
            colour = LIGHT["faint"]  # letters are darker
        pieces = [
            (f"step {i + 1}", True, "ink"),
            (f"of {self._steps}", False, "faint"),
            (signed(reward), True, colour),
            (word, True, colour),
        ]
        for text, bold, ink in pieces:
            font = letters(self._size, bold)
            pen.text((x, y), text, LIGHT.get(ink, ink), font, "lm")
            x += font.getlength(text) + 0.6 * self._size
        plain, strong = letters(self._size, False), letters(self._size, True)
        end: float = self._width - EDGE
        pen.text((end, y), signed(total), LIGHT["ink"], strong, "rm")
        end -= strong.getlength(signed(total)) + 0.4 * self._size
        pen.text((end, y), "so far", LIGHT["faint"], plain, "rm")
        end -= plain.getlength("so far") + self._size
        if not self._is_narrow and end - plain.getlength(self._squares) > x:
            pen.text((end, y), self._squares, LIGHT["faint"], plain, "rm")
        if note:
            pen.text((EDGE, 1.45 * self._row), note, LIGHT["faint"], plain, "lm")
        self._done.append(colour_of(reward, loses))
        bottom = self._height - 1
        pen.rectangle((0, bottom - 3, self._width, bottom), LIGHT["line"])
        for k, what in enumerate(self._done):
            start, end = (round(self._width * n / self._steps) for n in (k, k + 1))
            pen.rectangle((start, bottom - 3, end - 1, bottom), what)
        return image


@lru_cache
def letters(size: int, bold: bool) -> ImageFont.FreeTypeFont:
    """The letters of all pictures. size: [pixels]"""
    return ImageFont.truetype(font_file(bold), size)


def key_steps(
    scenes: Sequence[Scene], rewards: Sequence[float], most: int
) -> list[int]:
    """The steps, counted from 0, that tell most of a film.

    These are the first, the last, that of the largest reward where the title names it, those with which losses begin,
    and then those at which the robot is farthest from where it is in the others.
    """
    loses = losses(rewards)
    chosen = {0, len(scenes) - 1}
    best = best_step(scenes[0], rewards)
    if best is not None:
        chosen.add(best)
    for i, lost in enumerate(loses):
        begins = lost and not (i and loses[i - 1])
        if begins and len(chosen) < most:
            chosen.add(i)
    places = path_of(scenes)
    if len(places) < len(scenes):
        return sorted(chosen)  # in some there is no robot
    while len(chosen) < most:
        others = places[sorted(chosen)]
        apart = np.linalg.norm(places[:, None] - others, axis=2).min(axis=1)
        farthest = int(apart.argmax())
        if apart[farthest] == 0:
            break
        chosen.add(farthest)
    return sorted(chosen)
