"""The figures of lesson 07: how a reward spreads, and how a trace fades."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    RED,
    Picture,
    centred,
    chart,
    in_panels,
    plain,
)


def plot_corridor(values: Mapping[str, np.ndarray], title: str) -> Picture:
    """How far a reward has got in a corridor: one panel a method, one row an episode, one column a cell.

    values: name of the method to array (episodes, cells), Q of each cell after each episode
    """
    highest = max(table.max() for table in values.values())
    picture = Picture(figsize=(0.4 + 4.6 * len(values), 4.0))
    picture.headline(title)
    known = (f"{name}: after episode 1, {np.count_nonzero(table[0])} of {table.shape[1]} cells have a value above 0, "
             f"the first of them cell {np.flatnonzero(table[0])[0]}" for name, table in values.items())  # fmt: skip
    picture.alt = f"{title}. {'; '.join(known)}."
    for ax, name, table in in_panels(picture, values):
        ax.imshow(table, cmap="cividis", vmin=0, vmax=highest, aspect="auto")
        for (row, column), q in np.ndenumerate(table):
            colour = BLACK if q > 0.45 * highest else "white"
            centred(ax, column, row, f"{q:.1f}", color=colour, fontsize=8)
        ax.set(
            title=plain(name),
            xlabel="cell (the reward lies behind the last one)",
            ylabel="after episode",
        )
        ax.set_xticks(range(table.shape[1]))
        ax.set_yticks(range(table.shape[0]), range(1, table.shape[0] + 1))
    return picture


def trace_curve(
    visits: Sequence[int],
    steps: int,
    gamma: float,
    lam: float,
    accumulating: bool = False,
) -> np.ndarray:
    """The trace of one pair at each step, as the update of that step uses it; array (steps,).

    visits: steps at which the pair is visited; each visit leaves (γλ)^n after n steps. A replacing trace is what the
    last visit left, an accumulating one the sum of what all of them left. Source: Sutton & Barto, section 12.7.
    """
    since = np.arange(steps) - np.array(sorted(visits))[:, None]
    left = np.where(since >= 0, (gamma * lam) ** np.maximum(since, 0), 0.0)
    return left.sum(axis=0) if accumulating else left.max(axis=0)


def plot_trace(
    visits: Sequence[int], steps: int = 40, gamma: float = 0.9, lam: float = 0.9
) -> Picture:
    """The trace of one pair, replacing and accumulating, with a mark at each visit."""
    replacing = trace_curve(visits, steps, gamma, lam)
    accumulating = trace_curve(visits, steps, gamma, lam, accumulating=True)
    title = "Replacing stops at 1, accumulating adds up"
    picture, ax = chart((6.5, 3.6), "step", "trace e(s, a)", title)
    picture.alt = (
        f"The trace of one pair over {steps} steps, visited at {', '.join(map(str, visits))}. It fades after each "
        f"visit. Replacing never exceeds {replacing.max():.2f}; accumulating reaches {accumulating.max():.2f}."
    )
    t = np.arange(steps)
    ax.plot(
        t,
        accumulating,
        color=RED,
        linestyle="--",
        marker="s",
        markersize=3.5,
        label="accumulating: e + 1",
    )
    ax.plot(t, replacing, color=BLUE, marker="o", markersize=3.5, label="replacing: 1")
    ax.plot(
        visits,
        np.full(len(visits), -0.12),
        "^",
        color=BLACK,
        markersize=7,
        label="the pair is visited",
    )
    ax.legend(loc="upper right")
    return picture
