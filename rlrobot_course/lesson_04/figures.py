"""The figure of lesson 04: how an action is drawn."""

from collections.abc import Sequence

import numpy as np

from rlrobot_course.plots import BLACK, CURVES, Picture


def plot_draw(p: Sequence[float], u: float) -> Picture:
    """Sampling an action: the probabilities end to end on a line from 0 to 1, and the point `u` that picks one of them.

    p: array (n_actions,), sums to 1, at most seven of them; u: in [0, 1)
    """
    ends = np.cumsum(p)
    sampled = int(np.argmax(ends > u))
    figure = Picture(figsize=(7, 1.7))
    ax = figure.subplots()
    for a, (colour, _) in zip(range(len(p)), CURVES, strict=False):
        ax.barh(0, p[a], left=ends[a] - p[a], color=colour, alpha=1 if a == sampled else 0.35, edgecolor=BLACK)
        ax.text(ends[a] - p[a] / 2, 0.5, f"action {a}: {p[a]:g}", ha="center", va="bottom")
    ax.plot([u, u], [-0.55, 0.45], color=BLACK, linewidth=2.5)
    ax.text(u, -0.6, f"u = {u:g}", ha="center", va="top")
    ax.set(xlim=(0, 1), ylim=(-1.05, 0.95), yticks=[], xticks=[0, *ends], title=f"u = {u:g} draws action {sampled}")
    ax.set_xlabel("running sum of the probabilities")
    figure.alt = (
        f"A line from 0 to 1, cut at {', '.join(f'{end:g}' for end in ends)}. u = {u:g} draws action {sampled}."
    )
    return figure
