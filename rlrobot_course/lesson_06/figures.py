"""The figures of lesson 06: ways along the cliff, falls into it, and what an episode pays while one learns."""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    PURPLE,
    ROLE,
    Picture,
    centred,
    chart,
    draw_lattice,
    plain,
)
from rlrobot_course.figures.words import as_sentence
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.numerals import with_minus
from rlrobot_edu.widgets.playground.cliff import (
    CLIFF,
    GOAL,
    SHAPE,
    SHORTEST,
    START,
    greedy_path,
)

FALL = -100  # the reward of a step into the cliff
# Q-learning, with which SARSA is compared, then SARSA, and last the reader's own
LOOKS = [(GREY, "--"), (PURPLE, "-."), (BLUE, "-")]
WAYS = ("up to row 0", "up to row 1", "along the edge", "lost")


def plot_paths(groups: Mapping[str, Sequence[History]]) -> Picture:
    """The ways to the goal of agents that no longer explore, one grid a group; the more take a move, the thicker.

    In the cells of the cliff stands how often an agent stepped there in its last 5000 steps, the mean of the group.
    The ways of lost agents are not drawn.
    groups: names and the histories of repetitions of one method, which keep their transitions
    """
    figure = Picture(figsize=(7.2, 2.3 * len(groups) + 1.0))
    figure.headline(
        where_most_go(groups),
        "ways without exploring, thicker: more agents; "
        "grey: the cliff, with an agent's falls in its last 5000 steps",
    )
    figure.alt = "Grids of 4 by 12 cells with the cliff between start and goal."
    grids = figure.subplots(len(groups), 1, squeeze=False)[:, 0]
    for ax, (name, histories) in zip(grids, groups.items(), strict=True):
        _draw_grid(ax)
        paths = [
            greedy_path(history.q) for history in histories if way_of(history) != "lost"
        ]
        moves = Counter(move for path in paths for move in pairwise(path))
        colour = GREY if name.startswith("Q") else BLUE
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
            centred(ax, column, row, f"{n:.1f}" if n else "")
        ways = Counter(way_of(history) for history in histories)
        told = ", ".join(f"{ways[way]} {way}" for way in WAYS if ways[way])
        title = f"{name}: of {len(histories)} agents {told}"
        title += f"; {falls_in_words(falls) or 'no falls'}"
        if len(groups) > 1:
            ax.set_title(plain(title))
        figure.alt += f" {title}."
    return figure


def where_most_go(groups: Mapping[str, Sequence[History]]) -> str:
    """The way that most agents of each group go, and how often they fall, as a sentence."""
    parts = []
    for name, histories in groups.items():
        ways = Counter(way_of(history) for history in histories)
        way, agents = ways.most_common(1)[0]
        part = f"{name}: {agents} of {len(histories)} {way}"
        falls = falls_in_words(falls_of(histories))
        if falls:
            part += f", {falls}"
        parts.append(part)
    return as_sentence("; ".join(parts))


def falls_in_words(falls: np.ndarray) -> str:
    """How often an agent fell, all cells together; empty if none did. falls: as of `falls_of`"""
    if not falls.any():
        return ""
    number = f"{falls.sum():.0f}"
    return f"{number} {'fall' if number == '1' else 'falls'} each"


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
    groups: Mapping[str, Sequence[History]], *, episodes: int = 500, window: int = 10
) -> Picture:
    """Sum of the rewards of an episode while learning, mean of the repetitions with its 95 % interval.

    groups: names and the histories of repetitions of one method
    episodes: how many are drawn; window: so many episodes in a row make one point, which smooths the curve
    """
    points = {}
    for name, histories in groups.items():
        returns = first_returns(histories, episodes)
        points[name] = returns.reshape(len(histories), -1, window).mean(axis=2)
    last = {name: float(blocks.mean(axis=0)[-1]) for name, blocks in points.items()}
    repetitions = " or ".join(str(n) for n in sorted({len(h) for h in groups.values()}))
    figure, ax = chart(
        (6.5, 4.4),
        "episode",
        "",
        _ends_in_words(last),
        grid="y",
        note=f"rewards of an episode while they explore, {window} episodes a point; "
        f"line: mean of {repetitions} agents, band: its 95 % interval",
    )
    figure.alt = f"Sum of the rewards of an episode at the cliff; the best possible is {SHORTEST}."
    ends = [End(SHORTEST, f"shortest way\n{with_minus(SHORTEST)}", BLACK)]
    ax.axhline(SHORTEST, color=BLACK, linewidth=1, linestyle=":")
    looks = LOOKS[: len(points) - 1] + LOOKS[-1:]
    for (name, blocks), (colour, dashes) in zip(points.items(), looks, strict=False):
        mean = blocks.mean(axis=0)
        middle = window * (np.arange(len(mean)) + 0.5)
        band = {"color": colour, "alpha": 0.2, "linewidth": 0}
        ax.fill_between(middle, *mean_band(blocks), **band)
        ax.plot(middle, mean, color=colour, linestyle=dashes, linewidth=1.8)
        ends.append(End(last[name], f"{name}\n{with_minus(last[name])}", colour))
        figure.alt += f" {name} ends at {last[name]:.0f}."
    # the first episodes lie far below and would flatten all that follows
    ax.set_ylim(-110, 0)
    ax.margins(x=0)
    name_ends(ax, ends)
    return figure


def _ends_in_words(last: Mapping[str, float]) -> str:
    """What the last points of the curves say."""
    (first, value), *others = last.items()
    text = f"{first} ends at {with_minus(value)} an episode"
    for name, value in others:
        text += f", {name} at {with_minus(value)}"
    return as_sentence(text)


def _draw_grid(ax: Axes) -> None:
    """Cells, cliff, start and goal, row 0 on top."""
    rows, columns = SHAPE
    draw_lattice(ax, SHAPE)
    ax.set_xticks(range(columns))
    ax.set_yticks(range(rows), [f"row {row}" for row in range(rows)])
    ax.add_patch(
        Rectangle((0.5, rows - 1.5), len(CLIFF), 1, facecolor=ROLE["wall"], alpha=0.4)
    )
    for state, word in ((START, "start"), (GOAL, "goal")):
        row, column = np.unravel_index(state, SHAPE)
        centred(ax, column, row + 0.3, word)
