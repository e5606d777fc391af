"""Rows of robots: a dot for each robot, a line for the mean of its row, a band for the 95 % interval of the mean."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from matplotlib.transforms import blended_transform_factory
from scipy import stats

from rlrobot_course.figures.plots import BLUE, GREY, Picture, plain
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_edu.show.palette import BLACK, LIGHT
from rlrobot_edu.show.style import DPI

WIDTH = 7.6  # of a picture [inch]
DOT = 7  # pixels of a page from dot to dot
ROOM = 26  # pixels of a page above the dots of a row
LOWEST, HIGHEST = 58, 92  # pixels of a page: rows with few and with many dots
DRAWN = 520  # pixels of a page: about the width of the dots' axis
CHANCE = 0.05  # a smaller p is more than chance
ROBOTS = "a dot: one robot, line: their mean, band: its 95 % interval"

Values = Sequence[float] | np.ndarray


def heaped(values: np.ndarray, width: float) -> np.ndarray:
    """The heights of dots, 0 at the bottom, so that none lies on another.

    values: where they lie, sorted, array (n,); width: of a dot
    """
    ends: list[float] = []  # of each height, where its latest dot ends
    heights = []
    for value in values:
        free = [height for height, end in enumerate(ends) if value >= end]
        height = free[0] if free else len(ends)
        if not free:
            ends.append(value)
        ends[height] = value + width
        heights.append(height)
    return np.array(heights)


class Rows:
    """A picture with a row for each group, to be drawn on.

    groups: a number of each robot, by the name of the group; note: what the numbers are
    limits: of the axis; by default the smallest and the largest number; log: whether the axis is logarithmic
    hero: the group that is blue, if there is one; the others are grey
    """

    def __init__(
        self,
        groups: Mapping[str, Values],
        finding: str,
        note: str,
        *,
        limits: tuple[float, float] | None = None,
        log: bool = False,
        hero: str | None = None,
    ) -> None:
        self.groups = {name: np.sort(values) for name, values in groups.items()}
        self.log, self.hero = log, hero
        everything = np.concatenate(list(self.groups.values()))
        low, high = limits or (float(everything.min()), float(everything.max()))
        self.width = DOT / DRAWN * (self._place(high) - self._place(low) or 1.0)
        self.heights = {
            name: heaped(self._place(values), self.width)
            for name, values in self.groups.items()
        }
        highest = max(int(heights.max()) for heights in self.heights.values())
        self.row = min(max(DOT * (highest + 1) + ROOM, LOWEST), HIGHEST)
        self.step = min(DOT, (self.row - ROOM) / (highest + 1))  # from dot to dot
        n = len(self.groups)
        self.picture = Picture(figsize=(WIDTH, (self.row * n + 135) / DPI))
        self.picture.headline(finding, note)
        self.ax: Axes = self.picture.subplots()
        self.ax.set_yticks(range(n), [_in_lines(name) for name in self.groups])
        self.ax.set_ylim(n - 0.85, -0.95)
        self.ax.spines["bottom"].set_visible(False)
        if log:
            self.ax.set_xscale("log")
        for row, label in enumerate(self.ax.get_yticklabels()):
            is_hero = list(self.groups)[row] == hero
            label.set(va="bottom", linespacing=1.1, color=BLUE if is_hero else BLACK)
            self.ax.axhline(row, color=LIGHT["line"], linewidth=0.8, zorder=0)

    def _place(self, x: Any) -> Any:
        """Where a number lies along the axis."""
        return np.log10(x) if self.log else x

    def dots(self, name: str, colours: Any = None) -> None:
        """The dots of a group, in one colour or in one for each of its sorted numbers."""
        if colours is None:
            colours = BLUE if self.hero in (None, name) else GREY
        values, heights = self.groups[name], self.heights[name]
        y = self._row_of(name) - (self.step * heights + 4) / self.row
        self.ax.scatter(values, y, s=22, c=colours, linewidths=0, zorder=3)

    def mean(self, name: str, digits: int = 1, band: bool = True) -> str:
        """The mean of a group as a line with its number, and its interval as a band; returns both in words."""
        mean, half = mean_and_half(self.groups[name])
        row = self._row_of(name)
        colour = BLUE if self.hero in (None, name) else LIGHT["faint"]
        height = (self.row - 20) / self.row
        if band:
            corner = (mean - half, row - height)
            look = {"color": colour, "alpha": 0.16, "linewidth": 0, "zorder": 1}
            self.ax.add_patch(Rectangle(corner, 2 * half, height, **look))
        self.line(name, mean, f"{mean:.{digits}f}")
        return f"{mean:.1f} ± {half:.1f}"

    def line(self, name: str, x: float, text: str) -> None:
        """A line through the row of a group, and a text above it."""
        row, height = self._row_of(name), (self.row - 20) / self.row
        self.ax.plot([x, x], [row, row - height], color=BLACK, linewidth=2, zorder=4)
        self.ax.text(
            x,
            row - height - 1 / self.row,
            text.replace("-", "−"),
            ha="center",
            va="bottom",
            weight="bold",
            color=BLACK,
            zorder=5,
        )

    def beside(self, x: float, name: str, text: str, colour: str) -> None:
        """A text at the right of a group's row, in a column at x; 1 is the end of the axis."""
        across = blended_transform_factory(self.ax.transAxes, self.ax.transData)
        y = self._row_of(name) - 4 / self.row
        self.ax.text(x, y, text, transform=across, ha="right", color=colour, weight="bold", clip_on=False)  # fmt: skip

    def heading(self, x: float, text: str, colour: str) -> None:
        """A text above the column at x, in which `beside` writes."""
        self.ax.text(x, 1.0, text, transform=self.ax.transAxes, ha="right", va="bottom", color=colour)  # fmt: skip

    def mark(self, x: float, text: str) -> None:
        """A dotted line through all rows, and its name above them."""
        across = self.ax.get_xaxis_transform()
        self.ax.axvline(x, color=GREY, linestyle=":", linewidth=1.2, zorder=0)
        self.ax.text(x, 1.0, plain(text), transform=across, ha="center", va="bottom", color=LIGHT["faint"])  # fmt: skip

    def _row_of(self, name: str) -> int:
        return list(self.groups).index(name)


def _in_lines(name: str) -> str:
    """A long name in two lines."""
    return plain(name.replace(", ", ",\n", 1) if len(name) > 18 else name)


def plot_groups(
    groups: Mapping[str, Values],
    finding: str,
    what: str,
    when: str = "",
    hero: str | None = None,
) -> Picture:
    """A dot for each robot and the mean of each group. what: the numbers, with their unit; when: they were measured"""
    note = f"{what} {when}".strip()
    rows = Rows(groups, finding, f"{note}; {ROBOTS}", hero=hero)
    told = []
    for name in groups:
        rows.dots(name)
        told.append(f"{name}: {rows.mean(name)}")
    rows.picture.alt = (
        f"Dots, one an agent, {what}. Means with 95 % intervals: {'; '.join(told)}"
    )
    return rows.picture


def compared(groups: Mapping[str, Values], hero: str, rival: str) -> str:
    """Whether one group earns more than another, or whether that cannot be told: Welch's test."""
    mine, other = np.mean(groups[hero]), np.mean(groups[rival])
    p = stats.ttest_ind(groups[hero], groups[rival], equal_var=False).pvalue
    numbers = f"{mine:.1f} a step against {other:.1f}".replace("-", "−")
    if not p < CHANCE:
        return f"“{hero}” and “{rival}” are too close to tell: {numbers}"
    word = "more" if mine > other else "less"
    return f"“{hero}” earns {word} than “{rival}”: {numbers}"
