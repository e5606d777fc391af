"""The figure of lesson 07: how a reward spreads."""

from collections.abc import Mapping

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    Picture,
    centred,
    in_panels,
    plain,
)
from rlrobot_edu.show.style import DARK_FROM, SHADES_OF_WORTH


def plot_corridor(values: Mapping[str, np.ndarray]) -> Picture:
    """How far a reward has got in a corridor: one panel a method, one row an episode, one column a cell.

    values: name of the method to array (episodes, cells), Q of each cell after each episode
    """
    highest = max(table.max() for table in values.values())
    picture = Picture(figsize=(0.4 + 4.0 * len(values), 4.6))
    picture.headline(
        drives_to_the_start(values),
        "Q of each cell after each drive, the darker the more; the reward lies behind the last cell",
    )
    known = (f"{name}: after episode 1, {np.count_nonzero(table[0])} of {table.shape[1]} cells have a value above 0, "
             f"the first of them cell {np.flatnonzero(table[0])[0]}" for name, table in values.items())  # fmt: skip
    picture.alt = f"How far the reward is known. {'; '.join(known)}."
    for ax, name, table in in_panels(picture, values):
        ax.imshow(table, cmap=SHADES_OF_WORTH, vmin=0, vmax=highest, aspect="auto")
        for (row, column), q in np.ndenumerate(table):
            colour = "white" if q > DARK_FROM * highest else BLACK
            centred(ax, column, row, f"{q:.1f}", color=colour)
        ax.set(title=plain(name), xlabel="cell")
        ax.set_xticks(range(table.shape[1]))
        ax.set_yticks(range(table.shape[0]), range(1, table.shape[0] + 1))
    picture.axes[0].set_ylabel("after drive")
    return picture


def drives_to_the_start(values: Mapping[str, np.ndarray]) -> str:
    """After how many drives the first cell has a value, with each method, as a sentence."""
    parts = []
    for name, table in values.items():
        drives = np.flatnonzero(table[:, 0])
        method = name.split(",")[0]
        if len(drives) == 0:
            parts.append(f"with {method} not in {len(table)} drives")
        elif drives[0] == 0:
            parts.append(f"with {method} in 1 drive")
        else:
            parts.append(f"with {method} in {drives[0] + 1} drives")
    return f"The reward reaches the first cell {', '.join(parts)}"
