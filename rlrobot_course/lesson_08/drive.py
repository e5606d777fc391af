"""A robot of wander_simple learns by true online SARSA(λ), with the learner's trace."""

import numpy as np

from rlrobot_course.drives.by_your_code import Reel
from rlrobot_course.drives.worlds import FilmedWorld
from rlrobot_course.lesson_04.exercises import draw, normalise, softmax
from rlrobot_course.lesson_06.exercises import sarsa_learn
from rlrobot_grading.answers.values import Function

TASK, SEED, STEPS = "wander_simple", 0, 360
ALPHA, GAMMA, LAMBDA = 0.4, 0.9, 0.9


def by_dutch(dutch: Function, reel: Reel) -> None:
    """The learner's dutch makes the trace of each visited pair; the film has the last steps of learning."""
    world = FilmedWorld(TASK, SEED, reel, STEPS)
    q, e, q_old = world.table(), world.table(), 0.0

    def choose(q: np.ndarray, s: int) -> int:
        a: int = draw(softmax(normalise(q[s], world.r_max, GAMMA), 1.0), world.u)
        return a

    def update(
        q: np.ndarray,
        s: int,
        a: int,
        r: float,
        s_next: int,
        a_next: int,
        terminated: bool,
    ) -> None:
        nonlocal q_old
        q_sa = q[s, a]
        q_next = 0.0 if terminated else q[s_next, a_next]
        delta = r + GAMMA * q_next - q_sa
        e[s, a] = dutch(e[s, a], ALPHA)
        q += ALPHA * (delta + q_sa - q_old) * e
        q[s, a] -= ALPHA * (q_sa - q_old)
        e[:] *= GAMMA * LAMBDA
        q_old = q_next

    sarsa_learn(world, q, choose, update, STEPS)


drives = {"dutch": by_dutch}
