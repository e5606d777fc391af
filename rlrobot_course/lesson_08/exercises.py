"""Right answers and tapes of lesson 08; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import (
    FINE,
    FINE_ALPHA,
    FINE_GAMMA,
    FINE_LAMBDA,
    Q_START,
    TAPE,
    rows,
    with_columns,
)


def dutch(e, alpha):
    return (1 - alpha) * e + 1


SETTLES = Formula("1 / (1 - (1 - α) * left)", α=0.4, γ=0.9, λ=0.9, left="(γ * λ) ** 2")
BY_HAND = Formula(
    "first_line - α * (Q - Q_old)", Q=6, Q_old=1, Q_next=10, r=10, γ=0.9, α=0.25, e_before=0.6,
    e="(1 - α) * e_before + 1", δ="r + γ * Q_next - Q", first_line="Q + α * (δ + Q - Q_old) * e",
)  # fmt: skip


def true_online_update(
    q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam
):
    q_sa = q[s, a]
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = dutch(e[s, a], alpha)
    q += alpha * (delta + q_sa - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


# One episode: pairs come back, some at once, and the last step ends it. (No episode follows: there e and Q_old start
# afresh, which is not the update's job.) It begins with traces and a Q_old that an earlier step may have left.
EPISODE = [*TAPE[5:7], FINE, *TAPE[:2], *TAPE[:5]]
E_START = np.array(
    [[0.35, 0.0, 0.0], [0.0, 0.62, 0.0], [0.0, 0.0, 0.17], [0.004, 0.0, 0.0]]
)
ALPHAS = (0.3, 0.3, FINE_ALPHA, 0.3, 0.4, 0.2, 0.3, 0.45, 0.5, 0.6)
GAMMAS = (0.9, 0.9, FINE_GAMMA, 0.99, 0.0, 0.8, 0.9, 0.7, 0.95, 0.85)
LAMBDAS = (0.8, 0.0, FINE_LAMBDA, 1.0, 0.8, 0.9, 0.6, 0.8, 0.7, 0.9)

check = with_pages(
    globals(),
    dutch=Exercise(
        dutch,
        returns="e",
        tape=rows(
            "e alpha",
            (0.813, 0.3),
            (0.0, 0.5),
            (1.377, 0.12),
            (2.37, 0.25),
            (1.4, 1.0),
            (0.53, 0.0),
            (0.12345, 0.54321),
        ),
    ),
    settles=Question(SETTLES),
    true_online_by_hand=Question(BY_HAND),
    true_online_update=Exercise(
        true_online_update,
        memory={"q": Q_START, "e": E_START, "q_old": 0.7},
        returns="q_old",
        tape=with_columns(EPISODE, alpha=ALPHAS, gamma=GAMMAS, lam=LAMBDAS),
    ),
)
