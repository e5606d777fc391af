"""The figure of lesson 18 on rehearsals."""

from collections.abc import Mapping, Sequence

from rlrobot_course.figures.plots import CURVES, Picture, chart, name_rows
from rlrobot_course.figures.runs import mean_and_half


def plot_rehearsals(earned: Mapping[str, Sequence[float]], title: str) -> Picture:
    """The mean reward of each group, with its 95 % interval, and a dot for each of its robots.

    earned: name of a group -> mean reward a step of each robot
    """
    n, told = len(next(iter(earned.values()))), []
    x = f"mean reward a step; diamond: mean of {n} robots with its 95 % interval"
    figure, ax = chart((7.4, 1.7 + 0.6 * len(earned)), x, "", title, grid="x")
    for i, ((name, values), (colour, _)) in enumerate(
        zip(earned.items(), CURVES, strict=False)
    ):
        mean, half = mean_and_half(values)
        ax.plot(
            values, [i + 0.2] * len(values), "o", color=colour, alpha=0.4, markersize=5
        )
        ax.errorbar(
            mean,
            i - 0.08,
            xerr=half,
            fmt="D",
            color=colour,
            capsize=6,
            linewidth=2,
            markersize=7,
        )
        told.append(f"{name}: {mean:.1f} ± {half:.1f}")
    name_rows(ax, list(earned))
    ax.set_ylim(len(earned) - 0.4, -0.5)
    figure.alt = f"Mean reward a step, {n} robots each. {'; '.join(told)}."
    return figure
