"""The figures of lesson 12: what to do in a corridor, and a robot in its lane."""

from collections.abc import Mapping

import numpy as np
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    GREEN,
    GREY,
    RED,
    ROLE,
    Picture,
    centred,
    plain,
)
from rlrobot_course.lesson_12.worlds import NEARER, lane_scene
from rlrobot_edu.learning.size import Env
from rlrobot_edu.show.describe import robot_of
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.numerals import with_minus


def corridor_finding(tables: Mapping[str, np.ndarray]) -> str:
    """Which rewards make the robot turn back before the goal."""
    back = [
        label for label, q in tables.items() if (q[:-1].argmax(axis=1) != NEARER).any()
    ]
    if not back:
        return "Each of these rewards leads to the goal"
    names = "” and “".join(back)
    if len(back) == len(tables):
        return f"“{names}” does not lead into the goal"
    others = len(tables) - len(back)
    rest = "the other one leads" if others == 1 else f"the other {others} lead"
    return f"“{names}” turns back before the goal; {rest} into it"


def plot_corridor(tables: Mapping[str, np.ndarray], title: str = "") -> Picture:
    """What to do in each cell of a corridor, and what it is worth.

    tables: label -> Q, array (cells + 1, 2); title: by default which rewards lead to the goal
    """
    n = len(next(iter(tables.values()))) - 1
    figure, told = Picture(figsize=(7.2, 1.2 + 1.25 * len(tables))), []
    for (label, q), ax in zip(
        tables.items(),
        figure.subplots(len(tables), 1, squeeze=False)[:, 0],
        strict=True,
    ):
        for cell in range(n):
            ax.add_patch(Rectangle((cell, 0), 1, 1, facecolor="white", edgecolor=GREY))
            nearer = q[cell].argmax() == NEARER
            tail, head = ((0.2, 0.8), (0.8, 0.2))[not nearer]
            look = {
                "arrowstyle": "-|>",
                "linewidth": 2.4,
                "color": GREEN if nearer else RED,
            }
            ax.annotate("", (cell + head, 0.68), (cell + tail, 0.68), arrowprops=look)
            centred(
                ax,
                cell + 0.5,
                0.26,
                with_minus(q[cell].max(), 1),
                fontsize=10,
            )
        ax.add_patch(
            Rectangle(
                (n, 0),
                1,
                1,
                facecolor=ROLE["goal"],
                alpha=0.35,
                hatch="//",
                edgecolor=GREY,
            )
        )
        centred(ax, n + 0.5, 0.5, "goal", fontsize=10)
        ax.set(xlim=(0, n + 1), ylim=(0, 1), xticks=[], yticks=[], aspect="equal")
        ax.set_title(plain(label), fontsize=10, loc="left")
        ways = ["nearer" if q[cell].argmax() == NEARER else "away" for cell in range(n)]
        told.append(f"{label}: {', '.join(ways)}")
    note = "arrow: the best action in a cell, with its value"
    figure.headline(title or corridor_finding(tables), note)
    figure.alt = f"A corridor of {n} cells before a goal, with the best action in each cell. {'; '.join(told)}."
    return figure


def film_in_lane(q: np.ndarray, env: Env, steps: int) -> Film:
    """The robot in its lane with the best action of a table, array (S, A), up to its goal or for so many steps."""
    s, scenes, rewards, terminated = env.reset()[1]["state"], [], [], False
    while len(scenes) < steps and not terminated:
        _, reward, terminated, _, info = env.step(int(q[s].argmax()))
        s = info["state"]
        scenes.append(lane_scene(robot_of(env).scene()))
        rewards.append(float(reward))
    return Film(scenes, rewards)
