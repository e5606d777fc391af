"""Images as small files: few colours, those of the palette exactly, so that no flat area changes its tone."""

import io
from collections.abc import Sequence

from PIL import Image, ImageColor

from rlrobot_edu.show.palette import DARK, LIGHT

NEAR = 10  # of 255; a colour that is so near to one of the palette in red, green and blue is not stored beside it
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
    palette = few_colours(images[-1], colours)
    first, *rest = (
        image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images
    )
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
    palette = few_colours(image, colours)
    return image.quantize(palette=palette, dither=Image.Dither.NONE)


def few_colours(image: Image.Image, colours: int) -> Image.Image:
    """An image that holds the colours to be used: those of the palette that occur, the others by median cut."""
    occurring = image.getcolors(image.width * image.height) or []
    chosen = [colour for _, colour in sorted(occurring, reverse=True) if colour in OWN]
    chosen = chosen[: colours // 2]
    cut = image.quantize(
        colours - len(chosen), Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE
    )
    flat = cut.getpalette() or []
    for i in range(0, len(flat), 3):
        colour = (flat[i], flat[i + 1], flat[i + 2])
        if not any(_are_near(colour, own) for own in chosen):
            chosen.append(colour)
    used = chosen[:256]
    # Pillow takes what is left out for black.
    filled = used + used[:1] * (256 - len(used))
    palette = Image.new("P", (1, 1))
    palette.putpalette([part for colour in filled for part in colour])
    return palette


def _are_near(a: tuple[int, ...], b: tuple[int, ...]) -> bool:
    """Whether two colours can hardly be told apart."""
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) < NEAR
