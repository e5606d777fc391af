"""A robot of wander_simple learns by true online SARSA(λ), with the learner's trace."""

import numpy as np

from rlrobot_course.drives.by_your_code import Reel
from rlrobot_course.drives.worlds import FilmedWorld
from rlrobot_grading.answers.values import Function

TASK, SEED, STEPS = "wander_simple", 0, 360
ALPHA, GAMMA, LAMBDA = 0.4, 0.9, 0.9


def by_dutch(dutch: Function, reel: Reel) -> None:
    """The learner's dutch makes the trace of each visited pair; the film has the last steps of learning."""
    world = FilmedWorld(TASK, SEED, reel, STEPS)
    q, e, q_old = world.table(), world.table(), 0.0

    def choose(s: int) -> int:
        """By softmax, as in lesson 04, at T = 1."""
        preferences = 100 * (1 - GAMMA) / world.r_max * q[s]
        p = np.exp(preferences - preferences.max())
        return int(np.searchsorted(np.cumsum(p / p.sum()), world.u, side="right"))

    s = world.reset()
    a = choose(s)
    for _ in range(STEPS):
        s_next, r, _, _ = world.step(a)  # no episode ends here
        a_next = choose(s_next)
        q_sa, q_next = q[s, a], q[s_next, a_next]
        delta = r + GAMMA * q_next - q_sa
        e[s, a] = dutch(e[s, a], ALPHA)
        q += ALPHA * (delta + q_sa - q_old) * e
        q[s, a] -= ALPHA * (q_sa - q_old)
        e *= GAMMA * LAMBDA
        q_old = q_next
        s, a = s_next, a_next


drives = {"dutch": by_dutch}
