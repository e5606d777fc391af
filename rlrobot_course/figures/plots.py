"""What the figures of several lessons begin with: colours, a picture, a chart, curves, and rows with names."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from html import escape
from typing import Any, Literal, TypeVar

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from PIL import Image

from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.show.describe import describe
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film import COLOURS, KEY, Film
from rlrobot_edu.show.film_card import card
from rlrobot_edu.show.images import gif_of, image_of, in_few_colours, png_of
from rlrobot_edu.show.palette import (
    BLACK,
    BLUE,
    CURVES,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    RED,
    ROLE,
    SKY,
)
from rlrobot_edu.show.picture import Picture, Size, axes_or_new, plain

__all__ = (
    "BLACK", "BLUE", "CURVES", "GREEN", "GREY", "ORANGE", "PURPLE", "RED", "ROLE", "SKY",
    "Picture", "SideBySide", "axes_or_new", "centred", "chart", "draw_arrow", "draw_curves", "draw_lattice",
    "draw_weight", "film_of", "in_panels", "legend_below", "name_rows", "plain",
)  # fmt: skip

ROW = 760  # width of films side by side [pixels of a page]
CAPTIONS = f"width: 100%; max-width: {ROW + 12}px; table-layout: fixed; margin: 0"
CAPTION = "font-size: 14px; text-align: left; vertical-align: top; white-space: normal"

Grid = Literal["both", "x", "y"]
Point = tuple[float, float]
K = TypeVar("K")
V = TypeVar("V")


def chart(
    size: Size,
    x: str,
    y: str,
    title: str,
    grid: Grid | None = "both",
    note: str = "",
) -> tuple[Picture, Axes]:
    """A picture with one chart in it, to be drawn on.

    size: width and height [inch]; x, y: what stands at the axes; title: the finding; grid: the axes with faint lines,
    if any; note: what is plotted, in grey below the title
    """
    picture = Picture(size)
    picture.headline(title, note)
    ax = picture.subplots()
    ax.set(xlabel=x, ylabel=y)
    if grid:
        ax.grid(axis=grid)
    return picture, ax


def draw_curves(
    ax: Axes, curves: Mapping[str, np.ndarray], width: float | None = None
) -> None:
    """A curve over the steps from 1 on for each label, told apart by colours and dashes. curves: arrays (n,)"""
    for (label, values), (colour, dashes) in zip(curves.items(), CURVES, strict=False):
        steps = np.arange(1, len(values) + 1)
        ax.plot(
            steps,
            values,
            color=colour,
            linestyle=dashes,
            linewidth=width,
            label=plain(label),
        )
    ax.margins(x=0)


def name_rows(ax: Axes, names: Sequence[str]) -> None:
    """Names at the rows 0, 1, 2 … of a chart, from top to bottom."""
    ax.set_yticks(range(len(names)), [plain(name) for name in names])
    ax.invert_yaxis()


def draw_lattice(ax: Axes, shape: tuple[int, int]) -> None:
    """The borders of cells in so many rows and columns, row 0 on top; the middle of each is at whole numbers."""
    rows, columns = shape
    ax.set(xlim=(-0.5, columns - 0.5), ylim=(rows - 0.5, -0.5), aspect="equal")
    ax.set_xticks(np.arange(columns) - 0.5, minor=True)
    ax.set_yticks(np.arange(rows) - 0.5, minor=True)
    ax.grid(which="minor", alpha=0.4)
    ax.tick_params(which="both", length=0)


def draw_arrow(ax: Axes, start: Point, end: Point, colour: str, width: float) -> Any:
    """An arrow that reaches from point to point; returns matplotlib's annotation."""
    look = {"arrowstyle": "-|>", "color": colour, "linewidth": width}
    return ax.annotate("", end, start, arrowprops={**look, "shrinkA": 0, "shrinkB": 0})


def draw_weight(ax: Axes, x: float, y: float, weight: float, most: float) -> None:
    """A cell around (x, y): blue above 0, else red, the stronger the more it is of `most`."""
    colour = BLUE if weight > 0 else RED
    opacity = 0.1 + 0.6 * np.sqrt(abs(weight) / most)
    corner = (x - 0.5, y - 0.5)
    ax.add_patch(Rectangle(corner, 1, 1, facecolor=colour, alpha=opacity))


def in_panels(
    figure: Picture, things: Mapping[K, V], **more: Any
) -> Iterator[tuple[Axes, K, V]]:
    """The axes, the name and the thing for each of the things, side by side; more: as of matplotlib's subplots."""
    axes = figure.subplots(1, len(things), squeeze=False, **more)[0]
    for ax, (name, thing) in zip(axes, things.items(), strict=True):
        yield ax, name, thing


