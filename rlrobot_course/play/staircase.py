"""The staircase of the learner's robot: for each lesson a stair, as high as what its robots earn a step."""

from collections.abc import Iterable, Mapping, Sequence
from textwrap import wrap
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import BLUE, GREY, Picture, chart, plain
from rlrobot_course.play.challenge import Score
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.style import DPI, LETTERS

SIZE = (560 / DPI, 380 / DPI)
BOTTOM, TOP = -0.4, 6.0  # reward a step; the same in all lessons if it suffices
HALF = 0.42  # of a tread's width; from one place to the next it is 1
LETTERS_A_LINE = 9  # below a stair
DOT = 0.025  # height of a dot, as a share of the axes'
SIDES = (0.0, 0.09, -0.09, 0.18, -0.18, 0.27, -0.27, 0.36, -0.36)  # the nearest first

# By the owner of the functions: colour of a stair, inside of its dots, and what the note says of it
LOOKS = {
    "your": (BLUE, BLUE, "Blue: your functions."),
    "partly your": (BLUE, LIGHT["paper"], "Rings: partly yours."),
    "the given": (GREY, GREY, "Grey: given functions."),
}
AGAINST = {"06": "04"}  # a lesson that changes something in another than the last one


class Stair(NamedTuple):
    """What the robots of a lesson earn.

    label: what the lesson adds; score: reward a step
    owner: of the lesson's functions, as `my_functions.owner_of` says it
    each: the reward a step of each robot; empty if it was not kept
    """

    label: str
    score: Score
    owner: str = "the given"
    each: tuple[float, ...] = ()


class Climb(NamedTuple):
    """How much more the robots of a lesson earn a step than those of an earlier one, its start."""

    start: str
    more: float
    may_be_chance: bool

    def __str__(self) -> str:
        word = "more" if self.more > 0 else "less"
        chance = ", which may be chance" if self.may_be_chance else ""
        return f"{abs(self.more):.2f} {word} than in lesson {self.start}{chance}"


def climb(stairs: Mapping[str, Stair], lesson: str) -> Climb | None:
    """From the stair that a lesson is compared with to its own; None for the first lesson."""
    before = [other for other in stairs if other < lesson]
    if not before:
        return None
    start = AGAINST.get(lesson, before[-1])
    low, high = stairs[start].score, stairs[lesson].score
    more = high.mean - low.mean
    return Climb(start, more, abs(more) < np.hypot(low.half, high.half))


def finding(stairs: Mapping[str, Stair], is_last: bool = False) -> str:
    """What the latest lesson has changed; after the last one also what all of them have."""
    lessons = [*stairs]
    first, latest = lessons[0], lessons[-1]
    stair = stairs[latest]
    robot = "The robot" if stair.owner == "the given" else "Your robot"
    text = f"{robot} earns {number(stair.score.mean)} a step"
    its = climb(stairs, latest)
    if its is None:
        return f"{text} {stair.label}"
    text = f"{text}, {its}"
    if is_last:
        in_all = climb({first: stairs[first], latest: stair}, latest)
        text = f"{text}, {in_all}"
    return text


def plot_stairs(stairs: Mapping[str, Stair], labels: Mapping[str, str]) -> Picture:
    """A stair for each lesson so far, by its number, and a place for each one that is still to come.

    labels: what the lessons of the course add, by their numbers
    """
    lessons, latest = [*labels], [*stairs][-1]
    title = finding(stairs, is_last=latest == lessons[-1])
    figure, ax = chart(SIZE, "", "", title, grid="y", note=note(stairs))
    low, high = limits(stairs.values())
    ax.set(xlim=(-0.55, len(lessons) - 0.45), ylim=(low, high))
    ax.locator_params(axis="y", nbins=4)
    ax.spines["bottom"].set_visible(False)
    name_places(ax, labels, latest)
    for at, lesson in enumerate(lessons):
        if lesson not in stairs:
            draw_place(ax, at)
            continue
        draw_stair(ax, at, stairs[lesson], DOT * (high - low))
        its = climb(stairs, lesson)
        if its:
            start = lessons.index(its.start)
            heights = (stairs[its.start].score.mean, stairs[lesson].score.mean)
            colour, *_ = LOOKS[stairs[lesson].owner]
            draw_riser(ax, (start, at), heights, colour, its.may_be_chance)
    figure.alt = in_words(stairs, labels)
    return figure


def note(stairs: Mapping[str, Stair]) -> str:
    """What is plotted, and whose functions have which look."""
    plotted = f"Reward a step in the first hour: {robots(stairs)} (dots), mean (line), 95 % interval (band)."
    owners = {stair.owner for stair in stairs.values()}
    signs = [said for owner, (_, _, said) in LOOKS.items() if owner in owners]
    climbs = [climb(stairs, lesson) for lesson in stairs]
    if any(its and its.may_be_chance for its in climbs):
        signs.append("Dashed: may be chance.")
    return f"{plotted}\n{' '.join(signs)}"


