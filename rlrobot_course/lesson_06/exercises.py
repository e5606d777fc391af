"""Right answers and tapes of lesson 06; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.callbacks import Fickle, SarsaLearner
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_GAMMA,
    OTHER_Q,
    Q_START,
    TAPE,
    TapeWorld,
    rows,
    with_columns,
)

FALL = Formula(
    "1 - well ** steps", ε=0.1, actions=4, steps=11, risk="ε / actions", well="1 - risk"
)


def sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a_next]
    delta = target - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


# Another world for the last five steps: two actions, values with many digits, and an end that comes with a loss.
OTHER_STEPS = rows(
    "q s a r s_next a_next terminated",
    (OTHER_Q, 1, 1, -0.3, 2, 1, False),
    (OTHER_Q, 0, 1, -5.5, 1, 0, np.True_),
    (OTHER_Q, 2, 0, 0.0, 1, 1, False),
    (OTHER_Q, 1, 0, 0.0, 0, None, True),
    (OTHER_Q, 1, 0, 1.23456, 0, 1, False),
)
# α and γ of each step: none is the default twice, and no product of them is round
ALPHAS = (0.1, 0.3, 0.25, 0.1, 0.6, 0.45, 0.2, 0.35, 0.15, 0.37, 0.23, 0.31, 0.47)
GAMMAS = (0.9, 0.8, 0.95, 0.7, 0.9, 0.55, 0.99, 0.85, 0.6, 0.93, 0.81, 0.77, 0.88)


def sarsa_learn(env, q, choose, update, steps):
    s = env.reset()
    a = choose(q, s)
    for _ in range(steps):
        s_next, r, terminated, truncated = env.step(a)
        a_next = choose(q, s_next)
        update(q, s, a, r, s_next, a_next, terminated)
        s, a = s_next, a_next
        if terminated or truncated:
            s = env.reset()
            a = choose(q, s)


WORLD = TapeWorld()

check = with_pages(
    globals(),
    fall=Question(FALL),
    sarsa_update=Exercise(
        sarsa_update,
        memory={"q": Q_START},
        tape=with_columns(
            (*TAPE, *OTHER_STEPS, TAPE[0]),
            alpha=(*ALPHAS, FINE_ALPHA, 0.3),
            gamma=(*GAMMAS, FINE_GAMMA, 0.0),
        ),
    ),
    sarsa_learn=Exercise(
        sarsa_learn,
        memory={
            "env": WORLD,
            "choose": Fickle(WORLD),
            "q": Q_START + 0.3,
            "update": SarsaLearner(),
        },
        tape=[{"update": SarsaLearner(), "steps": n} for n in (1, 1, 4, 9, 12)],
    ),
)
