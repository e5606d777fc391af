"""Figures of several experiments: differences beside the paper's, preliminary tests, and the arm's shuttle."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from paper import paper
from paper.experiments import ARMS, PRELIMINARIES, Length
from paper.outcome import NEAR, SHUTTLES, Outcome, half_width, interval, shuttles
from rlrobot_course.figures.plots import name_rows
from rlrobot_course.figures.runs import error_bars
from rlrobot_edu.files import write_whole
from rlrobot_edu.show.palette import BLACK, BLUE, GREY, LIGHT, RED
from rlrobot_edu.show.picture import Picture

THREE = paper.THREE
PAIRS = ((THREE[0], THREE[1]), (THREE[0], THREE[2]), (THREE[1], THREE[2]))
WIDTH = 8.4  # inch, of all figures
FAINT = LIGHT["faint"]

Outcomes = Mapping[str, Outcome]


def write_figures(folder: Path, outcomes: Outcomes) -> dict[str, str]:
    """Write all figures for which there are outcomes; returns them by name, in Markdown."""
    drawn = {
        "differences": differences_figure(outcomes),
        "preliminaries": preliminaries_figure(outcomes),
        "shuttle": shuttle_figure(outcomes),
    }
    made = {}
    for name, picture in drawn.items():
        if picture:
            write_whole(folder / f"{name}.png", picture.still().data)
            made[name] = f"![{picture.alt}]({name}.png)"
    return made


class Look(NamedTuple):
    """A difference of two methods in a set-up, the paper's and ours, with half of their simultaneous 95 % intervals."""

    theirs: float
    their_half: float
    ours: float
    our_half: float

    @property
    def paper_is_sure(self) -> bool:
        """Whether the paper's interval leaves out 0."""
        return abs(self.theirs) > self.their_half

    @property
    def sign(self) -> int:
        """1: ours is significant and as the paper's, -1: significant and the other way, 0: not significant."""
        if abs(self.ours) <= self.our_half:
            return 0
        return 1 if self.ours * self.theirs > 0 else -1


def differences_figure(outcomes: Outcomes) -> Picture | None:
    """Differences of the three methods: the paper's and ours, with Tukey's simultaneous 95 % intervals."""
    rows = [
        (outcome, length)
        for key, outcome in outcomes.items()
        if key.startswith("robot_") and outcome.experiment.pairs
        for length in outcome.final
    ]
    if not rows:
        return None
    picture = Picture((WIDTH, 2 + 0.34 * len(rows)))
    columns = {pair: [look_at(*row, *pair) for row in rows] for pair in PAIRS}
    looks = [look for column in columns.values() for look in column]
    note = (
        "Difference of the mean final average rewards a step, 95 % intervals. Grey diamonds: the paper. Circles: here; "
        "blue as the paper's, red the other way, hollow not significant. n: our robots a method."
    )
    picture.headline(differences_title(looks), note)
    axes = picture.subplots(1, 3, sharey=True)
    for ax, (pair, column) in zip(axes, columns.items(), strict=True):
        _draw_looks(ax, column)
        ax.set_title("{} less\n{}".format(*pair))
    name_rows(axes[0], [_name_of(*row) for row in rows])
    picture.alt = (
        f"{differences_title(looks)}. Differences of the mean final average rewards of three pairs of methods in "
        f"{len(rows)} set-ups, the paper's and ours, with 95 % intervals. The tables of the tasks have the numbers."
    )
    return picture


def differences_title(looks: Iterable[Look]) -> str:
    """How many of the paper's significant differences are significant here, and how many the other way."""
    signs = [look.sign for look in looks if look.paper_is_sure]
    same, other = signs.count(1), signs.count(-1)
    return (
        f"The paper is sure of {len(signs)} of these differences: here {same} are significant, too, and {other} the"
        " other way round"
    )


def look_at(outcome: Outcome, length: Length, first: str, second: str) -> Look:
    """The first method less the second in one set-up."""
    task = outcome.experiment.task
    pair = next(
        p for p in outcome.experiment.pairs if {p.better, p.worse} == {first, second}
    )
    theirs = paper.difference(task, pair)
    if pair.better != first:
        theirs = -theirs
    their_half = half_width(paper.ANOVA[task][0], paper.repetitions(task))
    ours, _ = outcome.pair(first, second, length)
    return Look(theirs, their_half, ours, interval(outcome.final[length]))


