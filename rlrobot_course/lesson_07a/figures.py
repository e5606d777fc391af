"""The figure of lesson 07a: which traces are worth keeping."""

import math

import numpy as np

from rlrobot_course.plots import BLACK, BLUE, GREY, VERMILION, Picture
from rlrobot_edu.learning.memory import TRACE_THRESHOLD, trace_steps


def plot_register(gamma: float = 0.9, lam: float = 0.9, threshold: float = TRACE_THRESHOLD) -> Picture:
    """A trace as it fades to the threshold, and below it the register: the pairs whose traces are above it.

    gamma, lam: their product is above 0 and below 1; threshold: below 1
    """
    decay, n = gamma * lam, int(trace_steps(gamma, lam, threshold))
    crossing = math.log(threshold) / math.log(decay)
    picture = Picture(figsize=(7.5, 4.6))
    picture.alt = (
        f"A trace of 1 loses {1 - decay:.0%} a step and crosses the threshold of {threshold:g} after {crossing:.2f} "
        f"steps. Below it the register, a row of {n + 1} boxes: the present step and the {n} before it."
    )
    picture.suptitle(f"After {crossing:.2f} steps a trace is below {threshold:g}: {n} are worth keeping")
    curve, boxes = picture.subplots(2, 1, sharex=True, height_ratios=(4, 1))
    steps = np.arange(n + 5)
    kept = steps <= n
    curve.semilogy(steps, decay**steps, color=GREY, linewidth=1)
    curve.semilogy(steps[kept], decay ** steps[kept], "o", color=BLUE, label="kept")
    curve.semilogy(steps[~kept], decay ** steps[~kept], "x", color=VERMILION, label="dropped")
    curve.axhline(threshold, color=VERMILION, linestyle="--", label=f"threshold {threshold:g}")
    curve.plot([crossing, crossing], [decay ** steps[-1], threshold], color=BLACK, linestyle=":")
    curve.annotate(f"{crossing:.2f}", (crossing, threshold), xytext=(8, 12), textcoords="offset points")
    curve.set_ylabel("trace (logarithmic)")
    curve.yaxis.set_major_formatter("{x:g}")
    curve.grid(alpha=0.3)
    curve.legend()
    for i in steps:
        shade = {"color": BLUE, "alpha": 0.1 + 0.5 * decay**i} if i <= n else {"color": "none"}
        boxes.bar(i, 1, width=0.9, **shade)
        boxes.bar(i, 1, width=0.9, color="none", edgecolor=BLUE if i <= n else VERMILION,
                  linestyle="-" if i <= n else ":")  # fmt: skip
        boxes.text(i, 0.5, str(i), ha="center", va="center", fontsize=8)
    boxes.set(xlabel="steps since the pair was visited", yticks=[], ylabel="register")
    return picture
