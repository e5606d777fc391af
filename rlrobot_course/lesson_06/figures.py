"""The figures of lesson 06: ways along the cliff, falls into it, and what an episode pays while one learns."""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLUE,
    CURVES,
    RED,
    ROLE,
    Picture,
    centred,
    chart,
    draw_lattice,
    legend_below,
    plain,
)
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.learning.history import History
from rlrobot_edu.widgets.playground.cliff import (
    CLIFF,
    GOAL,
    SHAPE,
    SHORTEST,
    START,
    greedy_path,
)

FALL = -100  # the reward of a step into the cliff
WAYS = ("up to row 0", "up to row 1", "along the edge", "lost")


def plot_paths(groups: Mapping[str, Sequence[History]]) -> Picture:
    """The ways to the goal of agents that no longer explore, one grid a group; the more take a move, the thicker.

    In the cells of the cliff stands how often an agent stepped there in its last 5000 steps, the mean of the group.
    The ways of lost agents are not drawn.
    groups: names and the histories of repetitions of one method, which keep their transitions
    """
    figure = Picture(figsize=(7.2, 2.6 * len(groups)))
    figure.alt = "Grids of 4 by 12 cells with the cliff between start and goal."
    grids = figure.subplots(len(groups), 1, squeeze=False)[:, 0]
    for ax, (name, histories) in zip(grids, groups.items(), strict=True):
        _draw_grid(ax)
        colour = (
            BLUE if name.startswith("Q") else RED
        )  # SARSA's, as its curve in `plot_returns`
        paths = [
            greedy_path(history.q) for history in histories if way_of(history) != "lost"
        ]
        moves = Counter(move for path in paths for move in pairwise(path))
        for move, agents in moves.items():
            row, column = np.unravel_index(move, SHAPE)
            ax.plot(
                column,
                row,
                color=colour,
                linewidth=0.5 + 7 * agents / len(histories),
                solid_capstyle="round",
            )
        falls = falls_of(histories)
        for cell, n in zip(CLIFF, falls, strict=True):
            row, column = np.unravel_index(cell, SHAPE)
            centred(ax, column, row, f"{n:.1f}" if n else "", fontsize=9)
        ways = Counter(way_of(history) for history in histories)
        told = ", ".join(f"{ways[way]} {way}" for way in WAYS if ways[way])
        title = f"{name}: of {len(histories)} agents {told}"
        title += f"; {falls.sum():.0f} falls each" if falls.any() else "; no falls"
        ax.set_title(plain(title), fontsize=10)
        figure.alt += f" {title}."
    return figure


def way_of(history: History) -> str:
    """Which of the `WAYS` an agent goes that no longer explores, by the uppermost row on it."""
    way = greedy_path(history.q)
    return WAYS[min(way) // SHAPE[1]] if way[-1] == GOAL else "lost"


def falls_of(histories: Sequence[History], steps: int = 5000) -> np.ndarray:
    """How often a repetition stepped into each cell of the cliff in its last steps, on average; array (10,)."""
    falls = Counter[int]()
    for history in histories:
        s, a, r = (column[-steps:] for column in history.transitions[:3])
        moved = np.array((-SHAPE[1], 1, SHAPE[1], -1))[a]  # up, right, down, left
        falls.update((s + moved)[r == FALL].tolist())
    return np.array([falls[cell] for cell in CLIFF]) / len(histories)


def first_returns(histories: Sequence[History], episodes: int) -> np.ndarray:
    """Sums of the rewards of each repetition's first episodes, array (repetitions, episodes).

    Raises ValueError if a repetition has fewer episodes.
    """
    fewest = min(len(history.returns) for history in histories)
    if fewest < episodes:
        raise ValueError(
            f"a repetition has {fewest} finished episodes, {episodes} are needed; learn for more steps"
        )
    return np.array([history.returns[:episodes] for history in histories])


def plot_returns(
    groups: Mapping[str, Sequence[History]],
    title: str,
    *,
    episodes: int = 500,
    window: int = 10,
) -> Picture:
    """Sum of the rewards of an episode while learning, mean of the repetitions with its 95 % interval.

    groups: names and the histories of repetitions of one method; title: of the figure
    episodes: how many are drawn; window: so many episodes in a row make one point, which smooths the curve
    """
    figure, ax = _figure("episode", title)
    for (name, histories), (colour, dashes) in zip(
        groups.items(), CURVES, strict=False
    ):
        blocks = (
            first_returns(histories, episodes)
            .reshape(len(histories), -1, window)
            .mean(axis=2)
        )
        mean = blocks.mean(axis=0)
        middle = window * (np.arange(len(mean)) + 0.5)
        ax.fill_between(
            middle, *mean_band(blocks), color=colour, alpha=0.2, linewidth=0
        )
        label = f"{name} ({len(histories)} repetitions)"
        ax.plot(
            middle,
            mean,
            color=colour,
            linestyle=dashes,
            linewidth=1.8,
            label=plain(label),
        )
        figure.alt += f" {name} ends at {mean[-1]:.0f}."
    ax.set_ylim(
        -110, 0
    )  # the first episodes lie far below and would flatten all that follows
    legend_below(figure, 2, title="means, and their 95 % intervals")
    return figure


def _draw_grid(ax: Axes) -> None:
    """Cells, cliff, start and goal, row 0 on top."""
    rows, columns = SHAPE
    draw_lattice(ax, SHAPE)
    ax.set(xticks=range(columns), yticks=range(rows), ylabel="row")
    ax.set_xlabel("column; grey: the cliff, with the falls into each cell")
    ax.add_patch(
        Rectangle((0.5, rows - 1.5), len(CLIFF), 1, facecolor=ROLE["wall"], alpha=0.4)
    )
    for state, word in ((START, "start"), (GOAL, "goal")):
        row, column = np.unravel_index(state, SHAPE)
        centred(ax, column, row + 0.28, word, fontsize=9)


def _figure(xlabel: str, title: str) -> tuple[Picture, Axes]:
    figure, ax = chart((6.5, 4.2), xlabel, "sum of the rewards of an episode", title)
    ax.axhline(
        SHORTEST,
        color="black",
        linewidth=1,
        linestyle=":",
        label=f"the shortest way: −{-SHORTEST}",
    )
    figure.alt = f"Sum of the rewards of an episode at the cliff; the best possible is {SHORTEST}."
    return figure, ax
