"""A policy that can be read: for each thing that an agent does, the situation in which it does it most often."""

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Wedge

from rlrobot_course.figures.plots import ORANGE, RED, SKY, Picture
from rlrobot_course.lesson_11.motions import (
    Motion,
    draw_motion,
    draw_robot,
    in_words,
    motion_of,
)
from rlrobot_course.lesson_11.rings import HALF
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.show.palette import BLACK, LIGHT
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task

COLUMNS, MOST = 3, 6  # situations in a row, and in all
FAST = 0.15  # forward above it is fast [m/s]
INNER, OUTER = (
    0.42,
    1.2,
)  # where the wedges begin, and where the longest ends; not to scale
NEAR = (RED, ORANGE, SKY)  # the walls in the first bins; the last bin ends at none
FREE = LIGHT["line"]  # a wedge of free floor


def most_visited(visits: np.ndarray, most: int) -> list[int]:
    """The states that were visited at all, the most frequent first, at most so many; visits: array (S, A)."""
    in_state = visits.sum(axis=1)
    order = np.argsort(-in_state, kind="stable")[:most]
    return [int(s) for s in order if in_state[s]]


def what_it_does(task: Task, q_s: np.ndarray, motion: Motion) -> str:
    """The best action of a state in words. q_s: values of its actions"""
    v, turn = motion_of(task, int(q_s.argmax()), motion)
    word = in_words(v, turn)
    if word == "forward":
        word += ", fast" if v > FAST else ", slow"
    return word


def one_of_each(
    task: Task, q: np.ndarray, visits: np.ndarray, motion: Motion
) -> dict[int, str]:
    """The most frequent state for each different thing that is done, the most frequent first, with its word."""
    found: dict[int, str] = {}
    for s in most_visited(visits, len(visits)):
        word = what_it_does(task, q[s], motion)
        if word not in found.values():
            found[s] = word
    return dict(list(found.items())[:MOST])


def policy_finding(task: Task, s: int, word: str) -> str:
    """What is near in the most frequent situation, and what the robot does there."""
    bins = task.states.bins(s)
    names = [variable.name.removeprefix("laser_") for variable in task.states.inputs]
    near = [
        name.replace("_", " ") for name, b in zip(names, bins, strict=True) if b == 0
    ]
    if not near:
        return f"Most often nothing is near the robot, and its best action is “{word}”"
    *first, last = near
    sides = f"{', '.join(first)} and {last}" if first else last
    if "front" in near and word.startswith("forward"):
        return (
            f"A wall at its {sides}, and yet it drives on: its most frequent situation"
        )
    return f"Most often a wall is at its {sides}, and its best action is “{word}”"


def plot_policy(
    task: Task, q: np.ndarray, visits: np.ndarray, motion: Motion
) -> Picture:
    """One small robot for each different thing that it does: its lasers' bins as wedges, an arrow for its best action.

    q, visits: arrays (S, A); motion: from wheel speeds to (m/s, degrees/s)
    """
    states, share = (
        one_of_each(task, q, visits, motion),
        visits.sum(axis=1) / visits.sum(),
    )
    columns = min(COLUMNS, len(states))
    rows = -(-len(states) // columns)
    figure, told = Picture(figsize=(max(2.8 * columns, 5.6), 2.5 * rows + 1.0)), []
    first, *_ = states
    cuts = task.states.inputs[0].cuts or ()
    names = zip(("red", "orange", "light blue"), cuts, strict=False)
    ends = [f"{colour} up to {100 * cut:.0f} cm" for colour, cut in names]
    note = (
        "for each thing that it does its most frequent situation; a wedge: free floor, not to scale, "
        f"and the wall at its end: {', '.join(ends)}"
    )
    figure.headline(policy_finding(task, first, states[first]), note)
    axes = figure.subplots(rows, columns, squeeze=False).flatten()
    for (s, word), ax in zip(states.items(), axes, strict=False):
        _draw(ax, task, s, q[s], motion)
        second = np.partition(q[s], -2)[-2]
        ax.text(-1.7, 1.35, word, weight="bold", color=BLACK, va="top")
        ax.text(
            -1.7,
            1.02,
            f"state {s}\n{share[s]:.1%} of steps",
            color=LIGHT["faint"],
            va="top",
        )
        points = f"{q[s].max():.1f} points,\nnext best {second:.1f}".replace("-", "−")
        ax.text(-1.7, -1.25, points, color=LIGHT["faint"], va="bottom")
        told.append(f"state {s} ({share[s]:.1%} of steps) {word}")
    for ax in axes[len(states) :]:
        ax.set_visible(False)
    figure.alt = f"{len(states)} situations, the most frequent for each thing that the robot does: {'; '.join(told)}."
    return figure


def _draw(ax: Axes, task: Task, s: int, q_s: np.ndarray, motion: Motion) -> None:
    """One situation: wedges as long as the bins are far, and the robot with its arrow."""
    for variable, seen in zip(task.states.inputs, task.states.bins(s), strict=True):
        towards = math.degrees(PIONEER.lasers[LASERS.index(variable.name)][2])
        ends = (towards - HALF + 3, towards + HALF - 3)
        end = INNER + (OUTER - INNER) * (seen + 1) / variable.n_bins
        ax.add_patch(
            Wedge((0, 0), end, *ends, width=end - 0.2, color=FREE, linewidth=0)
        )
        if seen < variable.n_bins - 1:
            colour = NEAR[min(seen, len(NEAR) - 1)]
            ax.add_patch(
                Wedge((0, 0), end, *ends, width=0.1, color=colour, linewidth=0)
            )
    draw_robot(ax)
    v, turn = motion_of(task, int(q_s.argmax()), motion)
    draw_motion(ax, v, turn, scale=0.8)
    ax.set(xlim=(-1.75, 1.25), ylim=(-1.3, 1.4), aspect="equal")
    ax.set_axis_off()
