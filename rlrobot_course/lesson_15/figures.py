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
    VERMILION,
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
        color=VERMILION,
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
    looks = [(ORANGE, "//"), (BLUE, ""), (GREEN, "\\\\"), (VERMILION, "..")]
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


def two_intervals(
    groups: Mapping[str, np.ndarray], first: str, second: str
) -> dict[str, tuple[float, float]]:
    """The simultaneous 95 % interval of first less second by each of the two tests, low and high."""
    labels = list(groups)
    i, j = labels.index(first), labels.index(second)
    found = {}
    for test, alike in (("Tukey", True), ("Games and Howell", False)):
        outcome = stats.tukey_hsd(*groups.values(), equal_var=alike)
        ends = outcome.confidence_interval(0.95)
        found[test] = float(ends.low[i, j]), float(ends.high[i, j])
    return found


def plot_two_tests(groups: Mapping[str, np.ndarray]) -> Picture:
    """Each robot as a dot, and the difference of each pair with its interval by both tests. groups: arrays (n,)"""
    picture = Picture(figsize=(9.0, 3.6))
    left, right = picture.subplots(1, 2)
    rng = np.random.default_rng(0)
    for row, x in enumerate(groups.values()):
        beside = row + rng.uniform(-0.25, 0.25, len(x))
        left.plot(x, beside, ".", color=GREY, markersize=4)
        left.plot([x.mean()] * 2, [row - 0.35, row + 0.35], color=BLUE, linewidth=2)
    name_rows(left, list(groups))
    left.set_xlabel("final average reward; line: mean")
    looks = {"Tukey": (VERMILION, "s", -0.14), "Games and Howell": (BLUE, "o", 0.14)}
    names, apart, told = [], [], []
    for row, pair in enumerate(Tukey.of(groups).pairs):
        names.append(f"{pair.first} less\n{pair.second}")
        if pair.tests_disagree:
            apart.append(f"{pair.first} and {pair.second}")
        ends = two_intervals(groups, pair.first, pair.second)
        for test, (low, high) in ends.items():
            colour, marker, shift = looks[test]
            right.errorbar(
                pair.difference,
                row + shift,
                xerr=(high - low) / 2,
                fmt=marker,
                color=colour,
                capsize=3,
                label=test if row == 0 else None,
            )
        tukey, games_howell = (
            f"{low:.2f} to {high:.2f}" for low, high in ends.values()
        )
        told.append(
            f"{pair.first} less {pair.second}: {tukey} by Tukey, {games_howell} by Games and Howell"
        )
    name_rows(right, names)
    right.set_ylim(len(names) - 0.5, -0.5)
    right.axvline(0, color=BLACK, linewidth=1)
    right.set_xlabel("difference, 95 % interval")
    right.grid(alpha=0.3, axis="x")
    legend_below(picture, 2)
    title = "Both tests say the same of every pair"
    if apart:
        title = f"The two tests disagree on {' and on '.join(apart)}"
    picture.suptitle(title)
    spreads = [f"{method} {x.std(ddof=1):.2f}" for method, x in groups.items()]
    picture.alt = (
        f"Left, the final average rewards of each method's robots; SDs: {', '.join(spreads)}. "
        f"Right, 95 % intervals of the differences. {'; '.join(told)}."
    )
    return picture


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
            look = (
                {"fmt": "s", "color": VERMILION}
                if turned
                else {"fmt": "o", "color": BLUE}
            )
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
        [], [], xerr=[], fmt="s", color=VERMILION, label="ours, opposite to the paper"
    )
    axes[0].plot([], [], "D", color=BLACK, markerfacecolor="none", label="the paper")
    legend_below(figure, 3)
    total = 3 * len(rows)
    figure.suptitle(
        f"{total - opposite} of {total} differences have the paper's direction, {alike} significantly; "
        f"{opposite} the opposite one, {len(shown)} significantly"
    )
    figure.alt = (
        f"Differences of three pairs of methods in {len(rows)} set-ups, beside the paper's: {opposite} of {total} are "
        f"opposite to it, and significantly so {len(shown)}: {'; '.join(shown)}. "
        f"Of the others {alike} are significant."
    )
    return figure
