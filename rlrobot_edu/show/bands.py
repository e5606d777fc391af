"""Learning curves of a comparison: means, bootstrap bands, and the optimum as a ruler."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.experiments.statistics import bootstrap_band
from rlrobot_edu.show.palette import BLACK, CURVES
from rlrobot_edu.show.picture import Picture

if TYPE_CHECKING:
    from rlrobot_edu.experiments.comparison import Comparison

POINTS = 400  # of a curve; a picture shows no more


def plot_bands(result: Comparison, *, ax: Axes | None = None, title: str | None = None) -> Picture | Axes:
    """Mean curves of each method with bootstrap 95 % bands. Returns the figure, or `ax` where one was given."""
    figure = None
    if ax is None:
        figure = Picture(figsize=(6.5, 4.2), layout="constrained")
        ax = figure.subplots()
    ends, banded = [], False
    for i, (label, runs) in enumerate(result.groups.items()):
        curves = runs.curves
        steps = np.unique(np.linspace(1, curves.shape[1], min(POINTS, curves.shape[1])).astype(int))
        curves = curves[:, steps - 1]
        colour, dashes = CURVES[i % len(CURVES)]
        if len(runs) > 1:
            ax.fill_between(steps, *bootstrap_band(curves, seed=result.seed), color=colour, alpha=0.2, linewidth=0)
            banded = True
        mean = curves.mean(axis=0)
        ax.plot(steps, mean, color=colour, linestyle=dashes, linewidth=1.8, label=f"{label} ({len(runs)} repetitions)")
        ends.append(f"{label} ends at {mean[-1]:.2f}")
    if result.optimum is not None:
        ax.axhline(result.optimum, color=BLACK, linewidth=1, label=f"best achievable: {result.optimum:.2f}")
        ends.append(f"the best achievable is {result.optimum:.2f}")
    episodic = result.world.episode_steps is not None
    seconds = getattr(result.world, "step_time", None)
    ax.set_xlabel(("step of the last episode" if episodic else "step") + (f" ({seconds:g} s each)" if seconds else ""))
    ax.set_ylabel("average reward per step")
    ax.set_title(title or f"How the average reward develops in {result.name}")
    ax.grid(alpha=0.3)
    ax.margins(x=0)
    note = "means, and bootstrap bands of 95 %" if banded else None
    if figure is None:
        ax.legend(title=note)
        return ax
    figure.legend(title=note, loc="outside lower center", ncols=1 if len(ends) < 3 else 2)
    figure.alt = f"Learning curves, average reward over {steps[-1]} steps. {'; '.join(ends)}."
    return figure
