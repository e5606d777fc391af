"""The figure of lesson 18 on rehearsals."""

from collections.abc import Mapping

from rlrobot_course.figures.plots import Picture
from rlrobot_course.figures.rows import Values, compared, plot_groups


def plot_rehearsals(earned: Mapping[str, Values], hero: str, rival: str) -> Picture:
    """The mean reward of each group, with its 95 % interval, and a dot for each of its robots; two are compared.

    earned: name of a group -> mean reward a step of each robot
    """
    finding = compared(earned, hero, rival)
    return plot_groups(earned, finding, "mean reward a step", hero=hero)