def _name_of(outcome: Outcome, length: Length) -> str:
    n = len(outcome.final[length][THREE[0]])
    return f"{outcome.experiment.task}, {length} (n = {n})"


def _draw_looks(ax: Axes, looks: Sequence[Look]) -> None:
    ax.axvline(0, color=GREY, linewidth=1)
    colours = {1: BLUE, -1: RED, 0: FAINT}
    for y, look in enumerate(looks):
        ax.errorbar(look.theirs, y - 0.18, xerr=look.their_half, fmt="D", color=GREY,
                    markersize=4, linewidth=1.2)  # fmt: skip
        colour = colours[look.sign]
        ax.errorbar(look.ours, y + 0.18, xerr=look.our_half, fmt="o", color=colour,
                    markersize=5, linewidth=1.6, markerfacecolor=colour if look.sign else "white")  # fmt: skip
    ax.grid(axis="x")


class Question(NamedTuple):
    """A preliminary comparison: its title, the paper's choice, and what came of it on the model and on the robot."""

    title: str
    choice: str
    outcomes: dict[str, Outcome]  # by "model" and "robot"

    def best(self, world: str) -> str:
        """The label with the highest mean."""
        means = self.outcomes[world].means()
        return max(means, key=means.__getitem__)


def questions(outcomes: Outcomes) -> list[Question]:
    """The preliminary comparisons of which there are both outcomes."""
    found = []
    for key, title, _, choice in PRELIMINARIES:
        ends = {"model": f"preliminary_{key}", "robot": f"preliminary_{key}_robot"}
        if set(ends.values()) <= set(outcomes):
            both = {world: outcomes[end] for world, end in ends.items()}
            found.append(Question(title, choice, both))
    return found


