"""The figures of lesson 20: what became of agents that were taught."""

from collections.abc import Mapping

from rlrobot_course.figures.plots import (
    BLUE,
    GREY,
    RED,
    Picture,
    chart,
    name_rows,
    plain,
)
from rlrobot_course.figures.rows import Values, compared, plot_groups
from rlrobot_edu.show.palette import LIGHT

# Colour and mark of the teacher and of its two pupils, and where their numbers stand [points above the mark]
LOOKS = ((GREY, "D", -7), (RED, "s", 6), (BLUE, "o", 6))


def plot_dots(
    groups: Mapping[str, Values], hero: str, rival: str, what: str, when: str = ""
) -> Picture:
    """One dot an agent, and the mean of each group; the title compares two of them.

    groups: a number for each agent, by the name of the group; what: the numbers, with their unit; when: of them
    """
    return plot_groups(groups, compared(groups, hero, rival), what, when, hero)


def worth_finding(worth: Mapping[str, Mapping[str, float]]) -> str:
    """The lesson on which two pupils disagree most, and what they say; the first number is what the teacher earned."""

    def apart(teacher: str) -> float:
        _, one, other = worth[teacher].values()
        return abs(one - other)

    teacher = max(worth, key=apart)
    earned, *_ = worth[teacher].values()
    _, first, second = worth[teacher]
    one, other = worth[teacher][first], worth[teacher][second]
    said = f"{first} values the {teacher} lesson at {one:.0f}, {second} at {other:.0f}; its teacher earned {earned:.0f}"
    return said.replace("-", "−")


def plot_worth(worth: Mapping[str, Mapping[str, float]]) -> Picture:
    """What two pupils learned of teachers: the mean Q of the lesson's pairs, by teacher and pupil.

    worth: for each teacher what it earned, then what each pupil says, all as values
    """
    note = "mean value in the steps of a lesson (discounted reward); one pupil of each kind, 100 times through it"
    size = (7.2, 1.5 + 0.8 * len(worth))
    figure, ax = chart(size, "", "", worth_finding(worth), "x", note)
    told = []
    for row, values in enumerate(worth.values()):
        ends = [min(values.values()), max(values.values())]
        ax.plot(ends, [row, row], color=GREY, linewidth=1, zorder=1)
        for i, (name, value) in enumerate(values.items()):
            colour, mark, place = LOOKS[i]
            ax.plot(value, row, mark, color=colour, markersize=8, zorder=3)
            words = f"teacher {value:.1f}" if i == 0 else f"{name}\n{value:.1f}"
            ax.annotate(
                plain(words.replace("-", "−")),
                (value, row),
                (0, place),
                textcoords="offset points",
                ha="center",
                va="bottom" if place > 0 else "top",
                linespacing=1.1,
                color=LIGHT["faint"] if i == 0 else colour,
            )
    for name in next(iter(worth.values())):
        told += [f"{teacher}, {name}: {by[name]:.1f}" for teacher, by in worth.items()]
    ax.axvline(0, color=GREY, linewidth=1)
    name_rows(ax, list(worth))
    ax.set_ylim(len(worth) - 0.5, -0.75)
    ax.margins(x=0.08)
    figure.alt = (
        f"Marks, the mean value in the steps of each lesson. {'; '.join(told)}."
    )
    return figure
