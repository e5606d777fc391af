"""Figures with a description in words."""

import io
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.images import image_of, in_few_colours, png_of
from rlrobot_edu.show.style import DPI, dress, set_headline, styled

COLOURS = 128  # of a still

Size = tuple[float, float]  # width and height [inch]


class Picture(Displayed, Figure):
    """A matplotlib figure whose notebook output contains `alt`, a sentence for readers who cannot see it.

    figsize: width and height [inch]; settings: other arguments of a matplotlib Figure
    """

    def __init__(
        self, figsize: Size | None = None, alt: str = "A figure", **settings: Any
    ) -> None:
        with styled():
            super().__init__(figsize, **{"layout": "constrained", **settings})
        self.alt = alt
        self.finding = ""  # what stands above all charts

    def __repr__(self) -> str:
        return f"<Picture: {self.alt}>"

    def headline(self, finding: str, note: str = "") -> None:
        """Write the finding above all charts, and below it in grey what is plotted: quantity, how many, interval."""
        self.finding = finding
        set_headline(self, plain(finding), plain(note))

    def add_subplot(self, *args: Any, **settings: Any) -> Any:
        """As matplotlib's; the axes look as all of this project."""
        with styled():
            return super().add_subplot(*args, **settings)

    def colorbar(self, *args: Any, **settings: Any) -> Any:
        """As matplotlib's, without a frame."""
        with styled():
            bar = super().colorbar(*args, **settings)
        bar.outline.set_visible(False)
        return bar

    def draw(self, renderer: Any) -> None:
        """As matplotlib's; what is made when it is drawn, such as ticks, looks as all of this project."""
        with styled():
            dress(self)
            super().draw(renderer)

    def png(self, dpi: float = DPI) -> bytes:
        """The picture as a PNG file."""
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=dpi)
        return buffer.getvalue()

    def still(self) -> Still:
        """The picture and its sentence, as a notebook keeps them: in double resolution, but with few colours."""
        few = in_few_colours(image_of(self.png(2 * DPI)), COLOURS)
        width = round(DPI * self.get_figwidth())
        return Still(self.alt, png_of(few), width)


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


def set_title(ax: Axes, shown: Picture | Axes, title: str) -> None:
    """Write a title above what `axes_or_new` returned: a headline above a new picture, else the title of the axes."""
    if isinstance(shown, Picture):
        shown.headline(title)
    else:
        ax.set_title(plain(title))


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
