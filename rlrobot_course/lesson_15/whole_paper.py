"""The whole paper: its differences of means, those of our report, and a picture of both."""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from scipy import stats

from rlrobot_course.figures.plots import BLACK, BLUE, GREY, RED, Picture, plain
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


class Difference(NamedTuple):
    """A difference of two methods in one set-up, turned so that the paper's direction is the positive one.

    ours, half: of ours, the difference and half of its interval; theirs: the paper's; p: of ours by Tukey's test
    """

    ours: float
    half: float
    theirs: float
    p: float

    @property
    def verdict(self) -> str:
        """What can be said of ours: "as the paper", "other way" or "cannot tell"."""
        if self.p >= 0.05:
            return "cannot tell"
        return "as the paper" if self.ours > 0 else "other way"


def differences() -> dict[str, dict[str, Difference]]:
    """Set-up -> pair, as "first less second" -> their difference."""
    found: dict[str, dict[str, Difference]] = {}
    for name, (task, groups) in set_ups().items():
        within, n = Anova.of(list(groups.values())), len(groups[METHODS[0]])
        critical = stats.studentized_range.ppf(0.95, 3, within.df_within)
        half = float(critical * np.sqrt(within.ms_within / n))
        found[name] = {}
        for pair, theirs in zip(Tukey.of(groups).pairs, PAPER[task], strict=True):
            sign = 1 if theirs > 0 else -1
            what = f"{pair.first} less {pair.second}"
            ours = sign * pair.difference
            found[name][what] = Difference(ours, half, abs(theirs), pair.p)
    return found


def report_finding(found: Mapping[str, Mapping[str, Difference]]) -> str:
    """How many differences are clearly as the paper found, clearly the other way, and too uncertain to tell."""
    verdicts = [one.verdict for pairs in found.values() for one in pairs.values()]
    return (
        f"{verdicts.count('as the paper')} of {len(verdicts)} differences are clearly as the paper found, "
        f"{verdicts.count('other way')} clearly the other way; "
        f"{verdicts.count('cannot tell')} are too uncertain to tell"
    )


ROBOT_OF = {"wander": "Wandering", "arm": "Arm", "navigation": "Way to a goal", "giraff": "Giraff"}  # fmt: skip
LOOKS = {
    "as the paper": (BLUE, "o", BLUE),
    "other way": (RED, "s", RED),
    "cannot tell": (GREY, "o", "white"),
}


def plot_report() -> Picture:
    """Differences of three pairs of methods in each set-up, turned so that right is the paper's direction."""
    found = differences()
    rows, lines = _in_groups(list(found))
    figure = Picture(figsize=(8.4, 1.9 + 0.24 * lines))
    note = "difference in reward a step, 95 % interval (Tukey); right: the paper's direction; |: what the paper found"
    figure.headline(report_finding(found), note)
    axes = figure.subplots(1, 3, sharey=True, sharex=True)
    pairs = list(combinations(METHODS, 2))
    for ax, (first, second) in zip(axes, pairs, strict=True):
        here = {name: found[name][f"{first} less {second}"] for name in found}
        _draw_pair(ax, f"{first}\nless {second}", here, rows)
    axes[0].set_ylim(lines - 0.5, -0.7)
    names = {
        row: plain(name.partition("_")[2].replace("wander_", ""))
        for name, row in rows.items()
    }
    axes[0].set_yticks(list(names), list(names.values()))
    across = axes[0].get_yaxis_transform()
    for group, row in _heads(rows).items():
        axes[0].text(-0.04, row - 1, group, transform=across, ha="right", va="center", weight="bold")  # fmt: skip
    told = [one for pairs_ in found.values() for one in pairs_.values()]
    opposite = sum(one.ours < 0 for one in told)
    shown = [
        f"{name}: {what}"
        for name, its in found.items()
        for what, one in its.items()
        if one.verdict == "other way"
    ]
    alike = sum(one.verdict == "as the paper" for one in told)
    figure.alt = (
        f"Differences of three pairs of methods in {len(found)} set-ups, beside the paper's: {opposite} of {len(told)} "
        f"are opposite to it, and significantly so {len(shown)}: {'; '.join(shown)}. "
        f"Of the others {alike} are significant."
    )
    return figure


def _robot(name: str) -> str:
    """What the robot of a set-up does."""
    return ROBOT_OF[name.partition("_")[0]]


def _in_groups(names: Sequence[str]) -> tuple[dict[str, int], int]:
    """The row of each set-up, with a free one before the first of each robot; and how many rows there are."""
    rows: dict[str, int] = {}
    row, before = 0, ""
    for name in names:
        row += _robot(name) != before
        before = _robot(name)
        rows[name] = row
        row += 1
    return rows, row


def _heads(rows: Mapping[str, int]) -> dict[str, int]:
    """The first row of each robot."""
    heads: dict[str, int] = {}
    for name, row in rows.items():
        heads.setdefault(_robot(name), row)
    return heads


def _draw_pair(
    ax: Axes, title: str, here: Mapping[str, Difference], rows: Mapping[str, int]
) -> None:
    """The differences of one pair of methods, by set-up."""
    ax.set_title(title, weight="bold", linespacing=1.1, pad=24)
    ax.axvspan(0, 100, color=BLUE, alpha=0.07, linewidth=0, zorder=0)
    ax.axvline(0, color=GREY, linewidth=1)
    ax.spines["bottom"].set_visible(False)
    for name, one in here.items():
        colour, mark, face = LOOKS[one.verdict]
        look = {"color": colour, "markerfacecolor": face, "markersize": 5}
        ax.errorbar(one.ours, rows[name], xerr=one.half, fmt=mark, **look)
        y = [rows[name] - 0.4, rows[name] + 0.4]
        ax.plot([one.theirs, one.theirs], y, color=BLACK, linewidth=1.5, zorder=4)
    verdicts = [one.verdict for one in here.values()]
    for x, verdict, side in (
        (-0.15, "other way", "right"),
        (0.15, "as the paper", "left"),
    ):
        text = f"{verdicts.count(verdict)} {verdict}"
        colour, *_ = LOOKS[verdict]
        look = {"color": colour, "weight": "bold", "ha": side, "va": "bottom"}
        ax.text(x, 1.01, text, transform=ax.get_xaxis_transform(), **look)
    ax.set_xlim(-5.5, 5.5)
