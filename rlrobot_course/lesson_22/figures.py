"""The figure of lesson 22: what robots earn that see nothing."""

import numpy as np

from rlrobot_course.figures.plots import BLUE, GREY, Picture
from rlrobot_course.figures.rows import Rows, Values

NEARLY = 0.95  # of the largest reward is nearly all of it


def plot_blind(name: str, earned: Values, most: float) -> Picture:
    """A dot for each robot, on an axis that ends at the most that a step can pay.

    No mean: where some earn nearly all and others half of it, it tells of neither, and its interval would reach beyond
    what can be earned.
    """
    numbers = np.sort(earned)
    nearly_all = numbers >= NEARLY * most
    many = f"{nearly_all.sum()} of {len(numbers)} robots that see nothing"
    finding = f"{many} earn nearly {most:g}, the most that a step can pay"
    note = "reward a step in an hour; a dot: one robot"
    rows = Rows({name: numbers}, finding, note, limits=(0, most))
    rows.dots(name, [BLUE if nearly else GREY for nearly in nearly_all])
    rows.line(name, most, f"most: {most:g}")
    rows.ax.set_xlim(-0.02 * most, 1.05 * most)
    told = ", ".join(f"{number:.1f}" for number in numbers)
    rows.picture.alt = (
        f"Dots, one an agent, reward a step; {most:g} is the most. {name}: {told}."
    )
    return rows.picture
