"""Figures of several experiments: differences beside the paper's, preliminary tests, and the arm's shuttle."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from paper import paper
from paper.experiments import ARMS, PRELIMINARIES
from paper.outcome import SHUTTLES, Outcome, half_width, interval, shuttles
from rlrobot_course.figures.runs import error_bars
from rlrobot_edu.files import write_whole
from rlrobot_edu.show.palette import BLACK, BLUE, CURVES, GREY
from rlrobot_edu.show.picture import Picture

THREE = paper.THREE
PAIRS = ((THREE[0], THREE[1]), (THREE[0], THREE[2]), (THREE[1], THREE[2]))

Outcomes = Mapping[str, Outcome]


def write_figures(folder: Path, outcomes: Outcomes) -> dict[str, str]:
    """Write all figures for which there are outcomes; returns them by name, in Markdown."""
    drawn = {
        "differences": differences_figure(outcomes),
        "preliminaries": preliminaries_figure(outcomes),
        "shuttle": shuttle_figure(outcomes),
    }
    for name, picture in drawn.items():
        if picture:
            write_whole(folder / f"{name}.png", picture.png())
    return {
        name: f"![{picture.alt}]({name}.png)"
        for name, picture in drawn.items()
        if picture
    }


def differences_figure(outcomes: Outcomes) -> Picture | None:
    """Raw differences of the three methods: the paper's and ours, with Tukey's simultaneous 95 % intervals."""
    rows = [
        (o, length)
        for key, o in outcomes.items()
        if key.startswith("robot_")
        for length in o.final
    ]
    rows = [(o, length) for o, length in rows if o.experiment.pairs]
    if not rows:
        return None
    names = [
        f"{o.experiment.task}, {length} (n = {len(o.final[length][THREE[0]])})"
        for o, length in rows
    ]
    picture = Picture((11, 1.6 + 0.34 * len(rows)))
    y = np.arange(len(rows), dtype=float)
    for number, (ax, (first, second)) in enumerate(
        zip(picture.subplots(1, 3, sharey=True), PAIRS, strict=True)
    ):
        theirs = [_papers(o.experiment, first, second) for o, _ in rows]
        ours = [
            (o.pair(first, second, length)[0], interval(o.final[length]))
            for o, length in rows
        ]
        for points, shift, marker, colour, name in (
            (theirs, -0.16, "D", BLACK, "the paper"), (ours, 0.16, "o", BLUE, "here")
        ):  # fmt: skip
            middle, width = zip(*points, strict=True)
            ax.errorbar(
                middle, y + shift, xerr=width, fmt=marker, color=colour, capsize=3, markersize=5,
                fillstyle="none" if name == "the paper" else "full", label=name if number == 0 else None,
            )  # fmt: skip
        ax.axvline(0, color=GREY, linewidth=1)
        ax.set(
            title=f"{first} less {second}",
            xlabel="difference of the mean final\naverage rewards per step",
        )
        ax.set_yticks(y, names)
        ax.grid(axis="x", alpha=0.3)
    ax.invert_yaxis()
    picture.legend(loc="outside lower center", ncols=2)
    picture.alt = (
        f"Differences of the mean final average rewards of three pairs of methods in {len(rows)} set-ups: the paper's "
        "as open diamonds, ours as full circles, with 95 % intervals. The tables of the tasks have the numbers."
    )
    return picture


def _papers(experiment, first: str, second: str) -> tuple[float, float]:
    pair = next(p for p in experiment.pairs if {p.better, p.worse} == {first, second})
    sign, task = (1 if pair.better == first else -1), experiment.task
    width = half_width(paper.ANOVA[task][0], paper.repetitions(task))
    return sign * paper.difference(task, pair), width


def preliminaries_figure(outcomes: Outcomes) -> Picture | None:
    """Every preliminary comparison on the model and on the robot."""
    found = []
    for key, title, _, best in PRELIMINARIES:
        both = [outcomes.get(f"preliminary_{key}{end}") for end in ("", "_robot")]
        if all(both):
            found.append((title, best, both))
    if not found:
        return None
    picture = Picture((11, 3.1 * -(-len(found) // 3)))
    axes = np.ravel(picture.subplots(-(-len(found) // 3), 3, squeeze=False))
    for ax in axes[len(found) :]:
        ax.set_axis_off()
    told = []
    for ax, (title, best, both) in zip(axes, found, strict=False):
        for outcome, (colour, dashes), marker, name in zip(
            both, CURVES, "os", ("model", "robot"), strict=False
        ):
            labels, final = zip(*outcome.final[outcome.longest].items(), strict=True)
            bars = [error_bars(x[:, None]) for x in final]
            mean, width = [m[0] for m, _ in bars], np.hstack([w for _, w in bars])
            shown = name if ax is axes[0] else None
            dashes = (
                dashes if "=" in best else "none"
            )  # between methods there is nothing to join
            ax.errorbar(
                range(len(labels)),
                mean,
                width,
                color=colour,
                ls=dashes,
                marker=marker,
                capsize=3,
                label=shown,
            )
            told.append(f"{title} On the {name} {labels[int(np.argmax(mean))]} is best")
        ax.set_xticks(
            range(len(labels)),
            [f"{x}*" if x == best else x for x in labels],
            fontsize=8,
        )
        ax.set(title=title, ylabel="average reward per step")
        ax.title.set_fontsize(10)
        ax.grid(alpha=0.3)
    picture.legend(
        title="* the paper's choice; bars: 95 % intervals",
        loc="outside lower center",
        ncols=2,
    )
    picture.alt = (
        "Mean final average reward by method or parameter. " + "; ".join(told) + "."
    )
    return picture


_ARM_KINDS = {
    "robot": "",
    "cause_contact": ", contact alone",
    "cause_traces": ", no traces",
}


def shuttle_figure(outcomes: Outcomes) -> Picture | None:
    """Histograms of the arms' final averages, with the two shuttles marked."""
    found = {
        task + words: outcomes[key]
        for task in ARMS for kind, words in _ARM_KINDS.items() if (key := f"{kind}_{task}") in outcomes
    }  # fmt: skip
    if not found:
        return None
    rows = -(-len(found) // 3)
    picture = Picture((11, 0.6 + 3 * rows))
    axes: list[Axes] = list(np.ravel(picture.subplots(rows, 3, squeeze=False)))
    for ax in axes[len(found) :]:
        ax.set_axis_off()
    edges, told = np.arange(-1.25, 10.3, 0.5), []
    for ax, (name, outcome) in zip(axes, found.items(), strict=False):
        for (label, final), (colour, dashes), hatch in zip(
            outcome.final[outcome.longest].items(),
            CURVES,
            ("", "//", ".."),
            strict=False,
        ):
            ax.hist(final, edges, histtype="step", color=colour, linestyle=dashes, hatch=hatch, linewidth=1.6,
                    label=label if ax is axes[0] else None)  # fmt: skip
            told.append(f"{name}, {label}: {shuttles(final):.0%} near a mark")
        for level in SHUTTLES:
            ax.axvline(level, color=BLACK, linewidth=1, linestyle=":")
            ax.text(
                level,
                1.0,
                f"{level:g}",
                ha="center",
                va="bottom",
                transform=ax.get_xaxis_transform(),
            )
        ax.set(xlabel="final average reward per step", ylabel="agents")
        ax.set_title(f"{name}, {outcome.longest}", pad=16, fontsize=10)
    picture.legend(loc="outside lower center", ncols=3)
    picture.alt = f"Histograms of final average rewards of the arm, 2.0 and 4.5 marked. {'; '.join(told)}."
    return picture
