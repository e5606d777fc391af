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
    solids_of,
)
from rlrobot_edu.show.top_down import footprint
from rlrobot_edu.task.task import Task

CONTACT = 0.05  # [m]


def plot_arm(task: Task) -> Picture:
    """The arm from the side, with its joints and lengths, and from above, with the bins of its gripper and object."""
    figure = Picture(figsize=(9.5, 4.6))
    side, above = figure.subplots(1, 2, width_ratios=(1, 1.15))
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
            fontsize=9,
        )
    for text, (one, other), shift in (
        ("upper arm\n0.23 m", (shoulder, elbow), (0.01, -0.085)), ("lower arm\n0.25 m", (elbow, tip), (0.03, -0.04)),
    ):  # fmt: skip
        ax.text(*((one + other) / 2 + shift), text, fontsize=9, color=BLUE)
    ax.set(xlim=(-0.2, 0.45), ylim=(-0.09, 0.38), aspect="equal", title="from the side")
    ax.set(xlabel="out from the foot (m)", ylabel="height above the table (m)")


def _from_above(ax: Axes, task: Task, angles: Angles) -> None:
    x_min, y_min, x_max, y_max = FIELD
    x_cuts, y_cuts = (task.inputs[i].cuts for i in (0, 1))
    for solid in solids_of(angles):
        colour = BLUE if solid.role == "robot" else BLACK
        ax.fill(*footprint(solid).T, color=colour, alpha=0.55, linewidth=0, zorder=2)
    for x in x_cuts:
        ax.plot([x, x], [y_min, y_max], color=GREY, linewidth=1)
    for y in y_cuts:
        ax.plot([x_min, x_max], [y, y], color=GREY, linewidth=1)
    ax.add_patch(
        Rectangle(
            (x_min, y_min), x_max - x_min, y_max - y_min, fill=False, edgecolor=BLACK
        )
    )
    for i, x in enumerate(_middles(x_cuts, x_min, x_max)):
        ax.text(x, y_max + 0.008, str(i), ha="center", fontsize=9)
    for i, y in enumerate(_middles(y_cuts, y_min, y_max)):
        ax.text(x_max + 0.008, y, str(i), va="center", fontsize=9)
    ax.text((x_min + x_max) / 2, y_max + 0.03, "bins of x", ha="center", fontsize=9)
    ax.text(x_max + 0.03, 0, "bins of y", va="center", rotation=90, fontsize=9)
    ax.add_patch(Circle(OBJECT_PLACE[:2], OBJECT[0], color=ORANGE, zorder=3))
    ax.add_patch(
        Circle(
            OBJECT_PLACE[:2],
            CONTACT,
            fill=False,
            edgecolor=RED,
            linestyle="--",
            zorder=3,
        )
    )
    line = {"arrowstyle": "-", "color": GREY}
    ax.annotate(
        "object, and 5 cm\naround it",
        (0.24, 0.12),
        (0.03, 0.15),
        arrowprops=line,
        fontsize=9,
    )
    x, y, _ = link_poses(angles)["gripper"][:3, 3]
    ax.plot(x, y, "D", color=RED, markersize=8, zorder=4)
    ax.text(x - 0.012, y - 0.03, "gripper", fontsize=9, ha="center", zorder=4)
    out = np.array([x, y]) / np.hypot(x, y)
    ways = (
        (np.array([-out[1], out[0]]), "arm +", (-0.012, 0.004)),
        (-out, "forearm +", (-0.03, -0.034)),
    )
    for way, text, shift in ways:
        end = np.array([x, y]) + 0.045 * way
        ax.annotate(
            "",
            end,
            (x, y),
            arrowprops={"arrowstyle": "-|>", "color": GREEN, "linewidth": 2},
            zorder=5,
        )
        ax.text(*(end + shift), text, color=BLACK, fontsize=9, ha="center", zorder=5)
    ax.set(
        xlim=(-0.08, 0.38),
        ylim=(-0.2, 0.21),
        aspect="equal",
        xlabel="x (m)",
        ylabel="y (m)",
        title="from above",
    )


def _middles(cuts: Sequence[float], low: float, high: float) -> np.ndarray:
    edges = np.array([low, *cuts, high])
    return (edges[:-1] + edges[1:]) / 2
