"""What the figures of several lessons begin with: colours, a picture, a chart, curves, and rows with names."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from html import escape
from typing import Any, Literal, TypeVar

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from PIL import Image

from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.show.describe import describe, key_words
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film import COLOURS, KEY, Film
from rlrobot_edu.show.film_card import Reel, card
from rlrobot_edu.show.images import gif_of, image_of, in_few_colours, png_of
from rlrobot_edu.show.painting.room import ASPECT
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
from rlrobot_edu.show.story import caption, finding

__all__ = (
    "BLACK", "BLUE", "CURVES", "GREEN", "GREY", "ORANGE", "PURPLE", "RED", "ROLE", "SKY",
    "Picture", "SideBySide", "axes_or_new", "centred", "chart", "draw_arrow", "draw_curves", "draw_lattice",
    "draw_weight", "film_of", "in_panels", "legend_below", "name_rows", "plain",
)  # fmt: skip

ROW = 760  # width of films in a row [pixels of a page]

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
    """Two or three views in a row, each with its name; a saved notebook keeps their stills.

    Of films a page keeps one each, which run together; one that has ended waits for the others. A running notebook
    shows them in 3D if that is asked for: then each runs by itself, and can be turned and paused.
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
            captions = (_caption(name, film) for name, film in films.items())
            names = [ipywidgets.HTML(each) for each in captions]
        wide = {"flex": "1 1 300px"}
        columns = [
            ipywidgets.VBox([name, view.widget], layout=wide)
            for name, view in zip(names, self.views.values(), strict=True)
        ]
        return ipywidgets.HBox(columns, layout={"flex_flow": "row wrap"})

    def still(self) -> Still | None:
        """All in one picture; None for films, of which a page keeps one each."""
        if self._films():
            return None
        picture = Picture((min(4.2 * len(self.views), 9.5), 3.2), repr(self))
        for ax, name, view in in_panels(picture, self.views):
            ax.imshow(image_of(view.still().data))
            ax.set_title(plain(name))
            ax.set_axis_off()
        return picture.still()

    def _as_html(self) -> str:
        """Above each film its name and what became of it; a task that all have stands above all."""
        films = self._films()
        if not films:
            return super()._as_html()
        tasks = {film.task for film in films.values()}
        task = tasks.pop() if len(tasks) == 1 else ""
        longest = max(len(film.frames) for film in films.values())
        reels = []
        for name, film in films.items():
            above = "" if task else film.task
            said = finding(film.frames, film.rewards, above, film.rules)
            reels.append(_reel(name, film, said, ROW // len(films), longest))
        last = next(iter(films.values())).frames[-1]
        key = f"{KEY} {escape(key_words(last, '', []))}"
        return card(task, "", reels, key, ROW)

    def _can_turn(self) -> bool:
        """Whether all views can be shown in 3D here."""
        return all(view.widget is not None for view in self.views.values())

    def _films(self) -> dict[str, Film]:
        """The films by their names; none if a view is something else."""
        named = self.views.items()
        films = {name: view for name, view in named if isinstance(view, Film)}
        return films if len(films) == len(named) else {}


def _caption(name: str, film: Film) -> str:
    """The name of a film and what became of it."""
    return f"<strong>{escape(name)}</strong><br>{escape(film.finding)}"


def _reel(name: str, film: Film, said: str, width: int, steps: int) -> Reel:
    """A film on a card, so wide, that waits at its end until so many steps are over, and that end."""
    pictures = list(film.pictures(width))
    time = round(1000 * film.seconds_per_frame)
    waits = time * (steps - len(pictures))
    moving = film_of(film.told, pictures, COLOURS, time, waits)
    room = pictures[-1].crop((0, 0, width, round(width / ASPECT)))
    few = png_of(in_few_colours(room, COLOURS))
    end = Still(describe(film.frames[-1]), few, width)
    words = caption(film.frames, film.rewards, len(pictures) - 1)
    return Reel(moving, [(words, end)], name, said)


def film_of(
    said: str, shots: Sequence[Image.Image], colours: int, time: int, waits: int
) -> Still:
    """A moving picture. said: what it shows; time: of each shot [ms]; waits: how much longer the last one stays [ms]"""
    times = [time] * (len(shots) - 1) + [time + waits]
    moving = gif_of(shots, colours, times)
    return Still(said, moving, shots[0].width, "image/gif")
