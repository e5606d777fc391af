"""The figures of lesson 01: how readings become bins, and what robots do by rewards of several kinds."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    ORANGE,
    Picture,
    centred,
    in_panels,
    plain,
)
from rlrobot_course.lesson_01.drive import Drive
from rlrobot_edu import plot_scene
from rlrobot_edu.task.variables import InputVariable

SHADES = ("#f4f4f4", "#d9d9d9")  # of neighbouring bins


def plot_bins(
    inputs: Sequence[InputVariable], readings: Mapping[str, float]
) -> Picture:
    """Picture of the bins of `inputs`, one row each, and of the bin that each reading falls into.

    inputs: at least one, of the same unit, with cut points and a range that begins at 0; readings: by the inputs' names
    Bars end at the edge of the picture where a reading is more than twice the last cut point. Raises ValueError for an
    input without cut points.
    """
    for variable in inputs:
        if variable.cuts is None:
            raise ValueError(
                f"input {variable.name!r} has no cut points to draw; plot_bins needs inputs with cuts"
            )
    end = 2 * max(variable.cuts[-1] for variable in inputs)
    figure = Picture(figsize=(7, 1.3 + 0.5 * len(inputs)))
    ax = figure.subplots()
    said = []
    for row, variable in enumerate(inputs):
        edges = [0.0, *variable.cuts, end]
        for i, (low, high) in enumerate(pairwise(edges)):
            ax.barh(row, high - low, left=low, height=0.8, color=SHADES[i % 2])
            centred(
                ax, (low + high) / 2, row - 0.24, f"bin {i}", fontsize=8.5, color=BLACK
            )
        ax.vlines(
            variable.cuts,
            row - 0.4,
            row + 0.4,
            color=BLACK,
            linestyle="--",
            linewidth=1,
        )
        reading = readings[variable.name]
        ax.barh(
            row,
            min(reading, end),
            height=0.28,
            color=ORANGE,
            edgecolor=BLACK,
            linewidth=0.6,
            zorder=2,
        )
        result = f"{reading:.2f} {variable.unit} → bin {variable.bin(reading)}"
        ax.text(1.02 * end, row, plain(result), va="center", fontsize=10)
        said.append(f"{variable.name} {result.replace('→', 'is in')}")
    ax.set(
        xlim=(0, end),
        yticks=range(len(inputs)),
        yticklabels=[plain(variable.name) for variable in inputs],
    )
    ax.set_xlabel(
        plain(
            f"reading ({inputs[0].unit}); dashed: cut points; a longer bar ends at the edge"
        )
    )
    ax.invert_yaxis()
    ax.spines[["top", "right"]].set_visible(False)
    figure.headline("Each reading falls into one bin")
    figure.alt = f"Bars of {len(inputs)} readings over the bins of each input. {'; '.join(said)}."
    return figure


def plot_drives(drives: Mapping[str, Drive]) -> Picture:
    """The ways of two or more robots of wander_simple side by side, below what each did; by what each is called."""
    figure = Picture((3.3 * len(drives), 3.9))
    said = []
    for ax, name, drive in in_panels(figure, drives):
        far = sum(way > 0.07 for way in drive.ways())
        lasers = [
            (r["laser_front_left"], r["laser_front_right"]) for r in drive.readings[1:]
        ]
        touching = sum(min(pair) < 0.10 for pair in lasers)
        words = f"{far} steps over 0.07 m, {touching} touches"
        plot_scene(
            [scene._replace(beams=scene.beams[:0]) for scene in drive.scenes], ax
        )
        ax.set_title(
            plain(f"{name}: mean reward {np.mean(drive.rewards):.1f}\n{words}"),
            fontsize=10,
        )
        said.append(f"{name}: {words}")
    figure.headline(
        "100 steps of each robot, from where 1000 steps of learning had left it"
    )
    figure.alt = f"Paths of {len(drives)} robots in a square. {'; '.join(said)}."
    return figure
