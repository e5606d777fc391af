"""Right answers and tapes of lesson 03; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.callbacks import Fickle, QLearner, Ranked, Wavering
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_FOR_Q,
    FINE_GAMMA,
    Q_START,
    Q_TAPE,
    TapeWorld,
    rows,
    with_columns,
)

BY_HAND = Formula(
    "Q + α * (r + γ * best - Q)", Q=4, α=0.2, r=10, γ=0.9, best=6, last=3.7, middle=-1, mean=2.9, sum=8.7,
    α_of_the_example=0.1, target="r + γ * best", δ="target - Q",
)  # fmt: skip


def target(q, r, s_next, terminated, gamma):
    if terminated:
        return r
    return r + gamma * max(q[s_next])


# as in the other lessons, and a state in which every action is bad
Q = np.vstack([Q_START, [-1.375, -3.0, -2.0]])


def update(q, s, a, r, s_next, terminated, alpha, gamma):
    delta = target(q, r, s_next, terminated, gamma) - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.1, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3)
GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8)
AT_A_WALL = rows(
    "s a r s_next terminated",
    (4, 1, -2.0, 4, False),
    (4, 0, -0.02, 4, False),  # it stays, and a is the best action there
)


def learn(env, q, choose, update, steps):
    s = env.reset()
    for _ in range(steps):
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        s = s_next
        if terminated or truncated:
            s = env.reset()


WORLD = TapeWorld()

check = with_pages(
    globals(),
    q_by_hand=Question(BY_HAND),
    target=Exercise(
        target,
        returns="target",
        tape=rows(
            "q r s_next terminated gamma",
            (Q, 1.25, 1, False, 0.75),
            (Q, -0.02, 2, False, 0.9),
            (Q, 10.0, 3, True, 0.9),
            (Q, -2.0, 4, False, 0.95),
            (Q, -2.0, 1, True, 0.5),
            (Q, 0.0, 0, False, 0.6),
            (Q[:, :2] + 0.0625, 3.0, 2, False, 0.99),
            (Q, 0.37, 4, np.True_, 0.85),  # as a comparison in numpy has it
            (Q[1:3], 10.0, 0, False, 0.25),
            (
                np.array([[0.4, -7.0, 0.1, 0.3], [-8.0, 0.9, -0.5, 1.2]]),
                0.125,
                1,
                False,
                0.9,
            ),
            (np.array([[1.5, 0.0], [-3e4, -12500.0]]), -100.0, 1, False, 0.8),
            (Q + 0.01234, 1.23456, 1, False, FINE_GAMMA),
            (Q, 1.25, 1, False, 0.0),
        ),
    ),
    update=Exercise(
        update,
        memory={"q": Q},
        tape=with_columns(
            (*Q_TAPE, *AT_A_WALL, *3 * FINE_FOR_Q),
            alpha=(*ALPHAS, FINE_ALPHA, 0.3, 0.2),
            gamma=(*GAMMAS, FINE_GAMMA, 0.0, 0.99),
        ),
    ),
    learn=Exercise(
        learn,
        memory={"env": TapeWorld(), "q": Q[:4], "update": QLearner(0.1, 0.9)},
        tape=[
            {"choose": Ranked(rank), "update": QLearner(alpha, gamma), "steps": n}
            for rank, alpha, gamma, n in (
                (1, 0.1, 0.9, 4),
                (2, 0.5, 0.7, 2),
                (0, 0.3, 0.8, 9),
                (1, 0.25, 0.9, 1),
            )
        ]
        + [{"choose": Wavering(1), "update": QLearner(0.4, 0.9), "steps": 7}]
        + [
            {
                "env": WORLD,
                "choose": Fickle(WORLD),
                "update": QLearner(0.2, 0.9),
                "steps": 9,
            }
        ],
    ),
)
