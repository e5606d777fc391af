"""The names of curves at their ends, in place of a legend."""

from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.show.picture import plain
from rlrobot_edu.show.style import DPI, LETTERS, POINT

BESIDE = 10  # pixels of a page between the end of a curve and its name


class End(NamedTuple):
    """Where a curve ends, its name, and its colour."""

    y: float
    name: str
    colour: str


def name_ends(ax: Axes, ends: list[End]) -> None:
    """Write the name of each curve beside its end, at the right of the axes; neighbours make room for each other."""
    figure = ax.get_figure(root=True)
    assert figure is not None
    figure.draw_without_rendering()  # only now the axes have their height
    scale = DPI / figure.dpi
    order = sorted(ends, key=lambda end: end.y)
    y = np.array([ax.transData.transform((0, end.y))[1] for end in order]) * scale
    heights = [1.15 * LETTERS * POINT * (end.name.count("\n") + 1) for end in order]
    places = apart(y, np.array(heights))
    for end, here, place in zip(order, y, places, strict=True):
        ax.annotate(
            plain(end.name),
            (1, end.y),
            (BESIDE / POINT, (place - here) / POINT),
            xycoords=("axes fraction", "data"),
            textcoords="offset points",
            va="center",
            fontsize=LETTERS,
            linespacing=1.1,
            color=end.colour,
            weight="bold",
            annotation_clip=False,
        )


def apart(y: np.ndarray, heights: np.ndarray) -> np.ndarray:
    """Places for things of such heights, near `y` (sorted, upwards), so that none lies over another; array (n,)."""
    places = y.astype(float)
    least = (heights[:-1] + heights[1:]) / 2
    for _ in range(10 * len(y) + 10):
        overlap = np.maximum(least - np.diff(places), 0)
        if not overlap.any():
            break
        # each of two neighbours gives way by half
        places[:-1] -= overlap / 2
        places[1:] += overlap / 2
    return places
