"""Right answers and tapes of lesson 07; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_GAMMA,
    FINE_LAMBDA,
    OTHER_Q,
    Q_START,
    TAPE,
    rows,
    with_columns,
)

BY_HAND = Formula(
    "Q + α * δ * e", Q=2, α=0.1, δ=-10, γ=0.9, λ=0.5, steps=2, e="(γ * λ) ** steps"
)


def sarsa_lambda_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


# one episode; (0, 1) and (1, 2) come twice, and in the fourth step the next pair has a trace already
EPISODE = [TAPE[i] for i in (0, 1, 2, 3, 7)] + [
    {"s": 1, "a": 2, "r": -0.02, "s_next": 1, "a_next": 2, "terminated": False},
    TAPE[8],
]
# Another world, two actions: some traces are small (a threshold would drop them), one reward is 0, values have digits
OTHER_E = np.array([[0.0073, 0.0], [0.31, 0.0004], [0.0, 0.62]])
OTHER = rows(
    "q e s a r s_next a_next terminated",
    (OTHER_Q, OTHER_E, 1, 1, -0.3, 2, 1, False),
    (OTHER_Q, OTHER_E, 2, 0, 0.0, 1, 1, False),
    (OTHER_Q, OTHER_E, 0, 1, 0.0, 1, 0, True),
    (OTHER_Q, OTHER_E, 2, 0, 0.1234, 1, 0, True),  # δ = 0
    (OTHER_Q, OTHER_E, 1, 0, 1.23456, 2, 1, False),
)
ALPHAS = (0.1, 0.3, 0.25, 0.15, 0.6, 0.45, 0.2, 0.35, 0.12, 0.37, 0.2)
GAMMAS = (0.9, 0.8, 0.95, 0.7, 0.9, 0.55, 0.99, 0.85, 0.6, 0.93, 0.9)
LAMBDAS = (0.8, 0.7, 0.6, 0.9, 0.5, 0.85, 0.75, 0.95, 0.4, 0.0, 0.5)

check = with_pages(
    globals(),
    traced_by_hand=Question(BY_HAND),
    sarsa_lambda_update=Exercise(
        sarsa_lambda_update,
        memory={"q": Q_START, "e": np.zeros_like(Q_START)},
        tape=with_columns(
            [*EPISODE, *OTHER, TAPE[0], TAPE[1]],
            alpha=(*ALPHAS, FINE_ALPHA, 0.3, 0.2),
            gamma=(*GAMMAS, FINE_GAMMA, 0.9, 0.0),
            lam=(*LAMBDAS, FINE_LAMBDA, 1.0, 0.5),
        ),
    ),
)
