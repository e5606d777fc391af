"""The figures of lesson 15: how far the robot was from what it should keep its distance to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_edu.course.lesson_15.moving_target import FAR, NEAR
from rlrobot_edu.show.palette import CURVES, GREEN
from rlrobot_edu.show.picture import Picture, plain


def share_inside(distances: Sequence[float]) -> float:
    """Share of the steps after which the distance [m] was right."""
    return float(np.mean([NEAR < distance <= FAR for distance in distances]))


def plot_distances(distances: Mapping[str, Sequence[float]], title: str) -> Picture:
    """The distance after each step, one curve a robot, and the band in which it is right.

    distances: label of a curve -> distance to the spot after each step [m]
    """
    figure, told = Picture(figsize=(6.5, 3.8)), []
    ax = figure.subplots()
    ax.axhspan(NEAR, FAR, color=GREEN, alpha=0.15, hatch="//", linewidth=0, label="right distance")
    for (label, run), (colour, dashes) in zip(distances.items(), CURVES, strict=False):
        ax.plot(range(1, len(run) + 1), run, color=colour, linestyle=dashes, linewidth=1.8, label=plain(label))
        told.append(f"{label} is there after {share_inside(run):.0%} of the steps")
    ax.set(xlabel="step", ylabel="distance to the spot (m)", title=plain(title), ylim=(0, None))
    ax.grid(alpha=0.3)
    ax.margins(x=0)
    figure.legend(loc="outside lower center", ncols=len(distances) + 1)
    figure.alt = (
        f"Distance over {max(map(len, distances.values()))} steps; right from {NEAR} to {FAR} m. {'; '.join(told)}."
    )
    return figure
