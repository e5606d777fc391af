"""The figure of lesson 21: the bins of two tasks on two rulers."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from rlrobot_course.figures.plots import BLACK, CURVES, GREY, Picture, centred, plain
from rlrobot_course.lesson_21.bins import edges
from rlrobot_edu.task.task_file import load_task

FAR = 1.0  # where the drawing of rulers ends [m]


def rulers_finding(shares: Sequence[Sequence[float]]) -> str:
    """How many of the upper bins lie in one bin below, and how many in several."""
    parts = [sum(share > 0 for share in row) for row in shares]
    whole, shared = sum(n == 1 for n in parts), sum(n > 1 for n in parts)
    if not shared:
        return f"Each of the {len(parts)} new bins lies in one old bin"
    return f"{whole} of the {len(parts)} new bins lie in one old bin each, {shared} in several"


def plot_rulers(
    target: Sequence[float],
    source: Sequence[float],
    shares: Sequence[Sequence[float]],
    labels: tuple[str, str],
) -> Picture:
    """Two rulers, the target's above, and lines from its bins to those of the source that have a share in them.

    target, source: edges of the bins [m]; shares: for each of the target's bins its share in each of the source's
    labels: of the two rulers. The drawing ends at 1 m
    """
    figure, told = Picture(figsize=(7.4, 3.6)), []
    ax = figure.subplots()
    middles = []
    for y, ruler in ((1.0, target), (0.0, source)):
        ends = np.minimum(ruler, FAR)
        for i, (left, right) in enumerate(pairwise(ends)):
            colour = CURVES[i][0]
            ax.barh(
                y,
                right - left,
                left=left,
                height=0.22,
                color=colour,
                alpha=0.35,
                edgecolor=BLACK,
            )
            centred(ax, (left + right) / 2, y, str(i), color=BLACK)
        middles.append((ends[:-1] + ends[1:]) / 2)
        for edge in ruler[1:-1]:
            centred(ax, edge, y + (0.2 if y else -0.2), f"{edge:g}", color=BLACK)
    for i, row in enumerate(shares):
        for k, share in enumerate(row):
            if share > 0:
                ends = [middles[0][i], middles[1][k]]
                ax.plot(
                    ends,
                    [0.88, 0.12],
                    color=CURVES[i][0],
                    linewidth=0.6 + 5 * share,
                    alpha=0.7,
                )
                at = 0.62 if share > 0.5 else 0.42
                x = ends[1] + (ends[0] - ends[1]) * (at - 0.12) / 0.76
                centred(
                    ax,
                    x,
                    at,
                    f"{share:.2f}".rstrip("0").rstrip("."),
                    color=BLACK,
                    bbox={
                        "facecolor": "white",
                        "edgecolor": GREY,
                        "pad": 1.5,
                        "linewidth": 0.5,
                    },
                )
        told.append(
            f"bin {i}: {', '.join(f'{share:.2f} in {k}' for k, share in enumerate(row) if share > 0)}"
        )
    ax.set_yticks([1.0, 0.0], [plain(label) for label in labels])
    ax.set(ylim=(-0.35, 1.35), xlim=(0, FAR))
    note = (
        "the front laser's bins (m); a number on a line: the share of the new bin; "
        f"the last bins go on to {target[-1]:g} m"
    )
    figure.headline(rulers_finding(shares), note)
    figure.alt = f"Two rulers with bins: {labels[0]} above {labels[1]}. Shares of the upper bins: {'; '.join(told)}."
    return figure


def edges_of(task: str) -> list[float]:
    """The edges of the front laser's bins [m], with the ends of what its sensor can read."""
    return edges(next(v for v in load_task(task).inputs if v.name == "laser_front"))