def robots(stairs: Mapping[str, Stair]) -> str:
    """How many robots each stair is of."""
    numbers = {len(stair.each) for stair in stairs.values() if stair.each}
    return f"{' or '.join(map(str, sorted(numbers)))} robots".strip()


def limits(stairs: Iterable[Stair]) -> tuple[float, float]:
    """The lowest and the highest reward of the axes, with room for a number above all that is drawn."""
    low, high = BOTTOM, TOP
    for stair in stairs:
        mean, half = stair.score
        low = min([low, mean - half, *stair.each])
        high = max([high, mean + half, *stair.each])
    if high > TOP:
        high += 0.1 * (high - low)
    return low, high


def name_places(ax: Axes, labels: Mapping[str, str], latest: str) -> None:
    """The number of each lesson and what it adds; those of the latest one in bold."""
    ax.set_xticks([])
    for at, (lesson, label) in enumerate(labels.items()):
        look = {"color": LIGHT["faint"]}
        if lesson == latest:
            look = {"color": LIGHT["ink"], "weight": "bold"}
        for row, line in enumerate([lesson, *wrap(label, LETTERS_A_LINE)]):
            ax.annotate(
                plain(line),
                (at, 0),
                (0, -1.2 * LETTERS * (row + 1)),
                xycoords=("data", "axes fraction"),
                textcoords="offset points",
                ha="center",
                **look,
            )


def draw_place(ax: Axes, at: float) -> None:
    """The place of a lesson that is still to come."""
    draw_tread(ax, at, 0, LIGHT["line"])
    write_above(ax, at, 0, "?", color=LIGHT["faint"])


def draw_stair(ax: Axes, at: float, stair: Stair, tall: float) -> None:
    """Dots for the robots, a tread for their mean and a band for its interval. tall: height of a dot"""
    mean, half = stair.score
    colour, inside, _ = LOOKS[stair.owner]
    ends = (at - HALF, at + HALF)
    ax.fill_between(
        ends, mean - half, mean + half, color=colour, alpha=0.2, linewidth=0
    )
    draw_tread(ax, at, mean, colour)
    ax.plot(
        [at + side for side in sides(stair.each, tall)],
        stair.each,
        "o",
        color=colour,
        markerfacecolor=inside,
        markersize=4,
        alpha=0.65,
    )
    highest = max([mean + half, *stair.each])
    ink = LIGHT["faint" if stair.owner == "the given" else "ink"]
    write_above(ax, at, highest, number(mean), color=ink, weight="bold")


def draw_tread(ax: Axes, at: float, height: float, colour: str) -> None:
    """A thick line as wide as a stair."""
    ends = (at - HALF, at + HALF)
    ax.plot(
        ends,
        (height, height),
        color=colour,
        linewidth=3,
        solid_capstyle="butt",
        zorder=3,
    )


def write_above(ax: Axes, at: float, height: float, text: str, **look: str) -> None:
    """A text over the middle of a stair; look: as of matplotlib's texts."""
    ax.annotate(
        text, (at, height), (0, 4), textcoords="offset points", ha="center", **look
    )


def draw_riser(
    ax: Axes,
    places: tuple[int, int],
    heights: tuple[float, float],
    colour: str,
    may_be_chance: bool,
) -> None:
    """From one tread to another: level to its edge, then up or down; grey and dashed if it may be chance."""
    (start, at), (low, high) = places, heights
    edge = at - HALF
    dashes = "-"
    if may_be_chance:
        colour, dashes = GREY, "--"
    ax.plot(
        (start + HALF, edge, edge),
        (low, low, high),
        color=colour,
        linestyle=dashes,
        linewidth=1.3,
        zorder=1,
    )


def sides(heights: Sequence[float], tall: float) -> list[float]:
    """How far each dot goes to the side, so that none hides another. tall: height of a dot"""
    chosen: list[float] = []
    for height in heights:
        near = [abs(height - other) < tall for other in heights[: len(chosen)]]
        taken = [side for side, is_near in zip(chosen, near, strict=True) if is_near]
        free = [side for side in SIDES if side not in taken]
        chosen.append(free[0] if free else SIDES[-1])
    return chosen


def number(value: float) -> str:
    """A reward with two digits, and with the sign that is as wide as a plus."""
    return f"{value:.2f}".replace("-", "−")


def in_words(stairs: Mapping[str, Stair], labels: Mapping[str, str]) -> str:
    """The picture for readers who cannot see it."""
    parts = []
    for lesson, (label, score, owner, _) in stairs.items():
        its = climb(stairs, lesson)
        parts.append(f"lesson {lesson}, {label}: {score} ({owner} functions)")
        if its:
            parts[-1] += f", {its}"
    text = f"What {robots(stairs)} earn a step in their first hour, means with 95 % intervals: {'; '.join(parts)}."
    latest = [*stairs][-1]
    each = stairs[latest].each
    if each:
        text += f" The robots of lesson {latest} earn {number(min(each))} to {number(max(each))}."
    to_come = [
        f"{lesson} {label}" for lesson, label in labels.items() if lesson not in stairs
    ]
    if to_come:
        text += f" Still to come: {', '.join(to_come)}."
    return text
