"""The figures of appendix 20: what a lesson shows, and what became of those who had it."""

from collections.abc import Mapping, Sequence

import numpy as np

from rlrobot_course.plots import BLUE, CURVES, VERMILION, Picture, chart, name_rows, plain
from rlrobot_course.runs import mean_and_half
from rlrobot_edu import History, Recording

MARKS = "osD^vPX"  # of the groups, beside their colours


def plot_dots(
    groups: Mapping[str, Sequence[float] | np.ndarray], title: str, what: str, middle: bool = False
) -> Picture:
    """One dot an agent, and the mean of each group with its 95 % interval.

    groups: a number for each agent, by the name of the group; what: the numbers, with their unit, for the axis
    middle: show the median instead, for numbers that were cut off
    """
    figure, ax = chart((7, 1.3 + 0.55 * len(groups)), what, "", title, grid="x", letters=11)
    told = []
    for row, (values, mark) in enumerate(zip(groups.values(), MARKS, strict=False)):
        mean, half = (float(np.median(values)), None) if middle else mean_and_half(values)
        ax.plot(np.sort(values), row + np.linspace(-0.15, 0.15, len(values)), mark, color=BLUE, alpha=0.5, markersize=5)
        ax.errorbar(mean, row, xerr=half, fmt="|", color=VERMILION, markersize=20, markeredgewidth=2, capsize=5)
        told.append(f"{mean:.0f}" if half is None else f"{mean:.1f} ± {half:.1f}")
    name_rows(ax, list(groups))
    ax.set_ylim(len(groups) - 0.5, -0.5)
    ax.errorbar([], [], xerr=None if middle else [], fmt="|", color=VERMILION, markersize=12, capsize=5,
                label="median" if middle else "mean, 95 % interval")  # fmt: skip
    figure.legend(loc="outside lower right")
    centres = "Medians" if middle else "Means with 95 % intervals"
    figure.alt = f"Dots, one an agent, {what}. {centres}: " + "; ".join(
        f"{name} {numbers}" for name, numbers in zip(groups, told, strict=True)
    )
    return figure


def plot_shown(recording: Recording, title: str = "What the lesson shows") -> Picture:
    """How often the lesson was in each of its states, the frequent ones first."""
    counts = np.sort(np.unique(recording.s, return_counts=True)[1])[::-1]
    share, n_states = counts[:5].sum() / len(recording), recording.source.states.n
    x = f"the states shown, {len(counts)} of {n_states}, the frequent ones first"
    figure, ax = chart((6.5, 2.8), x, "steps in it", title, grid="y", letters=11)
    ax.bar(np.arange(1, len(counts) + 1), counts, width=0.9, color=BLUE)
    figure.alt = (
        f"Bars: steps in each of the {len(counts)} states shown, of {n_states}. The five most frequent have "
        f"{share:.0%} of the {len(recording)} steps; {(counts == 1).sum()} states were seen in one step only."
    )
    return figure


def plot_familiar(
    groups: Mapping[str, Sequence[History]], recording: Recording, title: str, block: int = 100
) -> Picture:
    """How much of the time agents are in states that the recording shows, block by block.

    groups: histories with their states kept, by name; block: steps of a point
    """
    figure, ax = chart((6.5, 3.6), "step", f"in states of the lesson (% of {block} steps)", title, letters=11)
    told = []
    for (name, runs), (colour, dashes), mark in zip(groups.items(), CURVES, MARKS, strict=False):
        share = 100 * familiar(runs, recording).mean(axis=0).reshape(-1, block).mean(axis=1)
        ax.plot(block * np.arange(1, len(share) + 1), share, mark, color=colour, linestyle=dashes, label=plain(name))
        told.append(f"{name}: {share[0]:.0f} % at first, {share[-1]:.0f} % in the end")
    ax.set_ylim(0, 100)
    figure.legend(loc="outside lower center", ncols=len(groups))
    figure.alt = f"How much of the time agents are in states that the lesson shows. {'; '.join(told)}."
    return figure


def familiar(runs: Sequence[History], recording: Recording) -> np.ndarray:
    """Whether each step began in a state that the recording shows; bool array (repetitions, steps)."""
    return np.isin([run.s for run in runs], recording.s)


def plot_worth(worth: Mapping[str, Mapping[str, float]], title: str) -> Picture:
    """What pupils learned of teachers: bars of the mean Q of the lesson's pairs, by teacher and pupil."""
    x = "mean value in the steps of the lesson (reward, discounted)"
    figure, ax = chart((6.8, 3.4), x, "", title, grid="x", letters=11)
    pupils, told = list(next(iter(worth.values()))), []
    rows, height = np.arange(len(worth)), 0.8 / len(pupils)
    for i, (pupil, (colour, _), hatch) in enumerate(zip(pupils, CURVES, ("", "//", ".."), strict=False)):
        values = [by[pupil] for by in worth.values()]
        bars = ax.barh(rows + (i - (len(pupils) - 1) / 2) * height, values, height, color=colour, hatch=hatch,
                       edgecolor="white", label=plain(pupil))  # fmt: skip
        ax.bar_label(bars, fmt="%.1f", padding=3, fontsize=9)
        told += [f"{teacher}, {pupil}: {value:.1f}" for teacher, value in zip(worth, values, strict=True)]
    ax.axvline(0, color="#505050", linewidth=1)
    name_rows(ax, list(worth))
    ax.margins(x=0.12)
    figure.legend(loc="outside lower center", ncols=len(pupils))
    figure.alt = f"Bars, the mean value in the steps of each lesson. {'; '.join(told)}."
    return figure
