"""The figures of lesson 13: the places that the arm can reach, and an episode."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
    centred,
)
from rlrobot_course.lesson_13.arm_figure import CONTACT, FOOT
from rlrobot_course.worlds.arm_world import Places
from rlrobot_edu.robots.arm.arm_body import OBJECT, OBJECT_PLACE
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.style import SMALLEST

TOLD = 10  # steps of an episode that are drawn


def places_finding(places: Places, path: Sequence[int], name: str) -> str:
    """How many places touch the object, and whether an arm ends in one of them."""
    touches = places.distance <= CONTACT
    said = f"{touches.sum()} of the {len(touches)} places are in contact"
    ends = [bool(touches[i]) for i in path[-2:]]
    if all(ends):
        return f"{said}, and {name} ends there"
    if any(ends):
        return f"{said}, and {name} goes in and out of them"
    return f"{said}; {name} ends in none of them"


def plot_places(places: Places, path: Sequence[int], name: str) -> Picture:
    """Every place that the gripper can reach, from above, and the way of an arm.

    path: numbers of places, in order; name: of the arm
    """
    figure = Picture(figsize=(6.2, 5.6))
    note = "from above; a mark: a place that the gripper can get to"
    figure.headline(places_finding(places, path, name), note)
    ax = figure.subplots()
    x = np.array([seen["gripper_x"] for seen in places.readings])
    y = np.array([seen["gripper_y"] for seen in places.readings])
    touches = places.distance <= CONTACT
    _draw_table(ax, (0.2, -0.235))
    ax.plot(x[~touches], y[~touches], "o", color=GREY, markersize=5, zorder=2)
    ax.plot(x[touches], y[touches], "s", color=GREEN, markersize=7, zorder=3)
    ax.plot(x[path], y[path], color=BLUE, linewidth=2, zorder=4)
    ax.plot(x[path[-2:]], y[path[-2:]], "D", color=BLUE, markersize=8, zorder=5)
    line = {"arrowstyle": "-", "color": GREY}
    for text, at, place, colour in (
        ("object", OBJECT_PLACE[:2], (0.03, 0.12), BLACK),
        ("in contact", (x[touches].min(), y[touches].max()), (0.03, 0.16), GREEN),
        (f"way of {name}", (x[path[0]], y[path[0]]), (0.0, -0.14), BLUE),
    ):
        ax.annotate(text, at, place, arrowprops=line, color=colour, va="center")
    ax.set(xlim=(-0.08, 0.36), ylim=(-0.27, 0.24), aspect="equal")
    figure.alt = (
        f"{len(x)} places from above, {touches.sum()} of them in contact with the object. The arm goes to and fro "
        f"between {' and '.join(f'x = {x[i]:.2f}, y = {y[i]:.2f} m' for i in path[-2:])}."
    )
    return figure


def episode_finding(name: str, distances: np.ndarray, rewards: np.ndarray) -> str:
    """What an arm does in some steps: its distances before the first and after each [m], and what they paid."""
    paid = f"for {np.mean(rewards):.2g} points a step".replace("-", "−")
    near, far = 100 * distances.min(), 100 * distances.max()
    if far <= 100 * CONTACT:
        return f"{name} stays in contact, {paid}"
    if np.allclose(distances[2:], distances[:-2]):
        return f"{name} goes to and fro between {near:.0f} and {far:.0f} cm, {paid}"
    return f"{name} comes as near as {near:.0f} cm, {paid}"


def plot_episode(
    places: Places, path: Sequence[int], rewards: np.ndarray, name: str
) -> Picture:
    """The last ten of an arm's steps: the arm from above, and its distance to the object after each step.

    path: numbers of the places before and after each step; rewards: of the steps
    """
    distances = 100 * places.distance[list(path)]
    last = np.arange(len(rewards) - TOLD, len(rewards) + 1)
    shown, paid = distances[last], rewards[-TOLD:]
    figure = Picture(figsize=(8.4, 3.9))
    finding = episode_finding(name, shown / 100, paid)
    note = f"steps {last[1]} to {last[-1]} of its last episode, a second each; signed numbers: what a step was paid"
    figure.headline(finding, note)
    above, ax = figure.subplots(1, 2, width_ratios=(1, 1.6))
    _draw_arm(above, places, path)
    ax.plot(last, shown, color=BLUE, marker="o")
    for t, r, before, after in zip(last[1:], paid, shown[:-1], shown[1:], strict=True):
        look = {"color": GREEN if r > 0 else RED, "weight": "bold"}
        side = -14 if after < before else 14
        ax.annotate(
            f"{r:+g}".replace("-", "−"),
            (t, after),
            (0, side),
            textcoords="offset points",
            ha="center",
            va="center",
            **look,
        )
    contact = 100 * CONTACT
    ax.axhline(contact, color=RED, linestyle="--", linewidth=1.5)
    ax.text(last[-1], contact - 0.2, "contact", color=RED, ha="right", va="top")
    ax.set(xlabel="step", ylim=(0, 1.25 * shown.max()), xticks=last[1:])
    ax.set_title("from the gripper to the object (cm)", weight="bold")
    ax.grid(axis="y")
    half = len(rewards) // 2
    near, far = np.sort(distances[half:])[[0, -1]]
    figure.alt = (
        f"Distance of the gripper to the object over {len(rewards)} steps, from {distances[0]:.1f} cm. In the "
        f"second half it stays between {near:.1f} and {far:.1f} cm, with {np.mean(rewards[half:]):.2f} a step on "
        f"average. Drawn are the last {TOLD} of these steps, beside the arm at its last two places from above."
    )
    return figure


def _draw_table(ax: Axes, scale: tuple[float, float]) -> None:
    """The object with the circle of contact, the foot of the arm, and ten centimetres from `scale` on."""
    ax.add_patch(Circle(OBJECT_PLACE[:2], OBJECT[0], color=ORANGE, zorder=1))
    ring = {"fill": False, "edgecolor": RED, "linestyle": "--", "zorder": 1}
    ax.add_patch(Circle(OBJECT_PLACE[:2], CONTACT, **ring))
    ax.add_patch(Circle((0, 0), FOOT, color=BLUE, zorder=5))
    centred(ax, 0, 0, "foot", color="white", fontsize=SMALLEST, zorder=6)
    x, y = scale
    ax.plot([x, x + 0.1], [y, y], color=LIGHT["faint"], linewidth=2)
    centred(ax, x + 0.05, y - 0.016, "10 cm", color=LIGHT["faint"])
    ax.set_axis_off()


def _draw_arm(ax: Axes, places: Places, path: Sequence[int]) -> None:
    """The arm from above at the last two places of a path, and the object with the circle of contact."""
    _draw_table(ax, (0.2, -0.13))
    for i, alpha in zip(path[-2:], (0.4, 1.0), strict=True):
        seen = places.readings[i]
        x, y = seen["gripper_x"], seen["gripper_y"]
        look = {"color": BLUE, "alpha": alpha, "solid_capstyle": "round"}
        ax.plot([0, x], [0, y], linewidth=6, **look)
        ax.plot(x, y, "D", color=BLUE, alpha=alpha, markersize=9)
    x, y = OBJECT_PLACE[:2]
    centred(ax, x, y + 0.066, "object")
    ax.set(xlim=(-0.06, 0.35), ylim=(-0.16, 0.18), aspect="equal")
