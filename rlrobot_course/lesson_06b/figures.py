"""The figures of lesson 06b: the ways along the cliff, and what walking there pays while one learns."""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.plots import CURVES, ROLE, Picture, chart, plain
from rlrobot_course.runs import error_bars
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.learning.history import History
from rlrobot_edu.widgets.playground.cliff import CLIFF, GOAL, SHAPE, SHORTEST, START, count_ways, greedy_path


def plot_paths(groups: Mapping[str, Sequence[History]]) -> Picture:
    """The ways of agents that no longer explore, one grid a group; the more agents take a move, the thicker.

    groups: names and the histories of repetitions of one method
    """
    figure = Picture(figsize=(7.2, 2.5 * len(groups)))
    figure.alt = "Grids of 4 by 12 cells with the cliff between start and goal."
    grids = figure.subplots(len(groups), 1, squeeze=False)[:, 0]
    for ax, (name, histories), (colour, _) in zip(grids, groups.items(), CURVES, strict=False):
        _draw_grid(ax)
        moves = Counter(move for history in histories for move in pairwise(greedy_path(history.q)))
        for move, agents in moves.items():
            row, column = np.unravel_index(move, SHAPE)
            ax.plot(column, row, color=colour, linewidth=0.5 + 7 * agents / len(histories), solid_capstyle="round")
        ways = count_ways(histories)
        title = f"{name}: {ways['edge']} of {len(histories)} agents walk along the edge, {ways['off']} farther off"
        title += f", {ways['lost']} lost" if ways["lost"] else ""
        ax.set_title(plain(title))
        figure.alt += f" {title}."
    return figure


def first_returns(histories: Sequence[History], episodes: int) -> np.ndarray:
    """Sums of the rewards of each repetition's first episodes, array (repetitions, episodes).

    Raises ValueError if a repetition has fewer episodes.
    """
    fewest = min(len(history.returns) for history in histories)
    if fewest < episodes:
        raise ValueError(f"a repetition has {fewest} finished episodes, {episodes} are needed; learn for more steps")
    return np.array([history.returns[:episodes] for history in histories])


def plot_returns(
    groups: Mapping[str, Sequence[History]], title: str, *, episodes: int = 500, window: int = 10
) -> Picture:
    """Sum of the rewards of an episode while learning, mean of the repetitions with its 95 % interval.

    groups: names and the histories of repetitions of one method; title: of the figure
    episodes: how many are drawn; window: so many episodes in a row make one point, which smooths the curve
    """
    figure, ax = _figure("episode", title)
    for (name, histories), (colour, dashes) in zip(groups.items(), CURVES, strict=False):
        blocks = first_returns(histories, episodes).reshape(len(histories), -1, window).mean(axis=2)
        mean = blocks.mean(axis=0)
        middle = window * (np.arange(len(mean)) + 0.5)
        ax.fill_between(middle, *mean_band(blocks), color=colour, alpha=0.2, linewidth=0)
        label = f"{name} ({len(histories)} repetitions)"
        ax.plot(middle, mean, color=colour, linestyle=dashes, linewidth=1.8, label=plain(label))
        figure.alt += f" {name} ends at {mean[-1]:.0f}."
    ax.set_ylim(-110, 0)  # the first episodes lie far below and would flatten all that follows
    figure.legend(title="means, and their 95 % intervals", loc="outside lower center", ncols=2)
    return figure


def plot_over_epsilon(
    groups: Mapping[str, Mapping[float, Sequence[History]]], title: str, *, episodes: int = 100
) -> Picture:
    """Sum of the rewards of an episode after learning, over ε: mean of the repetitions with its 95 % interval.

    groups: names of methods, and for each ε above 0 the histories of its repetitions; title: of the figure
    episodes: so many of the last episodes count
    """
    figure, ax = _figure("ε, probability of exploring (logarithmic)", title)
    for i, (name, runs) in enumerate(groups.items()):
        last = np.array([[h.returns[-episodes:].mean() for h in histories] for histories in runs.values()])
        mean, reach = error_bars(last.T)
        colour, dashes = CURVES[i]
        label = plain(f"{name} ({len(last[0])} repetitions each)")
        ax.errorbar(list(runs), mean, reach, color=colour, linestyle=dashes, marker="os"[i % 2], capsize=3, label=label)
        told = ", ".join(f"{m:.0f} at ε = {epsilon:g}" for m, epsilon in zip(mean, runs, strict=True))
        figure.alt += f" {name}: {told}."
    ax.set_xscale("log")
    ax.set_xticks(list(runs), [f"{epsilon:g}" for epsilon in runs])
    ax.set_xticks([], minor=True)
    figure.legend(title="means, and their 95 % intervals", loc="outside lower center", ncols=2)
    return figure


def _draw_grid(ax: Axes) -> None:
    """Cells, cliff, start and goal, row 0 on top."""
    rows, columns = SHAPE
    ax.set(xlim=(-0.5, columns - 0.5), ylim=(rows - 0.5, -0.5), aspect="equal", xlabel="column", ylabel="row")
    ax.set_xticks(range(columns))
    ax.set_yticks(range(rows))
    ax.set_xticks(np.arange(columns) - 0.5, minor=True)
    ax.set_yticks(np.arange(rows) - 0.5, minor=True)
    ax.grid(which="minor", alpha=0.4)
    ax.tick_params(which="both", length=0)
    ax.add_patch(Rectangle((0.5, rows - 1.5), len(CLIFF), 1, facecolor=ROLE["wall"], hatch="xx", alpha=0.6))
    box = {"facecolor": "white", "edgecolor": "none", "pad": 2}
    ax.text((columns - 1) / 2, rows - 1, "the cliff: −100, back to the start", ha="center", va="center", bbox=box)
    for state, word in ((START, "start"), (GOAL, "goal")):
        row, column = np.unravel_index(state, SHAPE)
        ax.text(column, row + 0.28, word, ha="center", va="center", fontsize=9)


def _figure(xlabel: str, title: str) -> tuple[Picture, Axes]:
    figure, ax = chart((6.5, 4.2), xlabel, "sum of the rewards of an episode", title)
    ax.axhline(SHORTEST, color="black", linewidth=1, linestyle=":", label=f"the shortest way: −{-SHORTEST}")
    figure.alt = f"Sum of the rewards of an episode at the cliff; the best possible is {SHORTEST}."
    return figure, ax
