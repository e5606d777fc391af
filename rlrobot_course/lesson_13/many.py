"""Many arms: how many of them end badly."""

import textwrap
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from rlrobot_course.figures.plots import (
    BLUE,
    GREY,
    RED,
    Picture,
)
from rlrobot_course.figures.rows import ROBOTS, Rows, Values

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
