"""What the reader of lesson 03 moves: the learning rate of one number, and drives down a corridor."""

import numpy as np

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_03.exercises import update as lesson_update
from rlrobot_course.lesson_03.figures import plot_one_value, plot_run_back
from rlrobot_edu import Agent, Task, make_env
from rlrobot_edu import steps as walk
from rlrobot_edu.learning.algorithms.q_learning import update

GAMMA = 0.9
ALPHAS = (0.02, 0.1, 1.0)  # of the still; the middle one is what the handle opens with
STEPS = 6000
MOST = 45  # the highest value that is drawn

CELLS, REWARD = 10, 10.0  # of the corridor, as in lesson 07
DRIVES, OPENS = 60, 4
HALF = 0.5  # the learning rate with which the corridor opens


def one_value(task: Task, s: int, a: int, true: float) -> Handle:
    """Q(s, a) at each of its visits, and the targets, as Q-learning has them; the robot acts at random.

    true: the value that it should come to
    """
    agent = Agent(task, "Q+RANDOM", seed=0)
    kinds: dict[tuple[int, int, float, int, bool], int] = {}  # with their numbers
    taken = []
    for step in walk(agent, make_env(task, seed=0), STEPS):
        happened = (step.s, step.a, float(step.r), step.s_next, bool(step.terminated))
        taken.append(kinds.setdefault(happened, len(kinds)))
    states, actions = agent.q.shape
    feed = {
        "kinds": [list(kind) for kind in kinds],
        "walk": taken,
        "states": states,
        "actions": actions,
        "s": s,
        "a": a,
        "alpha": ALPHAS[1],
        "gamma": GAMMA,
        "true": float(true),
        "most": MOST,
    }
    settings = {f"α = {alpha}": {"alpha": alpha} for alpha in ALPHAS}
    return Handle(
        f"Q({s}, {a}) and the learning rate",
        __package__,
        ["alpha.js"],
        feed,
        plot_one_value(task, s, a, settings, steps=STEPS, true=true),
        {"update": update},
    )


def run_back() -> Handle:
    """A corridor whose last step earns a reward: what Q-learning knows in each cell, drive by drive."""
    feed = {
        "cells": CELLS,
        "reward": REWARD,
        "drives": DRIVES,
        "opens": OPENS,
        "alpha": HALF,
        "gamma": GAMMA,
    }
    return Handle(
        "A value that runs back along a corridor",
        __package__,
        ["corridor.js"],
        feed,
        plot_run_back(corridor_values(OPENS, HALF, GAMMA)),
        {"update": update},
    )


def corridor_values(drives: int, alpha: float, gamma: float) -> np.ndarray:
    """Q of going on in each cell after so many drives, array (CELLS,)."""
    q = np.zeros((CELLS + 1, 1))  # nothing follows the last
    for _ in range(drives):
        for s in range(CELLS):
            last = s == CELLS - 1
            r = REWARD if last else 0.0
            lesson_update(q, s, 0, r, s + 1, last, alpha, gamma)
    return q[:CELLS, 0]
