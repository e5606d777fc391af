"""The figures of lesson 07: how a reward spreads, and what robots earn with each λ."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    Picture,
    centred,
    in_panels,
    plain,
)
from rlrobot_edu.show.style import DARK_FROM, SHADES_OF_WORTH

LAMBDAS = (0, 0.5, 0.9)
EARLY, HOUR = "first 1000 steps", "an hour"
Earned = Mapping[str, Mapping[str, Sequence[tuple[float, float]]]]
# Mean and half of the 95 % interval of thirty robots, for each of LAMBDAS: studies/lesson_numbers.csv
EARNED: Earned = {
    "walls hold": {
        EARLY: ((0.8727, 0.1750), (1.1980, 0.2398), (1.6460, 0.1717)),
        HOUR: ((1.7734, 0.1194), (2.5947, 0.1651), (3.0544, 0.1289)),
    },
    "walls slide": {
        EARLY: ((2.7860, 0.2091), (3.0320, 0.2063), (3.2665, 0.1863)),
        HOUR: ((4.7531, 0.1601), (4.9010, 0.1761), (4.3466, 0.2221)),
    },
}


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


def plot_lambdas(earned: Earned = EARNED) -> Picture:
    """What robots earn with each λ, early and after an hour, a panel a world. earned: as `EARNED`"""
    picture = Picture(figsize=(7.6, 3.6))
    picture.headline(
        best_lambda(earned),
        "reward a step of thirty robots, mean and 95 % interval; grey: their first 1000 steps, blue: an hour",
    )
    told = []
    for ax, world, times in in_panels(picture, earned, sharey=True):
        for (when, numbers), colour, mark in zip(
            times.items(), (GREY, BLUE), "so", strict=True
        ):
            means, halves = zip(*numbers, strict=True)
            ax.errorbar(LAMBDAS, means, yerr=halves, fmt=f"{mark}-", color=colour)
            if world == "walls hold":
                look = {"color": colour, "weight": "bold", "ha": "right"}
                ax.text(LAMBDAS[-1], means[-1] + halves[-1] + 0.15, when, **look)
            told += [
                f"{world}, {when}, λ = {lam}: {mean:.2f} ± {half:.2f}"
                for lam, (mean, half) in zip(LAMBDAS, numbers, strict=True)
            ]
        ax.set(title=world, xlabel="λ")
        ax.set_xticks(LAMBDAS, [f"{lam:g}" for lam in LAMBDAS])
        ax.grid(axis="y")
        ax.margins(y=0.12)
    picture.axes[0].set_ylim(bottom=0)
    picture.alt = f"What thirty robots earn a step. {'; '.join(told)}."
    return picture


def best_lambda(earned: Earned) -> str:
    """With which λ robots earn most after an hour in each world, if it shows, as a sentence. earned: as `EARNED`"""
    parts = []
    for world, times in earned.items():
        order = sorted(zip(times[HOUR], LAMBDAS, strict=True), reverse=True)
        (mean, half), best = order[0]
        (next_mean, next_half), _ = order[1]
        if mean - next_mean > np.hypot(half, next_half):
            parts.append(f"λ = {best} earns most where {world}")
        else:
            parts.append(f"it is too close to tell where {world}")
    return f"After an hour {'; '.join(parts)}"
