"""The figures of lesson 20: what became of agents that were taught."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLUE,
    CURVES,
    RED,
    Picture,
    chart,
    legend_below,
    name_rows,
    plain,
)
from rlrobot_course.figures.runs import mean_and_half

MARKS = "osD^vPX"  # of the groups, beside their colours


def plot_dots(
    groups: Mapping[str, Sequence[float] | np.ndarray], title: str, what: str
) -> Picture:
    """One dot an agent, and the mean of each group with its 95 % interval.

    groups: a number for each agent, by the name of the group; what: the numbers, with their unit, for the axis
    """
    figure, ax = chart((7, 1.3 + 0.55 * len(groups)), what, "", title, grid="x")
    told = []
    for row, (values, mark) in enumerate(zip(groups.values(), MARKS, strict=False)):
        mean, half = mean_and_half(values)
        ax.plot(
            np.sort(values),
            row + np.linspace(-0.15, 0.15, len(values)),
            mark,
            color=BLUE,
            alpha=0.5,
            markersize=5,
        )
        ax.errorbar(
            mean,
            row,
            xerr=half,
            fmt="|",
            color=RED,
            markersize=20,
            markeredgewidth=2,
            capsize=5,
        )
        told.append(f"{mean:.1f} ± {half:.1f}")
    name_rows(ax, list(groups))
    ax.set_ylim(len(groups) - 0.5, -0.5)
    ax.errorbar(
        [],
        [],
        xerr=[],
        fmt="|",
        color=RED,
        markersize=12,
        capsize=5,
        label="mean, 95 % interval",
    )
    figure.legend(loc="outside lower right")
    figure.alt = f"Dots, one an agent, {what}. Means with 95 % intervals: " + "; ".join(
        f"{name} {numbers}" for name, numbers in zip(groups, told, strict=True)
    )
    return figure


def plot_worth(worth: Mapping[str, Mapping[str, float]], title: str) -> Picture:
    """What pupils learned of teachers: bars of the mean Q of the lesson's pairs, by teacher and pupil."""
    x = "mean value in the steps of the lesson (reward, discounted)"
    figure, ax = chart((6.8, 3.4), x, "", title, grid="x")
    pupils, told = list(next(iter(worth.values()))), []
    rows, height = np.arange(len(worth)), 0.8 / len(pupils)
    for i, (pupil, (colour, _), hatch) in enumerate(
        zip(pupils, CURVES, ("", "//", ".."), strict=False)
    ):
        values = [by[pupil] for by in worth.values()]
        bars = ax.barh(rows + (i - (len(pupils) - 1) / 2) * height, values, height, color=colour, hatch=hatch,
                       edgecolor="white", label=plain(pupil))  # fmt: skip
        ax.bar_label(bars, fmt="%.1f", padding=3, fontsize=9)
        told += [
            f"{teacher}, {pupil}: {value:.1f}"
            for teacher, value in zip(worth, values, strict=True)
        ]
    ax.axvline(0, color="#505050", linewidth=1)
    name_rows(ax, list(worth))
    ax.margins(x=0.12)
    legend_below(figure, len(pupils))
    figure.alt = f"Bars, the mean value in the steps of each lesson. {'; '.join(told)}."
    return figure
