"""The arm as it stands, from the side and from above."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, Circle, Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
)
from rlrobot_edu.robots.arm.arm_body import (
    FIELD,
    HOME,
    OBJECT,
    OBJECT_PLACE,
    Angles,
    link_poses,
)
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.task.task import Task

CONTACT = 0.05  # [m]
FOOT = 0.055  # radius of the arm's foot in a picture [m]


def arm_finding(task: Task, angles: Angles) -> str:
    """How far the gripper is from the object, and in which bins it is."""
    x, y, z = link_poses(angles)["gripper"][:3, 3]
    distance = 100 * np.linalg.norm(np.array([x, y, z]) - OBJECT_PLACE)
    bins = [task.inputs[i].bin(value) for i, value in enumerate((x, y))]
    where = f"in bin {bins[0]} of x and bin {bins[1]} of y"
    return f"The gripper starts {distance:.0f} cm from the object, {where}"


def plot_arm(task: Task) -> Picture:
    """The arm from the side, with its joints and lengths, and from above, with the bins of its gripper and object."""
    figure = Picture(figsize=(8.4, 4.5))
    figure.headline(arm_finding(task, HOME))
    side, above = figure.subplots(1, 2, width_ratios=(1.15, 1))
    _from_the_side(side, HOME)
    _from_above(above, task, HOME)
    x, y, _ = link_poses(HOME)["gripper"][:3, 3]
    n_x, n_y = (len(task.inputs[i].cuts) + 1 for i in (0, 1))
    figure.alt = (
        "Left, the arm from the side: a foot, the joint arm that turns all above it, the joint biceps at a height of "
        "0.12 m, an upper arm of 0.23 m, the joint forearm at the elbow, a lower arm of 0.25 m and the gripper. Right, "
        f"the table from above with {n_x} bins of x and {n_y} of y: the gripper is at x = {x:.2f}, y = {y:.2f} m, the "
        f"object at x = {OBJECT_PLACE[0]:.2f}, y = {OBJECT_PLACE[1]:.2f} m, in a circle of contact of 5 cm."
    )
    return figure


def _from_the_side(ax: Axes, angles: Angles) -> None:
    """Seen across the vertical plane of the arm: how far out, and how high."""
    there = link_poses(angles._replace(arm=0.0))
    points = np.array(
        [
            there[name][[0, 2], 3]
            for name in ("shoulder", "upper_arm", "lower_arm", "gripper")
        ]
    )
    foot, shoulder, elbow, tip = points
    ax.axhline(0, color=GREY, linewidth=3)
    ax.add_patch(Rectangle((-0.06, 0), 0.12, 0.06, color=BLUE))
    ax.plot(
        *points.T,
        color=BLUE,
        linewidth=7,
        solid_capstyle="round",
        solid_joinstyle="round",
    )
    ax.plot(*points[:3].T, "o", color=BLACK, markersize=9)
    ax.plot(*tip, "D", color=RED, markersize=8)
    ax.plot(
        *np.array([shoulder, shoulder + (0, 0.16)]).T, ":", color=BLACK, linewidth=1
    )
    lean = np.degrees(angles[1])
    ax.add_patch(Arc(shoulder, 0.2, 0.2, theta1=90 - lean, theta2=90, linewidth=1.5))
    level = np.array(
        [elbow, elbow + 0.14 * np.array([np.cos(-angles[1]), np.sin(-angles[1])])]
    )
    ax.plot(*level.T, ":", color=BLACK, linewidth=1)
    ax.add_patch(
        Arc(
            elbow,
            0.2,
            0.2,
            theta1=-lean - np.degrees(angles[2]),
            theta2=-lean,
            linewidth=1.5,
        )
    )
    for text, at, place in (
        ("joint arm\nturns it all", foot, (-0.185, 0.04)), ("joint biceps\n0.12 m high", shoulder, (-0.185, 0.14)),
        ("joint forearm", elbow, (0.13, 0.32)), ("gripper", tip, (0.32, -0.055)),
        ("biceps", shoulder + (0.045, 0.1), (0.03, 0.27)), ("forearm", elbow + (0.065, -0.085), (0.3, 0.2)),
    ):  # fmt: skip
        ax.annotate(
            text,
            at,
            place,
            arrowprops={"arrowstyle": "-", "color": GREY},
            ha="left",
            va="center",
        )
    for text, (one, other), shift in (
        ("upper arm\n0.23 m", (shoulder, elbow), (0.01, -0.085)), ("lower arm\n0.25 m", (elbow, tip), (0.03, -0.04)),
    ):  # fmt: skip
        ax.text(*((one + other) / 2 + shift), text, color=BLUE, linespacing=1.1)
    ax.set(xlim=(-0.23, 0.42), ylim=(-0.12, 0.4), aspect="equal")
    ax.set_title("from the side", weight="bold")
    ax.set_axis_off()


def _from_above(ax: Axes, task: Task, angles: Angles) -> None:
    """The table with the bins of the gripper, the object, and the arm with the ways in which two joints move it."""
    x_min, y_min, x_max, y_max = FIELD
    x_cuts, y_cuts = (task.inputs[i].cuts for i in (0, 1))
    line = {"color": LIGHT["line"], "linewidth": 1, "zorder": 1}
    for x in (x_min, *x_cuts, x_max):
        ax.plot([x, x], [y_min, y_max], **line)
    for y in (y_min, *y_cuts, y_max):
        ax.plot([x_min, x_max], [y, y], **line)
    faint = {"color": LIGHT["faint"], "ha": "center", "va": "center"}
    for i, x in enumerate(_middles(x_cuts, x_min, x_max)):
        ax.text(x, y_max + 0.014, str(i), **faint)
    for i, y in enumerate(_middles(y_cuts, y_min, y_max)):
        ax.text(x_max + 0.016, y, str(i), **faint)
    ax.text((x_min + x_max) / 2, y_max + 0.036, "bins of x", **faint)
    ax.text(x_max + 0.04, 0, "bins of y", rotation=90, **faint)
    centre = OBJECT_PLACE[:2]
    ax.add_patch(Circle(centre, OBJECT[0], color=ORANGE, zorder=3))
    ring = {"fill": False, "edgecolor": RED, "linestyle": "--", "zorder": 3}
    ax.add_patch(Circle(centre, CONTACT, **ring))
    there = link_poses(angles)
    tip = there["gripper"][:2, 3]
    ax.add_patch(Circle((0, 0), FOOT, color=BLUE, zorder=2))
    ax.text(0, 0, "foot", color="white", ha="center", va="center", zorder=6)
    look = {"color": BLUE, "linewidth": 7, "solid_capstyle": "round", "zorder": 4}
    ax.plot([0, tip[0]], [0, tip[1]], **look)
    ax.plot(*tip, "D", color=RED, markersize=8, zorder=5)
    grey = {"arrowstyle": "-", "color": GREY}
    for text, at, place in (
        (
            "object, and 5 cm\naround it",
            (centre[0] - 0.03, centre[1] + 0.04),
            (-0.06, 0.14),
        ),
        ("gripper", tip, (0.1, -0.17)),
    ):
        ax.annotate(text, at, place, arrowprops=grey, va="center", linespacing=1.1)
    out = tip / np.hypot(*tip)
    left = np.array([-out[1], out[0]])
    ways = (
        (left, 0.0 * left, "arm +", (0.012, 0.018)),
        (-out, 0.018 * left, "forearm +", (-0.02, 0.012)),
    )
    for way, aside, text, shift in ways:
        begin = tip + aside
        end = begin + 0.06 * way
        arrow = {"arrowstyle": "-|>", "color": GREEN, "linewidth": 2.5}
        ax.annotate("", end, begin, arrowprops=arrow, zorder=6)
        ax.text(*(end + shift), text, color=GREEN, weight="bold", ha="center", zorder=6)
    ax.set(xlim=(-0.08, 0.38), ylim=(-0.18, 0.21), aspect="equal")
    ax.set_title("from above", weight="bold")
    ax.set_axis_off()


def _middles(cuts: Sequence[float], low: float, high: float) -> np.ndarray:
    edges = np.array([low, *cuts, high])
    return (edges[:-1] + edges[1:]) / 2