def centred(ax: Axes, x: float, y: float, text: str, **look: Any) -> None:
    """Write a text whose middle is at (x, y); look: as of matplotlib's texts."""
    ax.text(x, y, text, ha="center", va="center", **look)


def legend_below(figure: Picture, columns: int, **more: Any) -> None:
    """The legend of a picture, below its charts, where it hides no curve; more: as of matplotlib's legends."""
    figure.legend(loc="outside lower center", ncols=columns, **more)


class SideBySide(Displayed):
    """Two or three views in a row, each with its name; a saved notebook keeps their stills in one picture.

    Films run side by side, step by step; one that has ended waits for the others. A running notebook shows them in 3D
    if that is asked for: then each runs by itself, and can be turned and paused.
    """

    def __init__(self, views: Mapping[str, Displayed], in3d: bool = False) -> None:
        self.views = views
        self.in3d = in3d

    def __repr__(self) -> str:
        return "; ".join(f"{name}: {view!r}" for name, view in self.views.items())

    @cached_property
    def widget(self) -> ipywidgets.HBox | None:
        """The views of a running notebook; None for films but in 3D, for pictures need no kernel."""
        films = self._films()
        if films and not (self.in3d and self._can_turn()):
            return None
        names = [ipywidgets.Label(name) for name in self.views]
        if films:
            names = [ipywidgets.HTML(_caption(film)) for film in films]
        wide = {"flex": "1 1 300px"}
        columns = [
            ipywidgets.VBox([name, view.widget], layout=wide)
            for name, view in zip(names, self.views.values(), strict=True)
        ]
        return ipywidgets.HBox(columns, layout={"flex_flow": "row wrap"})

    def still(self) -> Still:
        """All in one picture, a moving one of films."""
        films = self._films()
        if films:
            told = (
                f"{film.notes[0]}: {film.finding}. At the end: {describe(film.frames[-1])}"
                for film in films
            )
            alt = f"Films of robots, side by side. {' '.join(told)}"
            time = round(1000 * films[0].seconds_per_frame)
            return Still(alt, gif_of(self._rows, COLOURS, time), ROW, "image/gif")
        picture = Picture((min(4.2 * len(self.views), 9.5), 3.2), repr(self))
        for ax, name, view in in_panels(picture, self.views):
            ax.imshow(image_of(view.still().data))
            ax.set_title(plain(name))
            ax.set_axis_off()
        return picture.still()

    def _as_html(self) -> str:
        """Above each film its name and what became of it, in letters that stay as large on a narrow page."""
        films = self._films()
        if not films:
            return super()._as_html()
        cells = (f'<td style="{CAPTION}">{_caption(film)}</td>' for film in films)
        captions = f'<table style="{CAPTIONS}"><tr>{"".join(cells)}</tr></table>'
        words = f"{captions}<small>{KEY}</small>"
        said = (f"{film.notes[0]}: {describe(film.frames[-1])}" for film in films)
        last = png_of(in_few_colours(self._rows[-1], COLOURS))
        ends = Still(f"At the end: {'; '.join(said)}", last, ROW)
        return card(words, self.still().html, ends.html, ROW)

    @cached_property
    def _rows(self) -> list[Image.Image]:
        """The pictures of the films' steps, side by side."""
        return side_by_side(self._films())

    def _can_turn(self) -> bool:
        """Whether all views can be shown in 3D here."""
        return all(view.widget is not None for view in self.views.values())

    def _films(self) -> list[Film]:
        """The films, each with its name in its captions; none if a view is something else."""
        named = self.views.items()
        films = [
            replace(view, notes=[name] * len(view.frames))
            for name, view in named
            if isinstance(view, Film)
        ]
        return films if len(films) == len(named) else []


def _caption(film: Film) -> str:
    """The name of a film and what became of it."""
    return f"<strong>{escape(film.notes[0])}</strong><br>{escape(film.finding)}"


def side_by_side(films: Sequence[Film]) -> list[Image.Image]:
    """The pictures of several films in a row, step by step; one that has ended waits for the others."""
    each = ROW // len(films)
    columns = [list(film.pictures(each)) for film in films]
    frames = []
    for i in range(max(map(len, columns))):
        frame = Image.new("RGB", (each * len(columns), columns[0][0].height))
        for column, pictures in enumerate(columns):
            picture = pictures[min(i, len(pictures) - 1)]
            frame.paste(picture, (column * each, 0))
        frames.append(frame)
    return frames


def film_of(said: str, shots: Sequence[Image.Image], colours: int, time: int) -> Still:
    """A moving picture of several figures; each stays for a time [ms], the last one for 3 s. said: what it shows."""
    times = [time] * (len(shots) - 1) + [3000]
    moving = gif_of(shots, colours, times)
    return Still(said.strip("<>"), moving, shots[0].width, "image/gif")
