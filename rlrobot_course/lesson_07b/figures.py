"""The figure of lesson 07b: λ forward, as weights of returns, and backward, as shares of δ."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch

from rlrobot_course.plots import BLACK, BLUE, GREY, VERMILION, Picture


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
