"""The figure of lesson 16: what three sets of cut points lead to."""

from rlrobot_course.figures.plots import BLUE, GREY, Picture, name_rows

CUTS = ("5, 10, 15 cm", "27, 53, 80 cm", "50, 100, 150 cm")
HELD, IDEAL = "walls hold", "ideal"
# Means and half intervals (95 %) of thirty robots in thirty minutes, for each of CUTS: studies/lesson_numbers.csv
FOUND = {
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
    IDEAL: {"fmt": "s", "color": GREY, "markerfacecolor": "none"},
}


def plot_cuts() -> Picture:
    """What robots with each set of cuts earn, how often they bump, and how many states they meet."""
    figure = Picture(figsize=(9.0, 2.8))
    said = []
    for ax, (what, worlds), digits in zip(
        figure.subplots(1, 3, sharey=True), FOUND.items(), (2, 1, 0), strict=True
    ):
        for world, numbers in worlds.items():
            for row, (mean, half) in enumerate(numbers):
                ax.errorbar(
                    mean,
                    row,
                    xerr=half,
                    label=world if row == 0 else None,
                    **LOOKS[world],
                )
                said.append(
                    f"{what}, cuts at {CUTS[row]}, {world}: {mean:.{digits}f} ± {half:.{digits}f}"
                )
        ax.set_xlabel(what)
        ax.grid(alpha=0.3)
        ax.margins(y=0.2)
    first = figure.axes[0]
    name_rows(first, CUTS)
    figure.legend(
        *first.get_legend_handles_labels(), loc="outside lower center", ncols=2
    )
    figure.headline(
        "The latest cuts earn most; where walls hold, the middle ones bump least"
    )
    figure.alt = f"Thirty robots with each set of cuts, means with 95 % intervals. {'; '.join(said)}."
    return figure
