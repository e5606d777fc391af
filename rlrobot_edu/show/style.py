"""How a figure of this project looks. Only a `Picture` looks so: a learner's own figures keep matplotlib's settings."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib import font_manager
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.legend import Legend
from matplotlib.rcsetup import cycler
from matplotlib.text import Text

from rlrobot_edu.show.palette import BLUES, CURVES, LIGHT, WORTH

DPI = 90  # pixels of a page for an inch
POINT = DPI / 72  # pixels of a page
LETTERS = 14 / POINT  # [point]; 14 pixels of a page
HEADLINE = 18 / POINT
SMALLEST = 12 / POINT  # letters that can be read, also at half the size
EDGE = 8  # pixels of a page round a figure
NOTES_AFTER = 3  # pixels of a page between the headline and the note below it

FOLDER = Path(__file__).with_name("fonts")
for file in sorted(FOLDER.glob("*.ttf")):
    font_manager.fontManager.addfont(file)
# Where the first has no such sign (↗ ● ⟶), matplotlib takes it from the second.
FONTS = ["Source Sans Pro", "DejaVu Sans"]

SHADES_OF_WORTH = LinearSegmentedColormap.from_list("worth", WORTH)
SHADES_OF_BLUE = LinearSegmentedColormap.from_list("blue", BLUES)
DARK_FROM = 0.55  # of the shades of worth; letters on darker ones are white

SETTINGS: Any = {
    "font.family": FONTS,
    "font.size": LETTERS,
    "axes.titlesize": LETTERS,
    "axes.labelsize": LETTERS,
    "xtick.labelsize": LETTERS,
    "ytick.labelsize": LETTERS,
    "legend.fontsize": LETTERS,
    "legend.title_fontsize": LETTERS,
    "text.color": LIGHT["ink"],
    "axes.labelcolor": LIGHT["faint"],
    "xtick.labelcolor": LIGHT["faint"],
    "ytick.labelcolor": LIGHT["faint"],
    "xtick.color": LIGHT["line"],
    "ytick.color": LIGHT["line"],
    "ytick.major.size": 0,
    "axes.edgecolor": LIGHT["grey"],
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.spines.left": False,
    "axes.axisbelow": True,
    "grid.color": LIGHT["line"],
    "grid.linewidth": 0.8,
    "lines.linewidth": 2.2,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "hatch.linewidth": 0.7,
    "figure.facecolor": LIGHT["paper"],
    "axes.facecolor": LIGHT["paper"],
    "savefig.facecolor": LIGHT["paper"],
    "axes.prop_cycle": cycler(color=[colour for colour, _ in CURVES]),
}


def font_file(bold: bool) -> Path:
    """The file of the letters that all pictures have."""
    return FOLDER / f"SourceSansPro-{'Bold' if bold else 'Regular'}.ttf"


def styled() -> Any:
    """Within `with styled():` whatever matplotlib makes looks as this project's figures do."""
    return mpl.rc_context(SETTINGS)


def dress(figure: Figure) -> None:
    """Give the letters of a figure their font and a size that can be read; a panel's name stands at its left edge.

    Texts take matplotlib's font when they are made, wherever that is: so all are dressed when the figure is drawn.
    """
    for text in figure.findobj(Text):
        if text.get_fontfamily() != ["monospace"]:
            text.set_fontfamily(FONTS)
        text.set_fontsize(max(text.get_fontsize(), SMALLEST))
        if text.get_color() == "black":
            text.set_color(LIGHT["ink"])
    for ax in figure.axes:
        ax.title.set(x=0, ha="left")
    for legend in figure.findobj(Legend):
        legend.set_frame_on(False)


def set_headline(figure: Figure, finding: str, note: str = "") -> None:
    """Write the finding above a figure, in bold, and in grey below it what is plotted; both as wide as the figure."""
    width, height = figure.get_size_inches() * DPI
    room = width - 2 * EDGE
    y: float = EDGE
    looks = [(finding, HEADLINE, "bold", "ink"), (note, LETTERS, "normal", "faint")]
    for text, size, weight, colour in looks:
        if not text:
            continue
        written = figure.text(
            EDGE / width,
            1 - y / height,
            "",
            fontfamily=FONTS,
            fontsize=size,
            weight=weight,
            color=LIGHT[colour],
            va="top",
            linespacing=1.2,
        )
        lines = wrapped(figure, written, text, room)
        written.set_text("\n".join(lines))
        y += 1.25 * size * POINT * len(lines) + NOTES_AFTER
    engine = figure.get_layout_engine()
    if isinstance(engine, ConstrainedLayoutEngine):
        engine.set(rect=(0.0, 0.0, 1.0, 1 - y / height))


def wrapped(figure: Figure, written: Text, text: str, room: float) -> list[str]:
    """The lines of a text that are at most so wide [pixels of a page], in the font of `written`."""
    canvas: Any = FigureCanvasAgg(figure)  # its methods have no types
    renderer = canvas.get_renderer()
    pixels = DPI / figure.dpi
    lines: list[str] = []
    for paragraph in text.split("\n"):
        line = ""
        for word in paragraph.split():
            longer = f"{line} {word}".strip()
            written.set_text(longer)
            fits = written.get_window_extent(renderer).width * pixels <= room
            if line and not fits:
                lines.append(line)
                longer = word
            line = longer
        lines.append(line)
    return lines
