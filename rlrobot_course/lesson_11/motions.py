"""What the speeds of its two wheels do with a robot, as arrows."""

import math
from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from rlrobot_course.figures.plots import BLACK, BLUE, Picture
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.task.task import Task

Motion = Callable[[float, float, float, float], tuple[float, float]]

SECONDS = (
    4.0  # of driving that an arrow shows; of one second there would be little to see
)
STILL = 1e-9  # speeds below it are none
FRONT = 0.23  # where the arrows begin, before the axle [m]
SPIN = 0.36  # radius of an arrow for turning on the spot [m]


def in_words(v: float, turn: float) -> str:
    """A motion in a word or two. v: forward speed [m/s]; turn: [degrees/s], positive to the left."""
    if abs(turn) < STILL:
        if abs(v) < STILL:
            return "stands still"
        return "forward" if v > 0 else "backward"
    side = "left" if turn > 0 else "right"
    return f"spins {side}" if abs(v) < STILL else f"curves {side}"


def path_of(v: float, turn: float, seconds: float = SECONDS) -> np.ndarray:
    """Where the middle of the axle gets with constant speeds, from (0, 0) heading along x; array (n, 2) [m]."""
    t, omega = np.linspace(0, seconds, 40), math.radians(turn)
    if abs(omega) < STILL:
        return np.column_stack([v * t, 0 * t])
    path: np.ndarray = (
        v / omega * np.column_stack([np.sin(omega * t), 1 - np.cos(omega * t)])
    )
    return path


def draw_robot(ax: Axes) -> None:
    """The robot's outline from above, its axle at (0, 0), its front along x."""
    hull = [(x - PIONEER.axle, y) for x, y in PIONEER.hull]
    ax.add_patch(Polygon(hull, facecolor=BLUE, linewidth=0, zorder=5))
    ax.plot(
        [0.06, 0.2],
        [0, 0],
        color="white",
        linewidth=3,
        solid_capstyle="round",
        zorder=6,
    )


def draw_motion(ax: Axes, v: float, turn: float, scale: float = 1.0) -> None:
    """An arrow from the front of the robot that `draw_robot` draws; scale: of its length."""
    word = in_words(v, turn)
    if word == "stands still":
        ax.plot([0], [0], "s", color="white", markersize=8, zorder=9)
        return
    way = np.array([FRONT, 0]) + scale * path_of(v, turn)
    if "spins" in word:
        angles = np.radians(np.linspace(0, SECONDS * turn, 40))
        way = SPIN * np.column_stack([np.cos(angles), np.sin(angles)])
    ax.plot(*way[:-2].T, color=BLACK, linewidth=2.8, zorder=9)
    x, y = way[-1] - way[-5]
    head = (
        3,
        0,
        math.degrees(math.atan2(y, x)) - 90,
    )  # a triangle that points along the way
    ax.plot(*way[-1], marker=head, color=BLACK, markersize=9, zorder=10)


def motion_of(task: Task, a: int, motion: Motion) -> tuple[float, float]:
    """What action `a` makes of the robot by `motion`, the learner's function or ours: (m/s, degrees/s)."""
    wheels = task.command_for(a)
    return motion(
        wheels["left_wheel"],
        wheels["right_wheel"],
        PIONEER.wheel_radius,
        PIONEER.wheel_separation,
    )


def motions_finding(task: Task, motion: Motion) -> str:
    """How many different motions the actions make, and how many of the actions stand still."""
    found = [motion_of(task, a, motion) for a in range(task.actions.n)]
    different = {(round(v, 6), round(turn, 6)) for v, turn in found}
    still = sum(in_words(v, turn) == "stands still" for v, turn in found)
    return f"{len(found)} actions make {len(different)} different motions; {still} of them stand still"


def plot_motions(task: Task, motion: Motion) -> Picture:
    """All actions of a task: one small robot each, with the way that it goes in four seconds."""
    rows, columns = task.actions.shape
    figure, told = Picture(figsize=(2.1 * columns, 1.95 * rows + 0.9)), []
    for a, ax in enumerate(figure.subplots(rows, columns).flat):
        v, turn = motion_of(task, a, motion)
        draw_robot(ax)
        draw_motion(ax, v, turn)
        ax.set(
            xlim=(-0.45, 1.15), ylim=(-0.5, 0.5), aspect="equal", xticks=[], yticks=[]
        )
        ax.spines["bottom"].set_visible(False)
        left, right = task.actions.decode(a).values()
        ax.set_title(f"{a}: left {left:g}, right {right:g}".replace("-", "−"))
        ax.set_xlabel(
            f"{v:.2f} m/s, {turn:+.0f} °/s".replace("-", "−").replace("+0 ", "0 ")
        )
        told.append(
            f"action {a} {in_words(v, turn)}, {v:.2f} m/s and {turn:.0f} degrees a second"
        )
    note = "number of the action and speeds of the wheels; an arrow: the way of 4 s; a square: it stands still"
    figure.headline(motions_finding(task, motion), note)
    figure.alt = f"Small robots with arrows, one an action: {'; '.join(told)}."
    return figure
