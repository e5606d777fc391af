"""Images as small files: few colours, those of the palette exactly, so that no flat area changes its tone."""

import io
from collections.abc import Sequence
from typing import Any

from PIL import Image, ImageColor

from rlrobot_edu.show.palette import DARK, LIGHT

Colour = tuple[int, ...]  # red, green, blue

NEAR = 10  # of 255; a colour that is so near to one of the palette in red, green and blue is not stored beside it
FLAT = 2000  # a colour of more than this part of an image is that of a flat area
LEAST = 10  # pixels that a colour of the palette has where it is no accident
OWN = {ImageColor.getrgb(colour) for colour in [*LIGHT.values(), *DARK.values()]}


def image_of(png: bytes) -> Image.Image:
    """The image in a PNG file."""
    return Image.open(io.BytesIO(png)).convert("RGB")


def png_of(image: Image.Image) -> bytes:
    """An image as the smallest PNG file."""
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def gif_of(
    images: Sequence[Image.Image], colours: int, times: int | list[int]
) -> bytes:
    """Images as an animated GIF that plays for ever, in few colours; the same images give the same bytes.

    times: how long each image is shown [ms], or one number for all
    """
    # With one palette for all, what does not move keeps its colour, and only the changes are stored.
    chosen = few_colours(images, colours)
    first, *rest = (reduced(image, chosen) for image in images)
    buffer = io.BytesIO()
    first.save(
        buffer,
        "GIF",
        save_all=True,
        append_images=rest,
        loop=0,
        duration=times,
        optimize=True,
    )
    return buffer.getvalue()


def in_few_colours(image: Image.Image, colours: int) -> Image.Image:
    """The image in at most so many colours."""
    return reduced(image, few_colours([image], colours))


def few_colours(images: Sequence[Image.Image], colours: int) -> list[Colour]:
    """The colours to be used, at most so many.

    First those of the palette, then those of other flat areas, each as it is; the others by median cut of the last
    image.
    """
    seen: dict[Colour, int] = {}  # the most pixels that it has in an image
    for image in images:
        occurring: Any = image.getcolors(image.width * image.height)
        for count, colour in occurring:
            seen[colour] = max(seen.get(colour, 0), count)
    flat = image.width * image.height / FLAT
    own = [colour for colour in OWN if seen.get(colour, 0) >= LEAST]
    others = [colour for colour in seen if seen[colour] > flat and colour not in OWN]
    own.sort(key=lambda colour: -seen[colour])
    others.sort(key=lambda colour: -seen[colour])
    chosen: list[Colour] = []
    for colour in own + others:
        # of two that can hardly be told apart Pillow would take either
        if not any(_are_near(colour, taken) for taken in chosen):
            chosen.append(colour)
    chosen = chosen[: 3 * colours // 4]
    cut = images[-1].quantize(
        colours - len(chosen), Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE
    )
    mixed = cut.getpalette() or []
    for i in range(0, len(mixed), 3):
        colour = (mixed[i], mixed[i + 1], mixed[i + 2])
        if not any(_are_near(colour, own) for own in chosen):
            chosen.append(colour)
    return chosen[:colours]


def reduced(image: Image.Image, colours: Sequence[Colour]) -> Image.Image:
    """The image with each of its colours replaced by the nearest of these."""
    numbers = [part for colour in colours for part in colour]
    # Pillow takes what is left out for black: so the first colour fills it.
    filled = numbers + numbers[:3] * (256 - len(colours))
    palette = Image.new("P", (1, 1))
    palette.putpalette(filled)
    image = image.quantize(palette=palette, dither=Image.Dither.NONE)
    # What is free serves for what does not change from one image of a GIF to the next.
    image.putpalette(numbers)
    return image


def _are_near(a: Colour, b: Colour) -> bool:
    """Whether two colours can hardly be told apart."""
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) < NEAR
