"""The three kinds of trace side by side: what a pair's trace comes to when the pair is visited again and again."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rlrobot_edu.course.lesson_06.hindsight import LOOK
from rlrobot_edu.course.lesson_06.true_online import TRACES, replay
from rlrobot_edu.learning.size import Size
from rlrobot_edu.show.palette import GREY
from rlrobot_edu.show.picture import Picture


def trace_over_time(trace: str, visits: Sequence[bool], alpha: float) -> np.ndarray:
    """One pair's trace at each step, as Q is updated with it; array (n,).

    trace: ``accumulating``, ``replacing`` or ``dutch``; visits: list (n,), whether the pair is visited in each step
    alpha: learning rate. γ and λ are the defaults of an `Agent`, 0.9.
    """
    steps = [(0 if visited else 1, 0, 0.0, 1, 0, False) for visited in visits]
    fade = 0.9 * 0.9  # the kernels let a trace fade after the update
    return np.array([agent.memory.e[0, 0] / fade for agent in replay(trace, steps, Size((2,), 1), alpha=alpha)])


def plot_traces(visits: Sequence[bool], alphas: Sequence[float] = (0.1, 0.5)) -> Picture:
    """One pair's trace over the steps, accumulating, replacing and dutch, a panel for each learning rate.

    visits: list (n,), whether the pair is visited in each step
    """
    figure = Picture(figsize=(8, 3.8), layout="constrained")
    t, ends = np.arange(1, len(visits) + 1), []
    for ax, alpha in zip(figure.subplots(1, len(alphas), sharey=True, squeeze=False)[0], alphas, strict=True):
        for trace in TRACES:
            e = trace_over_time(trace, visits, alpha)
            ax.plot(t, e, **LOOK[trace], markersize=4, label=trace)
            ends.append(f"{trace} {e.max():.1f}")
        ax.plot(t[np.array(visits)], np.full(sum(visits), -0.25), "|", color=GREY, markersize=8, label="visit")
        ax.axhline(1 / alpha, color=GREY, linestyle=(0, (1, 1)))
        if 1 / alpha < 6:
            ax.text(0.27, 1 / alpha + 0.08, f"1/α = {1 / alpha:g}", ha="center", transform=ax.get_yaxis_transform())
        ax.set(xlabel="step", title=f"α = {alpha:g}", ylim=(-0.5, 6))
        ax.grid(alpha=0.3)
    figure.axes[0].set_ylabel("trace e(s, a) at the update")
    figure.axes[-1].legend(loc="upper right")
    figure.suptitle("The larger α, the nearer is the dutch trace to a replacing one")
    figure.alt = (
        f"Trace of a pair that is visited {sum(visits)} times in {len(visits)} steps. Largest values: "
        + "; ".join(f"α = {a:g}: {', '.join(ends[3 * i : 3 * i + 3])}" for i, a in enumerate(alphas))
        + "."
    )
    return figure
