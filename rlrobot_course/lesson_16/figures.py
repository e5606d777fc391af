"""The figure of lesson 16: what three sets of cut points lead to."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import BLUE, Picture, centred, in_panels, name_rows
from rlrobot_edu.show.palette import LIGHT

CUTS = ("5, 10, 15 cm", "27, 53, 80 cm", "50, 100, 150 cm")
HELD, IDEAL = "walls hold", "ideal"
# Means and half intervals (95 %) of thirty robots in thirty minutes, for each of CUTS: studies/lesson_numbers.csv
FOUND: dict[str, dict[str, tuple[tuple[float, float], ...]]] = {
    "reward a step": {
        IDEAL: ((6.1301, 0.2669), (4.7432, 0.3197), (3.2132, 0.1724)),
        HELD: ((4.0953, 0.5324), (3.1549, 0.2605), (1.8150, 0.1516)),
    },
    "bumps in 100 steps": {
        IDEAL: ((8.7037, 0.7830), (7.3222, 1.0357), (7.0444, 0.7723)),
        HELD: ((11.3185, 1.1950), (8.9019, 1.0308), (12.5852, 1.0785)),
    },
    "states met": {HELD: ((96.2, 6.5293), (190.2, 8.6185), (329.0667, 8.8075))},
}
LOOKS = {
    HELD: {"fmt": "o", "color": BLUE},
    IDEAL: {"fmt": "s", "color": LIGHT["faint"], "markerfacecolor": "white"},
}
DIGITS = (2, 1, 0)  # of each of FOUND

Found = Mapping[str, Mapping[str, Sequence[tuple[float, float]]]]


def cuts_finding(found: Found) -> str:
    """Which cuts earn most, and which bump least where walls hold."""
    paid, bumps, *_ = found.values()
    best = {CUTS[int(np.argmax(numbers, axis=0)[0])] for numbers in paid.values()}
    least = CUTS[int(np.argmin(bumps[HELD], axis=0)[0])]
    if len(best) > 1:
        return (
            f"Ideal or not, other cuts earn most; where walls hold, {least} bump least"
        )
    return f"Cuts at {best.pop()} earn most; where walls hold, {least} bump least"


def plot_cuts(found: Found = FOUND) -> Picture:
    """What robots with each set of cuts earn, how often they bump, and how many states they meet."""
    figure = Picture(figsize=(8.4, 2.9))
    note = "thirty robots with each set of cut points, half an hour; means with 95 % intervals"
    figure.headline(cuts_finding(found), note)
    said = []
    for k, (ax, what, worlds) in enumerate(in_panels(figure, found, sharey=True)):
        for world, numbers in worlds.items():
            shift = 0.12 if world == HELD else -0.12
            for row, (mean, half) in enumerate(numbers):
                ax.errorbar(mean, row + shift, xerr=half, **LOOKS[world])
                told = f"{mean:.{DIGITS[k]}f} ± {half:.{DIGITS[k]}f}"
                said.append(f"{what}, cuts at {CUTS[row]}, {world}: {told}")
            if k == 0:
                colour = LOOKS[world]["color"]
                x, _ = numbers[0]
                centred(ax, x, -0.12 + shift - 0.24, world, color=colour, weight="bold")
        ax.set_title(what, weight="bold")
        ax.grid(axis="x")
        ax.margins(x=0.12)
    name_rows(figure.axes[0], CUTS)
    figure.axes[0].set_ylim(2.5, -0.9)
    figure.alt = f"Thirty robots with each set of cuts, means with 95 % intervals. {'; '.join(said)}."
    return figure
