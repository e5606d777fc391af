"""What a robot's lasers see, and the bins into which it falls: rings round the robot, cut into sectors."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.patches import Wedge

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    SKY,
    Picture,
    centred,
    plain,
)
from rlrobot_edu import InputVariable, Task
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.style import SMALLEST
from rlrobot_edu.show.top_down import TopDown
from rlrobot_edu.task.robot_cards import LASERS

VIEW = 1.7  # how far the pictures reach from the middle of the robot [m]
CLOSE = 0.7  # the same where all show one place
RIM = 1.0  # where the outermost ring is cut off, for the last bin has no end worth drawing [m]
HALF = 17  # half the angle that a laser's sector spans; neighbours point 45 apart [degrees]
NEAR = ((RED, "xxx"), (ORANGE, "///"), (SKY, "..."), (GREEN, "---"))
FAR = (BLUE, "")

Ring = tuple[float, float]  # where a bin begins and ends in a picture


class Moment(NamedTuple):
    """A robot at one instant. scene: the view; readings: of its sensors, by name."""

    scene: Scene
    readings: Mapping[str, float]


def style_of(bin_number: int, n_bins: int) -> tuple[str, str]:
    """Colour and hatching of a bin; the last one, in which nothing is near, always looks the same."""
    return FAR if bin_number == n_bins - 1 else NEAR[bin_number % len(NEAR)]


def rings_of(variable: InputVariable) -> list[Ring]:
    """The bins of a laser to scale [m]; the last ends at the rim."""
    cuts = list(variable.cuts or ())
    return list(zip([0.0, *cuts], [*cuts, max(RIM, 1.2 * cuts[-1])], strict=True))


def draw_sector(
    ax: Axes,
    rings: Sequence[Ring],
    seen: int,
    centre: tuple[float, float],
    towards: float,
    name: str = "",
) -> None:
    """One laser: the bin that it is in filled and hatched, with its number further out; the others as empty rings.

    seen: number of that bin; towards: direction of the laser [rad]; name: of the laser, to stand above the number;
    without one only the bin seen is drawn
    """
    span = (math.degrees(towards) - HALF, math.degrees(towards) + HALF)
    colour, hatch = style_of(seen, len(rings))
    for number, (low, high) in enumerate(rings):
        if number == seen:
            look = {
                "facecolor": (colour, 0.4),
                "edgecolor": colour,
                "hatch": hatch,
                "linewidth": 1.4,
                "zorder": 4,
            }
        else:
            look = {
                "facecolor": "none",
                "edgecolor": GREY,
                "linewidth": 0.7,
                "zorder": 3,
            }
        if name or number == seen:
            ax.add_patch(Wedge(centre, high, *span, width=high - low, **look))
    rim = rings[-1 if name else seen][1] + (0.27 if name else 0.13)
    centred(
        ax,
        centre[0] + rim * math.cos(towards),
        centre[1] + rim * math.sin(towards),
        f"{name}\n{seen}".strip(),
        color=BLACK,
        fontsize=SMALLEST,
        weight="bold",
        zorder=9,
        clip_on=True,
        bbox={
            "facecolor": "white",
            "edgecolor": colour,
            "boxstyle": f"{'round' if name else 'circle'},pad=0.15",
        },
    )


def rings_finding(moments: Sequence[Moment], task: Task) -> str:
    """What became of the distances: a number, or, of two moments, how far the robot moved and what is near it then."""
    last = moments[-1].readings
    names = [variable.name for variable in task.states.inputs]
    if len(moments) == 1:
        return f"{len(names)} distances become one number, state {task.states.encode(last)}"
    first = moments[0].readings
    moved = 100 * math.dist((first["x"], first["y"]), (last["x"], last["y"]))
    nearest = min(names, key=lambda name: last[name])
    where = nearest.removeprefix("laser_").replace("_", " ")
    return f"It has moved {moved:.0f} cm, and the nearest wall is {100 * last[nearest]:.0f} cm off, {where}"


def plot_rings(
    moments: Sequence[Moment],
    task: Task,
    titles: Sequence[str] = (),
    still: bool = False,
) -> Picture:
    """The robot from above at one instant or several: its beams, and the bins of each laser that counts.

    titles: one a moment; by default the number of the state
    still: whether all show the same part of the arena, close up, with a cross where the robot was in the first; else
        each is centred on its robot
    """
    width = 3.7 * len(moments) if len(moments) > 1 else 5.6
    figure = Picture(figsize=(width, 5.2 if len(moments) == 1 else 4.6))
    names = titles or [
        f"state {task.states.encode(moment.readings)}" for moment in moments
    ]
    axes, told = figure.subplots(1, len(moments), squeeze=False)[0], []
    for name, moment, ax in zip(names, moments, axes, strict=True):
        told.append(f"{name}: {_draw(ax, moment, task)}")
        if still:
            x, y = (moments[0].readings[name] for name in "xy")
            ax.set(xlim=(x - CLOSE, x + CLOSE), ylim=(y - CLOSE, y + CLOSE))
            ax.plot(
                x, y, "+", color=BLACK, markersize=16, markeredgewidth=1.6, zorder=12
            )
        ax.set_title(plain(name), weight="bold")
        ax.set_axis_off()
    note = "rings: the bins of each laser, to scale; coloured: the bin in which it lies; small numbers: cuts (m)"
    if still:
        note += "; cross: where the robot was"
    figure.headline(rings_finding(moments, task), note)
    figure.alt = (
        f"The robot from above with the bins of its lasers as rings. {'. '.join(told)}."
    )
    return figure


def _draw(ax: Axes, moment: Moment, task: Task) -> str:
    """One instant; returns it in words."""
    x, y, heading = (moment.readings[name] for name in ("x", "y", "theta"))
    c, s = math.cos(heading), math.sin(heading)
    for words in TopDown(ax, moment.scene).words.values():
        words.set_visible(False)
    ax.set(xlim=(x - VIEW, x + VIEW), ylim=(y - VIEW, y + VIEW))
    bins, told = task.states.bins(task.states.encode(moment.readings)), []
    for i, (variable, seen) in enumerate(zip(task.states.inputs, bins, strict=True)):
        place_x, place_y, angle = PIONEER.lasers[LASERS.index(variable.name)]
        centre, towards = (
            (x + c * place_x - s * place_y, y + s * place_x + c * place_y),
            heading + angle,
        )
        name = variable.name.removeprefix("laser_")
        draw_sector(
            ax, rings_of(variable), seen, centre, towards, name.replace("_", "\n")
        )
        for cut in () if i else variable.cuts or ():
            edge = towards + math.radians(HALF)
            centred(
                ax,
                centre[0] + cut * math.cos(edge),
                centre[1] + cut * math.sin(edge),
                f"{cut:g}",
                fontsize=SMALLEST,
                zorder=10,
                clip_on=True,
                bbox={
                    "facecolor": "white",
                    "edgecolor": "none",
                    "alpha": 0.8,
                    "pad": 0.4,
                },
            )
        told.append(f"{name} {moment.readings[variable.name]:.2f} m, bin {seen}")
    return "; ".join(told)
