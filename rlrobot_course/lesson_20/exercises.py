"""Right answers and tapes of lesson 20; the pages of this folder have the tasks, hints and mistakes."""

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_FOR_Q,
    FINE_GAMMA,
    Q_START,
    Q_TAPE,
    with_columns,
)


def learn_from(q, rows, alpha, gamma):
    for s, a, r, s_next, terminated in rows:
        best = 0 if terminated else max(q[s_next])
        q[s, a] = q[s, a] + alpha * (r + gamma * best - q[s, a])


_ROWS = [tuple(step.values()) for step in (*Q_TAPE, *FINE_FOR_Q)]
# Recordings of one row, of an episode, of what was cut off, of several episodes; and one that comes back to its pairs.
_PARTS = ((0, 1), (4, 5), (0, 5), (5, 8), (0, 9), (0, 0), (8, 10), (0, 4), (0, 4))

check = with_pages(
    globals(),
    learn_from=Exercise(
        learn_from,
        memory={"q": Q_START},
        tape=with_columns(
            [{"rows": _ROWS[first:last]} for first, last in _PARTS],
            alpha=(0.1, 0.5, 0.2, 0.3, 0.1, 0.1, FINE_ALPHA, 0.2, 0.3),
            gamma=(0.9, 0.8, 0.9, 0.7, 0.95, 0.9, FINE_GAMMA, 0.0, 0.99),
        ),
    ),
    two_targets=Question(
        Formula("(r + γ * best, r + γ * taken)", r=10, γ=0.9, best=40, taken=5)
    ),
)