def preliminaries_figure(outcomes: Outcomes) -> Picture | None:
    """Every preliminary comparison on the model and on the robot."""
    found = questions(outcomes)
    if not found:
        return None
    rows = -(-len(found) // 3)
    picture = Picture((WIDTH, 1 + 2.3 * rows))
    note = (
        "Mean final average reward a step in wander_1k, 95 % intervals. Blue circles: the robot. Grey squares, "
        "dashed: the model. *: the paper's choice."
    )
    picture.headline(preliminaries_title(found), note)
    axes = np.ravel(picture.subplots(rows, 3, squeeze=False))
    for ax in axes[len(found) :]:
        ax.set_axis_off()
    told = []
    for ax, question in zip(axes, found, strict=False):
        _draw_question(ax, question)
        for world in question.outcomes:
            told.append(f"{question.title} On the {world}: {question.best(world)}")
    picture.alt = f"{preliminaries_title(found)}. The best: {'; '.join(told)}."
    return picture


def preliminaries_title(found: Sequence[Question]) -> str:
    """How often the paper's choice has the highest mean."""
    hits = {}
    for world in ("model", "robot"):
        hits[world] = sum(one.best(world) == one.choice for one in found)
    return (
        f"The paper's choice has the highest mean in {hits['model']} of {len(found)} questions on the model, in "
        f"{hits['robot']} on the robot"
    )


def _draw_question(ax: Axes, question: Question) -> None:
    looks = {"model": (GREY, "--", "s"), "robot": (BLUE, "-", "o")}
    is_of_numbers = "=" in question.choice  # between methods there is nothing to join
    for world, (colour, dashes, marker) in looks.items():
        final = question.outcomes[world].final[question.outcomes[world].longest]
        bars = [error_bars(values[:, None]) for values in final.values()]
        means = [mean[0] for mean, _ in bars]
        halves = np.hstack([half for _, half in bars])
        ax.errorbar(
            range(len(means)), means, halves, color=colour, marker=marker, markersize=5, linewidth=1.6,
            linestyle=dashes if is_of_numbers else "none",
        )  # fmt: skip
    names = [f"{label}*" if label == question.choice else label for label in final]
    if is_of_numbers:
        ax.set_xlabel(names[0].split(" = ")[0])
        names = [name.split(" = ")[1] for name in names]
    else:
        names = [name.replace("+", "+\n") for name in names]
    ax.set_xticks(range(len(names)), names)
    ax.set_title(question.title.replace(", at", ",\nat"))
    ax.margins(x=0.12)
    ax.grid(axis="y")


_ARM_KINDS = {
    "robot": "",
    "cause_contact": ", contact alone",
    "cause_traces": ", no traces",
}


def shuttle_figure(outcomes: Outcomes) -> Picture | None:
    """The arms' final averages, one dot an arm, with the two shuttles marked."""
    found = {}
    for task in ARMS:
        for kind, words in _ARM_KINDS.items():
            if f"{kind}_{task}" in outcomes:
                outcome = outcomes[f"{kind}_{task}"]
                found[task + words] = outcome.final[outcome.longest]
    if not found:
        return None
    rows = -(-len(found) // 3)
    picture = Picture((WIDTH, 1 + 2.6 * rows))
    some = next(iter(found.values()))
    n = len(some[THREE[0]])
    note = (
        f"Final average reward a step after {outcome.longest}, {n} arms a method, one dot each. Red: within {NEAR:g} "
        f"of a shuttle, which pays {SHUTTLES[0]:g} or {SHUTTLES[1]:g} a step. At the right: their share."
    )
    picture.headline(shuttle_title(found), note)
    axes = np.ravel(picture.subplots(rows, 3, squeeze=False, sharex=True, sharey=True))
    for ax in axes[len(found) :]:
        ax.set_axis_off()
    told = []
    for ax, (name, groups) in zip(axes, found.items(), strict=False):
        _draw_heaps(ax, groups)
        ax.set_title(name)
        for label, values in groups.items():
            told.append(f"{name}, {label}: {100 * shuttles(values):.0f} %")
    picture.alt = f"{shuttle_title(found)}. Arms near a shuttle: {'; '.join(told)}."
    return picture


def shuttle_title(found: Mapping[str, Mapping[str, np.ndarray]]) -> str:
    """What share of TOSL's arms ends at a shuttle: as they are, and with each cause taken away."""
    shares = {}
    for kind, words in _ARM_KINDS.items():
        ends = [
            values
            for name, groups in found.items()
            if name.partition(",")[2] == words.removeprefix(",")
            for label, values in groups.items()
            if label.startswith("TOSL")
        ]
        if ends:
            shares[kind] = f"{100 * shuttles(np.concatenate(ends)):.0f} %"
    said = {
        "robot": "of TOSL's arms {} end at a shuttle",
        "cause_contact": "where contact alone pays {}",
        "cause_traces": "without traces {}",
    }
    told = [said[kind].format(share) for kind, share in shares.items()]
    title = "; ".join(told)
    return title[0].upper() + title[1:]


def heaps(values: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A dot for each value, in heaps: the middle of its bin, and its height in the heap from 1 on; arrays (n,)."""
    bins = np.searchsorted(edges, np.sort(values), side="right") - 1
    where = np.clip(bins, 0, len(edges) - 2)
    below = np.searchsorted(where, where)  # dots of lower bins
    height = np.arange(len(where)) - below + 1
    return (edges[where] + edges[where + 1]) / 2, height


def _draw_heaps(ax: Axes, groups: Mapping[str, np.ndarray]) -> None:
    edges = np.arange(-1.25, 10.3, 0.25)
    for row, values in enumerate(groups.values()):
        x, height = heaps(np.asarray(values), edges)
        y = row + 0.35 - 0.045 * (height - 1)
        is_near = np.abs(np.sort(values)[:, None] - SHUTTLES).min(axis=1) < NEAR
        for these, colour in ((is_near, RED), (~is_near, BLACK)):
            ax.plot(x[these], y[these], "o", color=colour, markersize=3)
        share = f" {100 * shuttles(values):.0f} %"
        ax.text(1, row, share, transform=ax.get_yaxis_transform(), color=RED, va="center")  # fmt: skip
    for level in SHUTTLES:
        ax.axvline(level, color=RED, linewidth=1, linestyle=":")
    ax.set_xticks([0, *SHUTTLES, 10], ["0", *(f"{level:g}" for level in SHUTTLES), "10"])  # fmt: skip
    if not ax.yaxis_inverted():
        name_rows(ax, list(groups))
