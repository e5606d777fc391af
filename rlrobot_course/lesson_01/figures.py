"""The figures of lesson 01: how readings become bins, and what robots do by rewards of several kinds."""

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    BLACK,
    ORANGE,
    Picture,
    centred,
    in_panels,
    plain,
)
from rlrobot_course.lesson_01.drive import Drive
from rlrobot_edu import plot_scene
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import describe
from rlrobot_edu.show.numerals import with_minus
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.task.variables import InputVariable

SHADES = (LIGHT["floor"], LIGHT["line"])  # of neighbouring bins
FAR, NEAR = 0.07, 0.10  # a long step, and the distance of a touched wall [m]


def plot_bins(
    inputs: Sequence[InputVariable], readings: Mapping[str, float]
) -> Picture:
    """Picture of the bins of `inputs`, one row each, and of the bin that each reading falls into.

    inputs: at least one, of the same unit, with cut points and a range that begins at 0; readings: by the inputs' names
    Bars end at the edge of the picture where a reading is more than twice the last cut point. Raises ValueError for an
    input without cut points.
    """
    for variable in inputs:
        if variable.cuts is None:
            raise ValueError(
                f"input {variable.name!r} has no cut points to draw; plot_bins needs inputs with cuts"
            )
    end = 2 * max(variable.cuts[-1] for variable in inputs)
    unit = inputs[0].unit
    figure = Picture(figsize=(7, 1.4 + 0.5 * len(inputs)))
    figure.headline(
        counted_bins([variable.bin(readings[variable.name]) for variable in inputs]),
        f"bars: readings ({unit}); dashed: cut points; a longer bar ends at the edge",
    )
    ax = figure.subplots()
    said = []
    for row, variable in enumerate(inputs):
        _draw_bins(ax, row, variable.cuts, end)
        reading = readings[variable.name]
        ax.barh(
            row + 0.16,
            min(reading, end),
            height=0.28,
            color=ORANGE,
            edgecolor=BLACK,
            linewidth=0.6,
            zorder=2,
        )
        result = f"{reading:.2f} {variable.unit} → bin {variable.bin(reading)}"
        ax.text(1.02 * end, row, plain(result), va="center")
        said.append(f"{variable.name} {result.replace('→', 'is in')}")
    ax.set(
        xlim=(0, end),
        yticks=range(len(inputs)),
        yticklabels=[plain(variable.name) for variable in inputs],
    )
    ax.invert_yaxis()
    figure.alt = f"Bars of {len(inputs)} readings over the bins of each input. {'; '.join(said)}."
    return figure


def counted_bins(bins: Sequence[int]) -> str:
    """How many readings fall into which bin, as a sentence."""
    parts = []
    for number, n in sorted(Counter(bins).items()):
        parts.append(f"{n} into bin {number}")
    fall = "falls" if parts[0].startswith("1 ") else "fall"
    first, *others = parts
    first = first.replace(" into", f" of {len(bins)} readings {fall} into")
    return ", ".join([first, *others])


def _draw_bins(ax: Axes, row: int, cuts: Sequence[float], end: float) -> None:
    """The bins of an input in a row: shaded areas with their numbers, dashed lines between them."""
    for i, (low, high) in enumerate(pairwise([0.0, *cuts, end])):
        ax.barh(row, high - low, left=low, height=0.8, color=SHADES[i % 2])
        centred(ax, (low + high) / 2, row - 0.2, f"bin {i}", fontsize=8.5, color=BLACK)
    dashed = {"color": BLACK, "linestyle": "--", "linewidth": 1}
    ax.vlines(cuts, row - 0.4, row + 0.4, **dashed)


def plot_cells(scene: Scene, readings: Mapping[str, float]) -> Picture:
    """The worked example's robot, four cells and box, seen from above; the cells are named as the inputs X and Y."""
    box = next(solid for solid in scene.solids if solid.name == "box")
    box_x, box_y = np.round(box.pose[:2, 3] + 0.5).astype(int)
    picture = Picture((4.2, 4.9), describe(scene))
    picture.headline(
        f"The robot stands in cell ({readings['X']:g}, {readings['Y']:g}), "
        f"the box in cell ({box_x}, {box_y})",
        "seen from above; white: where the robot looks",
    )
    ax = picture.subplots()
    plot_scene(scene, ax)
    ax.set_title("")
    ax.axvline(0, color="white", linewidth=2, zorder=0.5)
    ax.axhline(0, color="white", linewidth=2, zorder=0.5)
    for i in (0, 1):
        ax.text(i - 0.5, 1.13, f"X = {i}", ha="center", va="bottom")
        ax.text(-1.13, i - 0.5, f"Y = {i}", ha="right", va="center")
    return picture


def plot_drives(drives: Mapping[str, Drive]) -> Picture:
    """The ways of two or more robots of wander_simple side by side, below what each did; by what each is called."""
    figure = Picture((2.8 * len(drives), 4.1))
    n_steps = max(len(drive.rewards) for drive in drives.values())
    figure.headline(
        who_drives(drives),
        f"ways of {n_steps} steps, after 1000 steps of learning; touch: a laser reads below {NEAR:.2f} m",
    )
    said = []
    for ax, name, drive in in_panels(figure, drives):
        words = f"{long_steps(drive)} steps over {FAR} m, {touches(drive)} touches"
        plot_scene(
            [scene._replace(beams=scene.beams[:0]) for scene in drive.scenes], ax
        )
        earned = with_minus(np.mean(drive.rewards), 1)
        ax.set_title(plain(f"{name}: mean reward {earned}\n{words}"), fontsize=10)
        said.append(f"{name}: {words}")
    figure.alt = f"Paths of {len(drives)} robots in a square. {'; '.join(said)}."
    return figure


def long_steps(drive: Drive) -> int:
    """How many steps moved the robot far."""
    return sum(way > FAR for way in drive.ways())


def touches(drive: Drive) -> int:
    """After how many steps the robot touched a wall, as far as its two lasers see."""
    pairs = [(r["laser_front_left"], r["laser_front_right"]) for r in drive.readings]
    return sum(min(pair) < NEAR for pair in pairs[1:])


def who_drives(drives: Mapping[str, Drive]) -> str:
    """Which robots drive about, as a sentence: those that moved far in more than half of their steps."""
    about = [
        name
        for name, drive in drives.items()
        if 2 * long_steps(drive) > len(drive.rewards)
    ]
    if not about:
        return f"None of the {len(drives)} robots drives about"
    if len(about) == len(drives):
        return f"All {len(drives)} robots drive about"
    verb = "drives" if len(about) == 1 else "drive"
    return f"{len(about)} of {len(drives)} robots {verb} about: {', '.join(about)}"
