"""The figures of lesson 05: how a reward spreads, how a trace fades, and both views of λ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch

from rlrobot_edu.show.palette import BLACK, BLUE, GREY, VERMILION
from rlrobot_edu.show.picture import Picture, plain


def plot_corridor(values: Mapping[str, np.ndarray], title: str) -> Picture:
    """How far a reward has got in a corridor: one panel a method, one row an episode, one column a cell.

    values: name of the method to array (episodes, cells), Q of each cell after each episode
    """
    highest = max(table.max() for table in values.values())
    picture = Picture(figsize=(0.4 + 4.6 * len(values), 4.0))
    picture.suptitle(plain(title))
    known = (f"{name}: after episode 1, {np.count_nonzero(table[0])} of {table.shape[1]} cells have a value above 0, "
             f"the first of them cell {np.flatnonzero(table[0])[0]}" for name, table in values.items())  # fmt: skip
    picture.alt = f"{title}. {'; '.join(known)}."
    for ax, (name, table) in zip(picture.subplots(1, len(values), squeeze=False)[0], values.items(), strict=True):
        ax.imshow(table, cmap="cividis", vmin=0, vmax=highest, aspect="auto")
        for (row, column), q in np.ndenumerate(table):
            colour = BLACK if q > 0.45 * highest else "white"
            ax.text(column, row, f"{q:.1f}", ha="center", va="center", color=colour, fontsize=8)
        ax.set(title=plain(name), xlabel="cell (the reward lies behind the last one)", ylabel="after episode")
        ax.set_xticks(range(table.shape[1]))
        ax.set_yticks(range(table.shape[0]), range(1, table.shape[0] + 1))
    return picture


def trace_curve(visits: Sequence[int], steps: int, gamma: float, lam: float, accumulating: bool = False) -> np.ndarray:
    """The trace of one pair at each step, as the update of that step uses it; array (steps,).

    visits: steps at which the pair is visited; each visit leaves (γλ)^n after n steps. A replacing trace is what the
    last visit left, an accumulating one the sum of what all of them left. Source: Sutton & Barto, section 12.7.
    """
    since = np.arange(steps) - np.array(sorted(visits))[:, None]
    left = np.where(since >= 0, (gamma * lam) ** np.maximum(since, 0), 0.0)
    return left.sum(axis=0) if accumulating else left.max(axis=0)


def plot_trace(visits: Sequence[int], steps: int = 40, gamma: float = 0.9, lam: float = 0.9) -> Picture:
    """The trace of one pair, replacing and accumulating, with a mark at each visit."""
    replacing = trace_curve(visits, steps, gamma, lam)
    accumulating = trace_curve(visits, steps, gamma, lam, accumulating=True)
    picture = Picture(figsize=(6.5, 3.6))
    picture.alt = (
        f"The trace of one pair over {steps} steps, visited at {', '.join(map(str, visits))}. It fades after each "
        f"visit. Replacing never exceeds {replacing.max():.2f}; accumulating reaches {accumulating.max():.2f}."
    )
    ax = picture.subplots()
    t = np.arange(steps)
    ax.plot(t, accumulating, color=VERMILION, linestyle="--", marker="s", markersize=3.5, label="accumulating: e + 1")
    ax.plot(t, replacing, color=BLUE, marker="o", markersize=3.5, label="replacing: 1")
    ax.plot(visits, np.full(len(visits), -0.12), "^", color=BLACK, markersize=7, label="the pair is visited")
    ax.set(xlabel="step", ylabel="trace e(s, a)", title="Replacing stops at 1, accumulating adds up")
    ax.grid(alpha=0.3)
    ax.legend(loc="upper right")
    return picture


def lambda_weights(lam: float, steps: int) -> np.ndarray:
    """Weights of the n-step returns, n = 1 … steps, where the episode ends after `steps`; array (steps,).

    (1 − λ) λ^(n−1) each, and what is left, λ^(steps−1), for the whole return. Source: Sutton & Barto, section 12.1.
    """
    weights = (1 - lam) * lam ** np.arange(steps)
    weights[-1] = lam ** (steps - 1)
    return weights


def plot_views(gamma: float = 0.9, lam: float = 0.8, steps: int = 7) -> Picture:
    """Forward view above, backward view below, on one line of time; the width of an arrow is its weight.

    steps: how far to look in either direction; in the forward view the episode ends there
    """
    forward = lambda_weights(lam, steps)
    backward = (gamma * lam) ** np.arange(steps + 1)
    picture = Picture(figsize=(7.5, 5.6))
    picture.alt = (
        f"Two lines of time. Forward view: from now, arrows lead to the next {steps} steps, the n-step returns, with "
        f"weights from {forward[0]:.2f} falling to {forward[-2]:.2f}, and {forward[-1]:.2f} for the whole rest. "
        f"Backward view: from now, arrows lead to the {steps} steps before, which get shares of δ, from "
        f"{backward[1]:.2f} falling to {backward[-1]:.2f}."
    )
    picture.suptitle("Forward: one step looks at all that follow. Backward: one δ goes to all that came before")
    above, below = picture.subplots(2, 1, sharex=True)
    above.set_title(f"Forward view: weights of the n-step returns, (1 − λ) λⁿ⁻¹ with λ = {lam:g}", fontsize=10)
    _draw_view(above, range(1, steps + 1), forward, BLUE, steps)
    above.text(steps, -1.1, "end of the\nepisode", ha="center", va="top", fontsize=8)
    below.set_title(f"Backward view: shares of δ, (γλ)ᵏ with γλ = {gamma * lam:.2g}", fontsize=10)
    _draw_view(below, range(0, -steps - 1, -1), backward, VERMILION, steps)
    below.set_xlabel("steps from now")
    return picture


def _draw_view(ax: Axes, ends: range, weights: np.ndarray, colour: str, steps: int) -> None:
    """A line of time, and from its middle an arrow to each of `ends`, as wide as its weight."""
    everything = np.arange(-steps, steps + 1)
    ax.axhline(0, color=GREY, linewidth=1, zorder=1)
    ax.plot(everything, np.zeros(len(everything)), "o", color="white", markeredgecolor=GREY, markersize=9, zorder=2)
    ax.plot(ends, np.zeros(len(ends)), "o", color=colour, markersize=9, zorder=3)
    ax.plot(0, 0, "D", color=BLACK, markersize=10, zorder=4)
    for end, weight in zip(ends, weights, strict=True):
        if end:
            ax.add_patch(FancyArrowPatch((0, 0.15), (end, 0.15), arrowstyle="-|>", mutation_scale=9, color=colour,
                                         linewidth=0.4 + 4 * weight, shrinkA=4, shrinkB=2,
                                         connectionstyle=f"arc3,rad={-0.45 if end > 0 else 0.45}"))  # fmt: skip
        ax.text(end, -0.35, f"{weight:.2f}", ha="center", va="top", fontsize=9)
    ax.text(0, -1.1, "now", ha="center", va="top", fontsize=9, weight="bold")
    ax.set(ylim=(-1.9, 2.6), yticks=[], xticks=everything)
