"""The figure of Q_old: what is noted of a pair on arrival, and which change each pair needs one step later."""

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    RED,
    Picture,
    draw_arrow,
)
from rlrobot_course.lesson_08.forward_view import online_lambda_return


def plot_q_old() -> Picture:
    """Two pairs in turns, A to B, B to A, A to B: what is noted in step 2, and which change each pair needs in step 3.

    α = 0.5, γ = λ = 0.9, dutch traces; step 2 pays 10. All values are computed by the online λ-return algorithm.
    """
    turns = [
        (0, 0, 0.0, 1, 0, False),
        (1, 0, 10.0, 0, 0, False),
        (0, 0, 0.0, 1, 0, False),
    ]
    ideal = np.array(
        [q[:, 0] for q in online_lambda_return(turns, np.zeros((2, 1)), 0.5, 0.9, 0.9)]
    )
    (noted, now), (b_before, b_after) = ideal[:2, 0], ideal[1:, 1]
    shown = 0.9 * b_before  # what step 3 shows of A
    b_alone = b_before + 0.5 * (shown - now) * 0.81
    figure = Picture(figsize=(8.2, 6.0))
    above, below = figure.subplots(2, 1, sharex=True)
    for ax, values, name in ((above, ideal[:, 0], "A"), (below, ideal[:, 1], "B")):
        _change(ax, 2, values[0], values[1], GREY)
        ax.plot([0.75, 1.85], [0, 0], color=GREY, linewidth=1)
        ax.text(1, 0.25, "0.00", ha="center")
        ax.set(ylabel=f"Q({name})", ylim=(-1, 8), xlim=(0.75, 4.1))
        for border in (1.5, 2.5):
            ax.axvline(border, color=GREY, linewidth=0.8, linestyle=":")
    above.plot(2, noted, "s", color=RED, markersize=11, zorder=3)
    above.text(
        2.03,
        -0.8,
        f"noted on arrival: Q_old = {noted:.0f}",
        ha="center",
        color=RED,
    )
    above.text(1.95, now, f"{now:.2f} ", ha="right", va="center")
    above.plot([2.1, 3.44], [now, now], color=GREY, linewidth=1)
    above.plot([2.1, 2.85], [noted, noted], color=RED, linewidth=1)
    above.plot([2.55, 3.44], [shown, shown], color=BLACK, linestyle="--", linewidth=1)
    above.text(
        2.55,
        shown + 0.15,
        f"step 3 shows: A is worth 0 + 0.9 · {b_before:.0f} = {shown:.1f}",
        va="bottom",
    )
    _change(above, 2.85, noted, shown, RED)
    above.text(
        2.9,
        2,
        f"{shown - noted:.1f}: for B, whose\ntarget holds the {noted:.0f}",
        color=RED,
        va="center",
    )
    _change(above, 3.4, now, shown, BLUE)
    above.text(
        3.47,
        now - 0.1,
        f"δ = {shown - now:.2f}: for\nthis visit of A",
        color=BLUE,
        va="center",
    )
    below.text(1.95, b_before, f"{b_before:.2f} ", ha="right", va="center")
    below.plot([2.1, 3.44], [b_before, b_before], color=GREY, linewidth=1)
    _change(below, 2.85, b_before, b_after, RED)
    told = f"{b_after:.2f} = {b_before:.0f} + 0.5 · {shown - noted:.1f} · 0.81"
    below.text(2.9, b_after, told, color=RED, va="bottom")
    _change(below, 3.4, b_before, b_alone, BLUE)
    below.text(
        3.47,
        b_before,
        f"{b_alone:.2f} with δ alone,\n{b_before:.0f} + 0.5 · {shown - now:.2f} · 0.81",
        color=BLUE,
        va="center",
    )
    below.set_xticks(
        [1, 2, 3.2],
        ["step 1\nA → B, pays 0", "step 2\nB → A, pays 10", "step 3\nA → B, pays 0"],
    )
    figure.headline("In step 3 B needs all that is new about A, not δ alone")
    figure.alt = (
        f"Two rows, Q(A) and Q(B), over three steps. In step 2 Q(A) = {noted:.0f} is noted as Q_old, and then rises to "
        f"{now:.2f}; Q(B) rises to {b_before:.2f}. Step 3 shows that A is worth {shown:.1f}: {shown - noted:.1f} above "
        f"what was noted, {shown - now:.2f} above what Q(A) is now. With the first, Q(B) becomes {b_after:.2f}, with "
        f"the second {b_alone:.2f}."
    )
    return figure


def _change(ax: Axes, x: float, before: float, after: float, colour: str) -> None:
    """An arrow from one value to another."""
    draw_arrow(ax, (x, before), (x, after), colour, 2.5)
