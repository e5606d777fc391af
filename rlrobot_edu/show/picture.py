"""Figures that also say in words what they show."""

import io
from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

from rlrobot_edu.show.display import Displayed, Still

DPI, SMALLEST = (
    90,
    8.5,
)  # pixels of a page for an inch, and size of letters that can be read [point]
FEW_COLOURS = (
    Image.Quantize.MAXCOVERAGE
)  # of the ways to choose them, the truest to lines and letters


Size = tuple[float, float]  # width and height [inch]


class Picture(Displayed, Figure):
    """A matplotlib figure whose notebook output carries `alt`, a sentence for readers who cannot see it.

    figsize: width and height [inch]; settings: what else a matplotlib Figure takes
    """

    def __init__(
        self, figsize: Size | None = None, alt: str = "A figure", **settings: Any
    ) -> None:
        super().__init__(figsize, **{"layout": "constrained", **settings})
        self.alt = alt

    def __repr__(self) -> str:
        return f"<Picture: {self.alt}>"

    def png(self, dpi: float = DPI) -> bytes:
        """The picture as a PNG file, with no letters that are too small to be read."""
        for text in self.findobj(Text):
            text.set(fontsize=max(text.get_fontsize(), SMALLEST))
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=dpi)
        return buffer.getvalue()

    def still(self) -> Still:
        """The picture and its sentence, as a notebook keeps them: sharp on fine screens, and small by few colours."""
        fine = image_of(self.png(2 * DPI))
        few = fine.quantize(256, FEW_COLOURS, dither=Image.Dither.NONE)
        return Still(self.alt, png_of(few), round(DPI * self.get_figwidth()))


def image_of(png: bytes) -> Image.Image:
    """The image in a PNG file."""
    return Image.open(io.BytesIO(png)).convert("RGB")


def gif_of(
    images: Sequence[Image.Image], colours: int, times: int | list[int]
) -> bytes:
    """Images as an animated GIF that plays for ever, in few colours; the same images give the same bytes.

    times: how long each stays [ms], or one number for all
    """
    # one palette for all: what did not move keeps its colour, so only the changes are stored
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
    """An image as a PNG file, packed as small as can be."""
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def plain(text: str) -> str:
    """Text from outside as matplotlib is to get it, so that it draws the text as it stands, and a legend shows it.

    Two $ would make a formula of what is between them; a legend leaves out what begins with _.
    """
    seen = "".join(
        sign if sign.isprintable() or sign == "\n" else " " for sign in str(text)
    )
    return " " * seen.startswith("_") + seen.replace("$", r"\$")


def axes_or_new(
    ax: Axes | None, alt: str, figsize: Size = (6.5, 4.2)
) -> tuple[Axes, Picture | Axes]:
    """Where to plot and what to return: `ax` itself for both, or without one the axes of a new picture, and that."""
    if ax is not None:
        if not isinstance(ax, Axes):
            raise ValueError(
                f"ax must be axes of matplotlib, or None for a new picture; got {ax!r:.200}"
            )
        return ax, ax
    picture = Picture(figsize, alt)
    return picture.subplots(), picture
