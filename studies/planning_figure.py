"""The figure of docs/studies/planning.md: what a planner changes, drawn from the tables of the page."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from matplotlib.axes import Axes

from rlrobot_course.figures.plots import name_rows
from rlrobot_edu.show.palette import BLUE, GREY, LIGHT, RED
from rlrobot_edu.show.picture import Picture

PLANNERS = {"dyna": "o", "sweeping": "s"}  # the mark of each
ROW = re.compile(r"^\| ([^|]*) \| ([\w+]+) \| ([-\d.]+) \| (.*) \| (.*) \|$", re.M)
CELL = re.compile(r"(\**)([-\d.]+) \(p ([<=]) ([\d.]+)\)\**")


class Gain(NamedTuple):
    """What a planner changes: the means without and with it, the corrected p (0: below 0.001), and the cell's stars."""

    steps: int
    world: str
    method: str
    planner: str
    without: float
    mean: float
    p: float
    stars: str

    @property
    def sign(self) -> int:
        """1: significantly better, -1: significantly worse, 0: not significant."""
        if self.p >= 0.05:
            return 0
        return 1 if self.mean > self.without else -1


def gains_of(page: str) -> list[Gain]:
    """The cells of both tables of the page."""
    found = []
    parts = re.split(r"## After .* steps\n", page)[1:]
    for steps, part in zip((300, 3600), parts, strict=True):
        world = ""
        for name, method, without, *cells in ROW.findall(part.split("##")[0]):
            world = name.strip() or world
            for planner, cell in zip(PLANNERS, cells, strict=True):
                read = CELL.fullmatch(cell)
                if read is None:
                    raise ValueError(f"the page has a cell without a p: {cell}")
                stars, mean, relation, p = read.groups()
                its_p = 0.0 if relation == "<" else float(p)
                numbers = float(without), float(mean), its_p
                found.append(Gain(steps, world, method, planner, *numbers, stars))
    return found


def title_of(gains: Sequence[Gain]) -> str:
    """How often a planner helps, and how often it harms."""
    signs = [gain.sign for gain in gains]
    return (
        f"A planner helps significantly in {signs.count(1)} of {len(signs)} cases, and harms in {signs.count(-1)}: it"
        " depends on the world"
    )


def figure(page: str) -> Picture:
    """What each planner changes, a row for each world and method, a column for 300 and for 3600 steps."""
    gains = gains_of(page)
    note = (
        "Mean reward a step with a planner, less that without. Circle: dyna, square: sweeping. Blue: significantly "
        "better, red: significantly worse (Holm), hollow: not significant."
    )
    rows = list(dict.fromkeys((gain.world, gain.method) for gain in gains))
    picture = Picture((8.4, 1.6 + 0.27 * len(rows)))
    picture.headline(title_of(gains), note)
    axes = picture.subplots(1, 2, sharey=True)
    titles = {300: "in the first 300 steps", 3600: "after 3600 steps"}
    for ax, (steps, title) in zip(axes, titles.items(), strict=True):
        ax.set_title(title)
        _draw(ax, [gain for gain in gains if gain.steps == steps], rows)
    names = []
    for i, (world, method) in enumerate(rows):
        is_first = i == 0 or rows[i - 1][0] != world
        names.append(f"{world}:  {method}" if is_first else method)
    name_rows(axes[0], names)
    picture.alt = f"{title_of(gains)}. What a planner changes, a row a world and method; the numbers of both tables."
    return picture


def _draw(ax: Axes, gains: Sequence[Gain], rows: Sequence[tuple[str, str]]) -> None:
    ax.axvline(0, color=GREY, linewidth=1)
    colours = {1: BLUE, -1: RED, 0: LIGHT["faint"]}
    for gain in gains:
        colour = colours[gain.sign]
        y = rows.index((gain.world, gain.method))
        ax.plot(
            gain.mean - gain.without, y, PLANNERS[gain.planner], color=colour, markersize=7,
            markerfacecolor=colour if gain.sign else "white", alpha=0.9,
        )  # fmt: skip
    for y in range(1, len(rows)):
        if rows[y][0] != rows[y - 1][0]:
            ax.axhline(y - 0.5, color=LIGHT["line"], linewidth=0.8)
    ax.grid(axis="x")
