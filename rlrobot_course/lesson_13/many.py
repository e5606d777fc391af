"""Many arms: how many end badly, and which method is ahead with which reward."""

import textwrap
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    RED,
    Picture,
    centred,
    in_panels,
)
from rlrobot_course.figures.rows import ROBOTS, Rows, Values, heaped
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_edu.experiments.statistics import Tukey
from rlrobot_edu.show.palette import LIGHT

CHANCE = 0.05  # a smaller p is more than chance
DOT = 0.034  # of the width of a panel
COUNTS = ((0.89, RED), (1.0, BLUE))  # where the two counts stand, and their colours


class Bounds(NamedTuple):
    """Which arms are stuck and which are good: below `stuck`, and from `good` on; each with its name in words."""

    stuck: float
    stuck_name: str
    good: float
    good_name: str


def stuck_first(groups: Mapping[str, Values], bounds: Bounds) -> list[str]:
    """The names of the groups, most stuck arms first; of equals that with the smaller mean."""

    def order(name: str) -> tuple[int, float]:
        values = np.asarray(groups[name])
        return -int((values < bounds.stuck).sum()), float(values.mean())

    return sorted(groups, key=order)


def stuck_finding(groups: Mapping[str, Values], bounds: Bounds) -> str:
    """In which group most arms are stuck, and in which none is."""
    worst, *_ = stuck_first(groups, bounds)
    stuck = {
        name: int((np.asarray(values) < bounds.stuck).sum())
        for name, values in groups.items()
    }
    none = [name for name in groups if not stuck[name]]
    if worst in none:
        return f"No arm is {bounds.stuck_name}"
    said = f"{stuck[worst]} of {len(groups[worst])} arms are {bounds.stuck_name} with “{worst}”"
    methods = {name.partition(",")[0] for name in none}
    others = {name.partition(",")[0] for name in groups if name not in none}
    if not none:
        return f"{said}; in each row some are"
    if len(none) == len(groups) - 1 > 1:
        return f"{said}; with the others none is"
    if len(methods) == 1 and not methods & others:
        return f"{said}; with “{methods.pop()}” none is"
    return f"{said}; in {len(none)} of the {len(groups)} rows none is"


def plot_many(
    groups: Mapping[str, Values],
    what: str,
    bounds: Bounds,
    marks: Mapping[float, str] | None = None,
) -> Picture:
    """One row a group, sorted by how many arms are stuck; one dot an arm.

    groups: a value for each arm by the group's name; what: the values, with their unit
    marks: values to compare with, and their names
    """
    order = stuck_first(groups, bounds)
    finding = stuck_finding(groups, bounds)
    robots = ROBOTS.replace("robot", "arm")
    rows = Rows({name: groups[name] for name in order}, finding, f"{what}; {robots}")
    everything = np.concatenate(list(rows.groups.values()))
    low, high = min(0.0, everything.min()), everything.max()
    told = []
    for name, values in rows.groups.items():
        is_stuck, is_good = values < bounds.stuck, values >= bounds.good
        rows.dots(name, np.where(is_stuck, RED, np.where(is_good, BLUE, GREY)))
        rows.mean(name, digits=2 if values.max() <= 1 else 1)
        for count, (x, colour) in zip((is_stuck, is_good), COUNTS, strict=True):
            rows.beside(x, name, str(count.sum()), colour)
        near = [f"{np.sum(np.abs(values - m) < 0.25)} near {m:g}" for m in marks or {}]
        reach = f"{len(values)} arms from {min(values):.2f} to {max(values):.2f}"
        told.append(
            f"{name}: {', '.join([reach, '; '.join(near)] if near else [reach])}"
        )
    # room for the counts, beyond the largest value
    ticks = [tick for tick in rows.ax.get_xticks() if low <= tick <= 1.03 * high]
    rows.ax.set_xticks(ticks)
    rows.ax.set_xlim(low - 0.03 * (high - low), high + 0.22 * (high - low))
    for name, (x, colour) in zip(
        (bounds.stuck_name, bounds.good_name), COUNTS, strict=True
    ):
        rows.heading(x, textwrap.fill(name, 8), colour)
    for mark, text in (marks or {}).items():
        rows.mark(mark, text)
    rows.picture.alt = f"{finding}. One dot an arm. {'. '.join(told)}."
    return rows.picture


def leads(groups: Mapping[str, np.ndarray], method: str) -> bool:
    """Whether a method earns more than each of the others, and more than chance explains: Tukey's test."""
    ahead = 0
    for pair in Tukey.of(groups).pairs:
        if method not in (pair.first, pair.second) or pair.p >= CHANCE:
            continue
        better = pair.first if pair.difference > 0 else pair.second
        ahead += better == method
    return ahead == len(groups) - 1


def leader_finding(groups: Mapping[str, Mapping[str, np.ndarray]]) -> str:
    """Who is ahead of all others in the first set-up, and in which others that method is not."""
    first, *others = groups
    means = {method: values.mean() for method, values in groups[first].items()}
    best = max(means, key=means.__getitem__)
    if not leads(groups[first], best):
        return f"In “{first}” no method clearly earns most"
    gone = [name for name in others if not leads(groups[name], best)]
    if gone:
        return f"{best} is ahead of all others in “{first}”, not in “{'” and “'.join(gone)}”"
    return f"{best} is ahead of all others in “{'” and “'.join(groups)}”"


def plot_means(
    groups: Mapping[str, Mapping[str, np.ndarray]],
    what: str,
    limits: tuple[float, float],
) -> Picture:
    """A panel for each set-up, in it a row for each method. groups: values of arms by method, by set-up

    what: the values, with their unit; limits: the least and the most that they can be
    """
    figure = Picture(figsize=(8.4, 4.3))
    note = f"{what}; {ROBOTS.replace('robot', 'arm')}"
    figure.headline(leader_finding(groups), note)
    told: dict[str, list[str]] = {}
    for ax, name, methods in in_panels(figure, groups, sharey=True):
        ax.set_title(name, weight="bold")
        for row, (method, values) in enumerate(methods.items()):
            said = _row(ax, row, np.sort(values), DOT * (limits[1] - limits[0]))
            told.setdefault(method, []).append(f"{name} {said}")
        ax.set(xlim=limits, ylim=(len(methods) - 0.85, -0.95))
        ax.set_yticks(range(len(methods)), list(methods))
        ax.spines["bottom"].set_visible(False)
    each = [f"{method}: {', '.join(said)}" for method, said in told.items()]
    figure.alt = f"{figure.finding}. {'. '.join(each)}."
    return figure


def _row(ax: Axes, row: int, values: np.ndarray, width: float) -> str:
    """Arms as dots above a line, their mean and its interval; returns the mean in words. width: of a dot"""
    heights = heaped(values, width)
    step = min(0.07, 0.6 / (heights.max() + 1))
    mean, half = mean_and_half(values)
    ax.axhline(row, color=LIGHT["line"], linewidth=0.8, zorder=0)
    corner = (mean - half, row - 0.66)
    ax.add_patch(Rectangle(corner, 2 * half, 0.66, color=BLUE, alpha=0.16, linewidth=0))
    ax.scatter(
        values, row - 0.05 - step * heights, s=12, c=BLUE, linewidths=0, zorder=3
    )
    ax.plot([mean, mean], [row, row - 0.66], color=BLACK, linewidth=2, zorder=4)
    centred(ax, mean, row - 0.76, f"{mean:.1f}", weight="bold")
    return f"{mean:.2f} ± {half:.2f}"
