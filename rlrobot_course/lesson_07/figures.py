"""The figures of lesson 07: how a reward spreads, and how a trace fades."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    Picture,
    centred,
    chart,
    in_panels,
    plain,
)
from rlrobot_edu.show.ends import End, name_ends
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
    picture, ax = chart(
        (6.5, 4.0),
        "step",
        "",
        f"Replacing stops at {replacing.max():g}, accumulating adds up to {accumulating.max():.2f}",
        grid="y",
        note=f"trace e(s, a) of one pair; triangle: the pair is visited; γ = {gamma:g}, λ = {lam:g}",
    )
    picture.alt = (
        f"The trace of one pair over {steps} steps, visited at {', '.join(map(str, visits))}. It fades after each "
        f"visit. Replacing never exceeds {replacing.max():.2f}; accumulating reaches {accumulating.max():.2f}."
    )
    t = np.arange(steps)
    dashed = {"color": GREY, "linestyle": "--", "marker": "s", "markersize": 3.5}
    ax.plot(t, accumulating, **dashed)
    ax.plot(t, replacing, color=BLUE, marker="o", markersize=3.5)
    at = np.full(len(visits), -0.12)
    ax.plot(visits, at, "^", color=BLACK, markersize=7)
    ax.margins(x=0.02)
    ends = [
        End(float(accumulating[-1]), "accumulating: e + 1", GREY),
        End(float(replacing[-1]), "replacing: 1", BLUE),
    ]
    name_ends(ax, ends)
    return picture
