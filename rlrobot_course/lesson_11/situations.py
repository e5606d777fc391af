"""A policy that can be read: the situations that an agent met most often, and what it does in each."""

from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from rlrobot_course.figures.plots import BLACK, Picture, legend_below
from rlrobot_course.lesson_11.motions import (
    Motion,
    draw_motion,
    draw_robot,
    in_words,
    motion_of,
)
from rlrobot_course.lesson_11.rings import draw_sector, legend_of
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task

COLUMNS, MOST = 4, 12  # situations in a row, and in all
FAST = 0.15  # forward above it is fast [m/s]
INNERMOST, OUTERMOST = (
    0.48,
    1.12,
)  # where the rings begin and end; they are equally wide here, and not to scale


def most_visited(visits: np.ndarray, most: int) -> list[int]:
    """The states that were visited at all, the most frequent first, at most so many; visits: array (S, A)."""
    in_state = visits.sum(axis=1)
    order = np.argsort(-in_state, kind="stable")[:most]
    return [int(s) for s in order if in_state[s]]


def plot_policy(
    task: Task,
    q: np.ndarray,
    visits: np.ndarray,
    motion: Motion,
    title: str,
) -> Picture:
    """One small robot for each of the most visited states: its lasers' bins, and an arrow for its best action.

    q, visits: arrays (S, A); motion: from wheel speeds to (m/s, degrees/s)
    """
    states, share = most_visited(visits, MOST), visits.sum(axis=1) / visits.sum()
    columns = min(COLUMNS, len(states))
    rows = -(-len(states) // columns)
    figure, told = Picture(figsize=(max(2.1 * columns, 6.3), 2.75 * rows + 1.4)), []
    axes = figure.subplots(rows, columns, squeeze=False).flatten()
    for s, ax in zip(states, axes, strict=False):
        word = _draw(ax, task, s, q[s], motion)
        ax.set_title(f"state {s}\n{share[s]:.1%} of steps", fontsize=9.5)
        told.append(f"state {s} ({share[s]:.1%} of steps) {word}")
    for ax in axes[len(states) :]:
        ax.set_visible(False)
    laser = task.states.inputs[0]
    arrow = Line2D([], [], color=BLACK, marker=">", label="best action")
    legend_below(figure, 3, handles=[*legend_of(laser), arrow])
    figure.headline(title)
    figure.alt = (
        f"{len(states)} situations, the most frequent first: {'; '.join(told)}."
    )
    return figure


def _draw(ax: Axes, task: Task, s: int, q_s: np.ndarray, motion: Motion) -> str:
    """One situation; returns in a word what the robot does in it."""
    for variable, seen in zip(task.states.inputs, task.states.bins(s), strict=True):
        limits = np.linspace(INNERMOST, OUTERMOST, variable.n_bins + 1)
        rings = list(pairwise(limits))
        draw_sector(
            ax, rings, seen, (0, 0), PIONEER.lasers[LASERS.index(variable.name)][2]
        )
    draw_robot(ax)
    best = int(q_s.argmax())
    v, turn = motion_of(task, best, motion)
    draw_motion(ax, v, turn, scale=0.8)
    ax.set(xlim=(-0.75, 1.4), ylim=(-1.4, 1.4), aspect="equal", xticks=[], yticks=[])
    for spine in ax.spines.values():
        spine.set_color("#c0c0c0")
    second = np.partition(q_s, -2)[-2]
    word = in_words(v, turn)
    if word == "forward":
        word += ", fast" if v > FAST else ", slow"
    ax.set_xlabel(
        f"{word}\nQ {q_s[best]:.1f}, next best {second:.1f}".replace("-", "−"),
        fontsize=9,
    )
    return word
