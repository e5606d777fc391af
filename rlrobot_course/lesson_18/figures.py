"""The figure of lesson 18 on rehearsals."""

from collections.abc import Mapping

from rlrobot_course.figures.plots import Picture
from rlrobot_course.figures.rows import ROBOTS, Rows, Values, compared
from rlrobot_course.figures.runs import mean_and_half


def plot_rehearsals(earned: Mapping[str, Values], hero: str, rival: str) -> Picture:
    """The mean reward of each group, with its 95 % interval, and a dot for each of its robots; two are compared.

    earned: name of a group -> mean reward a step of each robot
    """
    return draw_rehearsals(earned, compared(earned, hero, rival), hero)


def draw_rehearsals(
    earned: Mapping[str, Values], found: str, hero: str | None = None
) -> Picture:
    """The picture under a title of one's own. hero: the group that is blue"""
    rows = Rows(earned, found, f"mean reward a step; {ROBOTS}", hero=hero)
    told = []
    for name, values in earned.items():
        rows.dots(name)
        rows.mean(name)
        mean, half = mean_and_half(values)
        told.append(f"{name}: {mean:.1f} ± {half:.1f}")
    n = len(next(iter(earned.values())))
    rows.picture.alt = f"Mean reward a step, {n} robots each. {'; '.join(told)}."
    return rows.picture
