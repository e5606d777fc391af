"""Figures with a description in words."""

import io
from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

from rlrobot_edu.show.display import Displayed, Still

DPI = 90  # pixels of a page for an inch
SMALLEST = 8.5  # letters that can be read [point]
# How a few colours are chosen from many: this way is the truest to lines and letters.
FEW_COLOURS = Image.Quantize.MAXCOVERAGE

Size = tuple[float, float]  # width and height [inch]


class Picture(Displayed, Figure):
    """A matplotlib figure whose notebook output contains `alt`, a sentence for readers who cannot see it.

    figsize: width and height [inch]; settings: other arguments of a matplotlib Figure
    """

    def __init__(
        self, figsize: Size | None = None, alt: str = "A figure", **settings: Any
    ) -> None:
        super().__init__(figsize, **{"layout": "constrained", **settings})
        self.alt = alt

    def __repr__(self) -> str:
        return f"<Picture: {self.alt}>"

    def png(self, dpi: float = DPI) -> bytes:
        """The picture as a PNG file; letters that are too small to be read become larger."""
        for text in self.findobj(Text):
            text.set(fontsize=max(text.get_fontsize(), SMALLEST))
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=dpi)
        return buffer.getvalue()

    def still(self) -> Still:
        """The picture and its sentence, as a notebook keeps them: in double resolution, but with few colours."""
        fine = image_of(self.png(2 * DPI))
        few = fine.quantize(256, FEW_COLOURS, dither=Image.Dither.NONE)
        width = round(DPI * self.get_figwidth())
        return Still(self.alt, png_of(few), width)


def image_of(png: bytes) -> Image.Image:
    """The image in a PNG file."""
    return Image.open(io.BytesIO(png)).convert("RGB")


def gif_of(
    images: Sequence[Image.Image], colours: int, times: int | list[int]
) -> bytes:
    """Images as an animated GIF that plays for ever, in few colours; the same images give the same bytes.

    times: how long each image is shown [ms], or one number for all
    """
    # With one palette for all, what does not move keeps its colour, and only the changes are stored.
    palette = images[-1].quantize(colours, FEW_COLOURS)
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


def png_of(image: Image.Image) -> bytes:
    """An image as the smallest PNG file."""
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def plain(text: str) -> str:
    """Text from outside, changed so that matplotlib draws it letter by letter and a legend shows it.

    Between two $ matplotlib expects a formula, and a legend leaves out a name that begins with _.
    """
    signs = []
    for sign in str(text):
        can_be_drawn = sign.isprintable() or sign == "\n"
        signs.append(sign if can_be_drawn else " ")
    seen = "".join(signs)
    if seen.startswith("_"):
        seen = " " + seen
    return seen.replace("$", r"\$")


def axes_or_new(
    ax: Axes | None, alt: str, figsize: Size = (6.5, 4.2)
) -> tuple[Axes, Picture | Axes]:
    """The axes to plot on and what to return: twice `ax`, or without it the axes of a new picture and the picture."""
    if ax is not None:
        if not isinstance(ax, Axes):
            raise ValueError(
                f"ax must be axes of matplotlib, or None for a new picture; got {ax!r:.200}"
            )
        return ax, ax
    picture = Picture(figsize, alt)
    return picture.subplots(), picture
