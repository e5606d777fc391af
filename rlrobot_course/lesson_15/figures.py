"""The figures of lesson 15: what chance alone does, and the paper's differences compared with the report's."""

from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np
from matplotlib.ticker import PercentFormatter
from scipy import stats

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
    chart,
    legend_below,
    name_rows,
    plain,
)
from rlrobot_course.play.challenge import Score
from rlrobot_course.play.report import averages
from rlrobot_edu.experiments.statistics import Anova, Tukey

METHODS = ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")
# The paper's differences of means: Q of Tukey's test, times √(mean square within / n). Of the methods above, the first
# less the second, the first less the third, the second less the third.
PAPER = {
    "wander_simple": (-0.101, 1.32, 1.42),
    "wander_1k": (1.67, 3.02, 1.35),
    "wander_4k": (1.56, 2.16, 0.601),
    "arm_1k": (0.882, 3.25, 2.37),
    "arm_4k": (1.30, 4.67, 3.37),
    "navigation_1k": (1.08, 2.25, 1.18),
    "giraff_wander_1k": (0.958, 1.78, 0.822),
}


def shuffled_f(groups: Mapping[str, np.ndarray], times: int = 2000) -> np.ndarray:
    """F of these groups after their numbers were dealt anew at random, array (times,).

    groups: numbers of each method, by its name. Source: Fisher's permutation test.
    """
    rng, sizes = np.random.default_rng(0), [len(group) for group in groups.values()]
    everything, ends = np.concatenate(list(groups.values())), np.cumsum(sizes)[:-1]
    return np.array(
        [Anova.of(np.split(rng.permutation(everything), ends)).f for _ in range(times)]
    )


def plot_shuffled(
    groups: Mapping[str, np.ndarray], title: str, *, times: int = 2000
) -> Picture:
    """Histogram of `shuffled_f`, and the F that was observed as a line."""
    shuffled, observed = (
        shuffled_f(groups, times),
        Anova.of(list(groups.values())).f,
    )
    x = "F, spread between the methods / spread within them"
    figure, ax = chart((6.5, 3.2), x, "share of the shuffles", title, grid=None)
    bins = np.linspace(0, max(shuffled.max(), observed) * 1.05, 60)
    ax.hist(
        shuffled,
        bins,
        weights=np.full(times, 1 / times),
        color=BLUE,
        label=f"labels shuffled, {times} times",
    )
    ax.axvline(
        observed,
        color=RED,
        linestyle="--",
        linewidth=2,
        label=f"as found: F = {observed:.1f}",
    )
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.legend()
    figure.alt = (
        f"Histogram of F for shuffled labels, from 0 to {shuffled.max():.1f}, and a line at the observed F of "
        f"{observed:.1f}: {np.mean(shuffled >= observed):.1%} of the shuffles lie at or above it."
    )
    return figure


def draws_of_few(
    a: np.ndarray, b: np.ndarray, n: int, times: int = 2000
) -> tuple[np.ndarray, np.ndarray]:
    """n agents drawn from a and n from b, at random with repeats, two arrays (times, n)."""
    rng = np.random.default_rng(0)
    return rng.choice(a, (times, n)), rng.choice(b, (times, n))


def plot_few(
    a: np.ndarray,
    b: np.ndarray,
    sizes: Sequence[int],
    names: tuple[str, str],
    title: str,
) -> Picture:
    """Histograms of differences of means, by the numbers of agents in `sizes` that are drawn; names: of the methods."""
    draws = {n: draws_of_few(a, b, n) for n in sizes}
    found = {n: x.mean(axis=1) - y.mean(axis=1) for n, (x, y) in draws.items()}
    first, second = map(plain, names)
    x = f"{first} − {second}, difference of the means (reward a step)"
    figure, ax = chart((6.5, 3.5), x, "share of 2000 draws", title, grid=None)
    bins = np.linspace(
        min(map(np.min, found.values())), max(map(np.max, found.values())), 51
    )
    looks = [(ORANGE, "//"), (BLUE, ""), (GREEN, "\\\\"), (RED, "..")]
    for i, (n, differences) in enumerate(found.items()):
        colour, hatch = looks[i % len(looks)]
        share = np.full(len(differences), 1 / len(differences))
        ax.hist(
            differences,
            bins,
            weights=share,
            alpha=0.6,
            color=colour,
            hatch=hatch,
            label=f"{n} agents a method",
        )
    ax.axvline(0, color="black", linewidth=1)
    ax.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    ax.legend()
    figure.alt = "Histograms of the difference of means. " + "; ".join(
        f"{n} agents a method: from {d.min():.1f} to {d.max():.1f}, below 0 in {np.mean(d < 0):.1%}"
        for n, d in found.items()
    )
    return figure


