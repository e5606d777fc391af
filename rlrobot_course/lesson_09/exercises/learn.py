"""The whole learner: TOSL+QBIASSR."""

from __future__ import annotations

from functools import partial

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.lesson_03.solutions import draw, softmax
from rlrobot_course.lesson_06.solutions import true_online_update
from rlrobot_course.lesson_07.solutions import bias  # noqa: F401  (a mistake calls it)
from rlrobot_course.lesson_09.exercises.choose import choose
from rlrobot_course.lesson_09.exercises.preferences import preferences  # noqa: F401  (a mistake calls it)
from rlrobot_course.lesson_09.given import ABOVE, ENDS, LENDERS, OTHERS, USUAL, drives, library, ring
from rlrobot_course.lesson_09.learners import COMMON


def learn(env, shape, n_actions, r_max, steps, rng, alpha, gamma, lam, temperature):
    q = np.zeros((np.prod(shape), n_actions))
    e, q_old = np.zeros_like(q), 0.0

    def act(s):
        return choose(q, shape, s, temperature, r_max, gamma, rng.random())

    s = env.reset()
    a = act(s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = act(s_next)
        q_old = true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)
        s, a = s_next, a_next
        if terminated or truncated:
            e[:], q_old = 0.0, 0.0
            s = env.reset()
            a = act(s)
    return q


WITNESSES = read_answers(
    __file__, {"choose": choose, "draw": draw, "softmax": softmax, "true_online_update": true_online_update}
)[1]

exercise = Exercise(
    task="let TOSL+QBIASSR learn for a number of steps, and return q",
    right=learn,
    library=partial(library, learn),
    returns="q",
    lenders=LENDERS | ABOVE,
    tape=drives(
        [
            ring((3, 4), ENDS, 10, **USUAL, temperature=1.0),
            ring((4, 5), ENDS[::-1], 80, **OTHERS, temperature=4.0),
        ],
        "temperature",
    ),
    mistakes=COMMON,
    hints=(
        "The box above has a line of code for nearly each of its own. The first choice comes before the loop.",
        "In the loop: env.step, choose for s_next, q_old = true_online_update(…), then s, a = s_next, a_next.",
        "At the end of the loop: if terminated or truncated: e[:], q_old = 0.0, 0.0; s = env.reset(); "
        "a = choose(q, …).",
    ),
    gained="This is the method of the paper, in twenty lines of your own. Now let it drive.",
    witnesses=WITNESSES,
)
