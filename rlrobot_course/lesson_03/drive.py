"""A robot of wander_simple learns at random by the learner's functions, and then drives by its table."""

import numpy as np

from rlrobot_course.drives.by_your_code import Reel
from rlrobot_course.drives.worlds import FilmedWorld, drive_by_table, run
from rlrobot_course.worlds.callbacks import QLearner
from rlrobot_grading.answers.values import Function

TASK = "wander_simple"
LEARNED, DRIVEN = 500, 60  # steps
TOWARDS_TARGETS = 1000  # steps: after fewer, a wrong target may still do
SEED, DRIVE_SEED = 0, 50


def by_target(target: Function, reel: Reel) -> None:
    """The values learn towards the learner's target; the film begins where the robot drives by them."""
    world = FilmedWorld(TASK, SEED, Reel(), TOWARDS_TARGETS)
    q = world.table()

    def learn(s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
        q[s, a] += 0.1 * (target(q, r, s_next, terminated, 0.9) - q[s, a])

    run(world, lambda s: int(world.u * world.n_actions), learn)
    drive_by_table(q, TASK, DRIVE_SEED, reel, DRIVEN)


def by_update(update: Function, reel: Reel) -> None:
    """The learner's update learns from each step."""
    world = FilmedWorld(TASK, SEED, reel, LEARNED)
    q = world.table()

    def learn(s: int, a: int, r: float, s_next: int, terminated: bool) -> None:
        update(q, s, a, r, s_next, terminated, 0.1, 0.9)

    run(world, lambda s: int(world.u * world.n_actions), learn)
    drive_by_table(q, TASK, DRIVE_SEED, reel, DRIVEN)


def by_learn(learn: Function, reel: Reel) -> None:
    """The learner's loop drives the robot, with a right update."""
    world = FilmedWorld(TASK, SEED, reel, LEARNED)
    q = world.table()

    def choose(q: np.ndarray, s: int) -> int:
        return int(world.u * world.n_actions)

    learn(world, q, choose, QLearner(0.1, 0.9), LEARNED)
    drive_by_table(q, TASK, DRIVE_SEED, reel, DRIVEN)


drives = {"target": by_target, "update": by_update, "learn": by_learn}
