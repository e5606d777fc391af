"""The figure of docs/studies/transfer.md: average rewards with and without a transfer, from the tables of the page."""

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from matplotlib.axes import Axes

from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.palette import BLUE, GREY, PURPLE, RED, Dashes
from rlrobot_edu.show.picture import Picture

# By the name of a way in the tables: its name in the figure, its colour and its dashes
LOOKS: dict[str, tuple[str, str, Dashes]] = {
    "from scratch": ("scratch", GREY, "--"),
    "carried over": ("carried", BLUE, "-"),
    "carried over, halved": ("halved", PURPLE, "-."),
    "number for number": ("numbers", RED, ":"),
}
PLAIN = "carried over"
CELL = re.compile(r"([-\d.]+) ± ([\d.]+)(.*)")


class Mean(NamedTuple):
    """The average reward over the first steps, half of its 95 % interval, and whether it differs from scratch."""

    steps: int
    mean: float
    half: float
    is_significant: bool


# By the name of a carry, by the name of a way
Carries = Mapping[str, Mapping[str, Sequence[Mean]]]


def carries_of(page: str) -> dict[str, dict[str, list[Mean]]]:
    """The tables of the page."""
    found = {}
    for name, table in re.findall(r"^\*\*(.+)\*\*\n\n((?:\|.*\n)+)", page, re.M):
        head, _, *rows = table.splitlines()
        horizons = [int(steps) for steps in re.findall(r"first (\d+) steps", head)]
        found[name] = {}
        for row in rows:
            way, *cells = row.strip("| ").split(" | ")
            found[name][way] = [
                _mean_of(steps, cell)
                for steps, cell in zip(horizons, cells, strict=True)
            ]
    return found


def _mean_of(steps: int, cell: str) -> Mean:
    read = CELL.fullmatch(cell)
    if read is None:
        raise ValueError(f"the page has a cell without a mean: {cell}")
    mean, half, test = read.groups()
    return Mean(steps, float(mean), float(half), "(significant)" in test)


def title_of(carries: Carries) -> str:
    """From where to where the plain transfer gains something significant, and from where not."""
    gains, others = [], []
    for name, ways in carries.items():
        pairs = zip(ways[PLAIN], ways["from scratch"], strict=True)
        is_gain = [its.is_significant and its.mean > alone.mean for its, alone in pairs]
        (gains if any(is_gain) else others).append(name)
    said = f"What was carried over helps: {' and '.join(gains) or 'nowhere'}"
    if others:
        said += f"; not shown: {' and '.join(others)}"
    return said


def figure(page: str, names: Sequence[str]) -> Picture:
    """Average rewards of the first steps, one chart a carry.

    page: its Markdown; names: of the carries that are drawn
    """
    found = carries_of(page)
    carries = {name: found[name] for name in names}
    picture = Picture((8.4, 7.4))
    note = (
        "Average reward a step, mean of 20 agents, bars: 95 % intervals. Filled: significantly other than from "
        "scratch. Halved: all Q times ½. Numbers: number for number."
    )
    picture.headline(title_of(carries), note)
    axes = picture.subplots(2, 2).flat
    told = []
    for ax, (name, ways) in zip(axes, carries.items(), strict=True):
        _draw(ax, ways)
        ax.set_title(name)
        ends = ", ".join(f"{way} {means[-1].mean:.2f}" for way, means in ways.items())
        told.append(f"{name} ends at: {ends}")
    picture.alt = f"{title_of(carries)}. {'; '.join(told)}."
    for ax, ways in zip(picture.axes, carries.values(), strict=True):
        ends = [End(ways[way][-1].mean, *LOOKS[way][:2]) for way in ways]
        name_ends(ax, ends)
    return picture


def _draw(ax: Axes, ways: Mapping[str, Sequence[Mean]]) -> None:
    for i, (way, means) in enumerate(ways.items()):
        _, colour, dashes = LOOKS[way]
        x = [its.steps * 1.04**i for its in means]  # so that no bar hides another
        y = [its.mean for its in means]
        ax.plot(x, y, color=colour, linestyle=dashes, linewidth=1.6)
        for at, its in zip(x, means, strict=True):
            fill = colour if its.is_significant else "white"
            ax.errorbar(at, its.mean, its.half, fmt="o", color=colour, markerfacecolor=fill, linewidth=1.4)  # fmt: skip
    steps = [its.steps for its in means]
    ax.set_xscale("log")
    ax.set_xticks(steps, [f"{n:,}" for n in steps])
    ax.minorticks_off()
    ax.set_xlabel("first … steps")
    ax.grid(axis="y")