def games_howell(x: np.ndarray, y: np.ndarray, groups: int = 3) -> float:
    """p of two of several groups whose numbers spread differently, arrays (n,). Source: Games & Howell (1976)."""
    a, b = stats.sem(x) ** 2, stats.sem(y) ** 2
    df = (a + b) ** 2 / (a**2 / (len(x) - 1) + b**2 / (len(y) - 1))
    q = abs(x.mean() - y.mean()) / np.sqrt((a + b) / 2)
    return float(stats.studentized_range.sf(q, groups, df))


def step_p(before: Score, after: Score, n: int) -> float:
    """p of Welch's test from the means and half intervals (Student's t, 95 %) of n robots each."""
    t = stats.t.ppf(0.975, n - 1) / n**0.5  # half interval over SD
    numbers = (before.mean, before.half / t, n, after.mean, after.half / t, n)
    return float(stats.ttest_ind_from_stats(*numbers, equal_var=False).pvalue)


def set_ups() -> dict[str, tuple[str, dict[str, np.ndarray]]]:
    """Name of a set-up of the report -> its task, and the final average rewards of the paper's three methods."""
    found = {}
    for (experiment, length), its in averages().items():
        task = experiment.removeprefix("robot_")
        if task in PAPER:
            found[f"{task}, {length}"] = (
                task,
                {method: its[method] for method in METHODS},
            )
        if experiment == "cause_walls_wander_1k":
            found[f"wander_1k, walls hold, {length}"] = "wander_1k", its
    return dict(sorted(found.items(), key=lambda one: list(PAPER).index(one[1][0])))


def plot_report() -> Picture:
    """Differences of three pairs of methods in each set-up: ours with Tukey's 95 % intervals, and the paper's."""
    rows = set_ups()
    figure = Picture(figsize=(9.0, 1.8 + 0.3 * len(rows)))
    axes = figure.subplots(1, 3, sharey=True)
    opposite, alike, shown = 0, 0, list[str]()
    for row, (name, (task, groups)) in enumerate(rows.items()):
        within, n = Anova.of(list(groups.values())), len(groups[METHODS[0]])
        half = stats.studentized_range.ppf(0.95, 3, within.df_within) * np.sqrt(
            within.ms_within / n
        )
        for ax, pair, theirs in zip(
            axes, Tukey.of(groups).pairs, PAPER[task], strict=True
        ):
            turned = pair.difference * theirs < 0
            look = {"fmt": "s", "color": RED} if turned else {"fmt": "o", "color": BLUE}
            face = look["color"] if pair.p < 0.05 else "white"
            ax.errorbar(
                pair.difference,
                row,
                xerr=half,
                markersize=5,
                markerfacecolor=face,
                **look,
            )
            ax.plot(theirs, row, "D", color=BLACK, markerfacecolor="none", markersize=7)
            opposite += turned
            alike += not turned and pair.p < 0.05
            if turned and pair.p < 0.05:
                shown.append(f"{name}: {pair.first} less {pair.second}")
    for ax, pair in zip(axes, combinations(METHODS, 2), strict=True):
        ax.axvline(0, color=GREY, linestyle=":")
        ax.set_title(plain(" less\n".join(pair)), fontsize=10)
        ax.set_xlabel("reward a step")
        ax.grid(alpha=0.3)
    name_rows(axes[0], list(rows))
    axes[0].errorbar(
        [],
        [],
        xerr=[],
        fmt="o",
        color=BLUE,
        label="ours, 95 % interval (Tukey); hollow: not significant",
    )
    axes[0].errorbar(
        [], [], xerr=[], fmt="s", color=RED, label="ours, opposite to the paper"
    )
    axes[0].plot([], [], "D", color=BLACK, markerfacecolor="none", label="the paper")
    legend_below(figure, 3)
    total = 3 * len(rows)
    figure.headline(
        f"{total - opposite} of {total} differences have the paper's direction, {alike} significantly; "
        f"{opposite} the opposite one, {len(shown)} significantly"
    )
    figure.alt = (
        f"Differences of three pairs of methods in {len(rows)} set-ups, beside the paper's: {opposite} of {total} are "
        f"opposite to it, and significantly so {len(shown)}: {'; '.join(shown)}. "
        f"Of the others {alike} are significant."
    )
    return figure
