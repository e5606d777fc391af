"""The figure of Q_old: what is noted of a pair on arrival, and which change each pair needs one step later."""

from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    RED,
    Picture,
    centred,
    draw_arrow,
)
from rlrobot_course.lesson_08.forward_view import online_lambda_return

ALPHA, DECAY = 0.5, 0.9  # γ and λ are alike
TURNS = ("A → B, pays 0", "B → A, pays 10", "A → B, pays 0")
A, B = 0, 1  # where the pairs stand in each panel


class Numbers(NamedTuple):
    """Q(A) as noted and after step 2, Q(B) after step 2 and 3, what step 3 shows of A, and Q(B) by δ alone."""

    noted: float
    now: float
    b: float
    b_after: float
    shown: float
    b_alone: float


def numbers() -> Numbers:
    """All by the online λ-return algorithm, but the last one."""
    turns = [
        (A, 0, 0.0, B, 0, False),
        (B, 0, 10.0, A, 0, False),
        (A, 0, 0.0, B, 0, False),
    ]
    zeros = np.zeros((2, 1))
    ideal = [q[:, 0] for q in online_lambda_return(turns, zeros, ALPHA, DECAY, DECAY)]
    noted, now = float(ideal[0][A]), float(ideal[1][A])
    b, b_after = float(ideal[1][B]), float(ideal[2][B])
    shown = DECAY * b
    b_alone = b + ALPHA * (shown - now) * DECAY * DECAY
    return Numbers(noted, now, b, b_after, shown, b_alone)


def plot_q_old() -> Picture:
    """Two pairs in turns, A to B, B to A, A to B: what is noted in step 2, and which change each pair needs in step 3.

    α = 0.5, γ = λ = 0.9, dutch traces; step 2 pays 10.
    """
    n = numbers()
    long, short = n.shown - n.noted, n.shown - n.now
    figure = Picture((8.4, 5.0))
    figure.headline(
        f"In step 3 B needs the long arrow, {long:.1f}; "
        f"δ alone, {short:.2f}, would leave it at {n.b_alone:.2f} in place of {n.b_after:.2f}",
        f"values of two pairs, step by step; α = {ALPHA:g}, γ = λ = {DECAY:g}, dutch traces",
    )
    ratios = {"width_ratios": (1, 1.5, 3)}
    first, second, third = figure.subplots(1, 3, sharey=True, gridspec_kw=ratios)
    for i, (ax, turn) in enumerate(zip(figure.axes, TURNS, strict=True)):
        ax.set_title(f"step {i + 1}\n{turn}")
        ax.set_xticks([A, B], ["Q(A)", "Q(B)"])
        ax.set(xlim=(-0.6, 1.6), ylim=(-0.9, 8))
        ax.grid(axis="y")
        ax.tick_params(axis="x", labelsize=12)
    for x in (A, B):
        _value(first, x, 0)
    _draw_second(second, n)
    _draw_third(third, n)
    figure.alt = (
        f"Three panels, a step each, with Q(A) and Q(B). In step 2 Q(A) = {n.noted:.0f} is noted as Q_old, "
        f"and then rises to {n.now:.2f}; Q(B) rises to {n.b:.2f}. Step 3 shows that A is worth {n.shown:.1f}: "
        f"{long:.1f} above what was noted, {short:.2f} above what Q(A) is now. "
        f"With the first, Q(B) becomes {n.b_after:.2f}, with the second {n.b_alone:.2f}."
    )
    return figure


def _draw_second(ax: Axes, n: Numbers) -> None:
    """Both values rise; what A was worth before is noted."""
    draw_arrow(ax, (A, n.noted), (A, n.now), GREY, 2.5)
    draw_arrow(ax, (B, 0), (B, n.b), GREY, 2.5)
    centred(ax, A, n.now + 0.35, f"{n.now:.2f}")
    centred(ax, B, n.b + 0.35, f"{n.b:.2f}")
    _note(ax, A, n.noted)
    centred(ax, A + 0.05, n.noted - 0.55, f"noted: Q_old = {n.noted:.0f}", color=BLUE)


def _draw_third(ax: Axes, n: Numbers) -> None:
    """What each pair needs: the long arrow and the short one."""
    left, right = -0.1, 0.1
    long, short = n.shown - n.noted, n.shown - n.now
    ax.set_xlim(-0.45, 1.75)
    ax.plot([-0.35, 0.3], [n.shown] * 2, color=BLACK, linestyle="--", linewidth=1)
    text = f"A is worth {DECAY:g} · {n.b:.0f} = {n.shown:.1f}"
    ax.text(-0.35, n.shown + 0.15, text, va="bottom")
    _note(ax, left, n.noted)
    draw_arrow(ax, (left, n.noted), (left, n.shown), BLUE, 3)
    _beside(
        ax, left + 0.04, 1.8, f"{long:.1f}: the 0 in\nB's target is\nreplaced", BLUE
    )
    _value(ax, right, n.now, named=False)
    draw_arrow(ax, (right, n.now), (right, n.shown), RED, 3)
    _beside(
        ax, right + 0.05, n.now - 0.35, f"δ = {short:.2f}: for\nthis visit of A", RED
    )
    for x in (B + left, B + right):
        _value(ax, x, n.b, named=False)
    draw_arrow(ax, (B + left, n.b), (B + left, n.b_after), BLUE, 3)
    draw_arrow(ax, (B + right, n.b), (B + right, n.b_alone), RED, 3)
    factor = DECAY * DECAY
    told = f"{n.b_after:.2f} = {n.b:.0f} + {ALPHA:g} · {long:.1f} · {factor:.2f}"
    centred(ax, B + 0.1, n.b_after + 0.4, told, color=BLUE, weight="bold")
    told = f"{n.b_alone:.2f} = {n.b:.0f} + {ALPHA:g} · {short:.2f} · {factor:.2f}"
    centred(ax, B + 0.1, n.b - 0.5, told, color=RED, weight="bold")


def _value(ax: Axes, x: float, y: float, named: bool = True) -> None:
    """A value as a short line, if named with its number above it."""
    ax.plot([x - 0.08, x + 0.08], [y, y], color=GREY, linewidth=3)
    if named:
        centred(ax, x, y + 0.35, f"{y:.2f}")


def _note(ax: Axes, x: float, y: float) -> None:
    """The mark of the value that was noted."""
    ax.plot(x, y, "s", color=BLUE, markersize=10, zorder=3)


def _beside(ax: Axes, x: float, y: float, text: str, colour: str) -> None:
    """A text at the right of an arrow."""
    ax.text(x, y, text, va="center", color=colour, weight="bold")
