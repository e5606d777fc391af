"""Right answers and tapes of assignment 3; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, with_pages
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_GAMMA,
    FINE_LAMBDA,
    rows,
    with_columns,
)


def return_over_n(rewards, values, t, n, gamma):
    last = min(t + n, len(rewards))
    g = sum(gamma ** (k - t) * rewards[k] for k in range(t, last))
    if t + n < len(rewards):
        g += gamma**n * values[t + n]
    return g


REWARDS = [1.0, -2.5, 0.5, 3.0, 1.5]
VALUES = [
    4.0,
    2.5,
    -1.0,
    0.5,
    6.0,
    50.0,
]  # the last is of where nothing follows, and tempts those who look there


def trace_after(path, n_states, decay, kind):
    e = np.zeros(n_states)
    for s in path:
        e *= decay
        e[s] = e[s] + 1 if kind == "accumulating" else 1
    return e


FINE_REWARDS = [1.23456, -0.98765, 3.14159]
FINE_VALUES = [0.54321, 2.71828, -1.41421, 9.87654]

KINDS = ("accumulating", "replacing")
EPISODES = with_columns(
    rows(
        "path rewards",
        ([1, 2, 3], [1.5, -0.5]),
        ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
        ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
        ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
        ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
        ([2, 0], [2.5]),
        *6 * (([1, 2, 1, 0], FINE_REWARDS),),
    ),
    alpha=(0.5, 0.25, 0.4, 0.1, 0.3, 0.2, FINE_ALPHA, FINE_ALPHA, 0.3, 0.2, 0.3, 0.2),
    gamma=(0.9, 0.8, 0.95, 0.9, 0.7, 0.9, FINE_GAMMA, FINE_GAMMA, 0.99, 0.99, 0.0, 0.8),
    lam=(0.8, 0.5, 0.9, 0.7, 0.6, 0.3, FINE_LAMBDA, FINE_LAMBDA, 1.0, 1.0, 0.5, 0.0),
)
V_START = np.array(
    [7.0, 1.5, -0.5, 9.0]
)  # of 0 and 3, where the episodes end, the values tempt, too


def td_episode(v, path, rewards, alpha, gamma, lam, kind):
    e = np.zeros(len(v))
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_next = v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v[s]
        e *= gamma * lam
        e[s] = e[s] + 1 if kind == "accumulating" else 1
        v += alpha * delta * e


def true_online_episode(v, path, rewards, alpha, gamma, lam):
    e, v_old = np.zeros(len(v)), 0
    for t in range(len(rewards)):
        s, s_next = path[t], path[t + 1]
        v_s, v_next = v[s], v[s_next] if t + 1 < len(rewards) else 0
        delta = rewards[t] + gamma * v_next - v_s
        e *= gamma * lam
        e[s] = (1 - alpha) * e[s] + 1
        v += alpha * (delta + v_s - v_old) * e
        v[s] -= alpha * (v_s - v_old)
        v_old = v_next


def watkins_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    best = 0 if terminated else max(q[s_next])
    greedy = not terminated and q[s_next, a_next] == best
    delta = r + gamma * best - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam if greedy else 0


Q = np.array([[0.5, 2.0, 2.0], [4.0, -1.0, 5.5], [0.75, 0.75, 0.75], [0.0, 6.0, 7.0]])
STEPS = (
    (0, 1, 10.0, 2, 1, False),  # a tie in s', and a' is not the first of the best
    (2, 1, -0.5, 1, 2, False),
    (1, 2, 1.5, 0, 0, False),  # a' explores: cut
    (0, 0, -2.0, 1, 2, False),
    (1, 2, -30.5, 1, 2, False),  # a' was best, and this very step makes it worse
    (1, 2, 0.25, 2, 0, False),
    (2, 0, 2.5, 3, 0, True),
    (0, 2, 1.25, 1, 0, False),
    (1, 0, 0.5, 2, 2, False),
    (2, 2, -1.25, 3, 2, True),
    (1, 1, 4.5, 0, 1, False),
    (0, 2, 1.23456, 1, 0, False),
    (1, 0, 0.5, 2, 0, False),  # another trace is in this row already
    (1, 2, 0.75, 0, 1, False),  # two are, and they differ
    (0, 1, 0.25, 1, 0, False),
    (1, 0, -0.5, 2, 0, False),
    (2, 0, 1.5, 0, 1, False),
)
# of each step but the last six
ALPHAS = (0.1, 0.5, 0.25, 0.1, 0.4, 0.3, 0.7, 0.05, 0.2, 0.4, 0.3)
GAMMAS = (0.9, 0.5, 0.8, 0.9, 0.9, 0.95, 0.9, 0.6, 0.9, 0.7, 0.8)
LAMBDAS = (0.9, 0.8, 0.7, 0.6, 0.9, 0.8, 0.9, 0.5, 0.9, 0.8, 0.7)

check = with_pages(
    globals(),
    return_over_n=Exercise(
        return_over_n,
        returns="G",
        tape=[
            {"rewards": REWARDS, "values": VALUES, "t": t, "n": n, "gamma": gamma}
            for t, n, gamma in (
                (0, 1, 0.5),
                (0, 3, 0.9),
                (1, 2, 0.8),
                (2, 3, 0.9),
                (3, 4, 0.7),
                (4, 1, 0.6),
                (1, 3, 0.95),
                (3, 1, 0.4),
            )
        ]
        + [
            {
                "rewards": FINE_REWARDS,
                "values": FINE_VALUES,
                "t": 0,
                "n": 2,
                "gamma": gamma,
            }
            for gamma in (FINE_GAMMA, 0.0, 0.99)
        ],
    ),
    trace_after=Exercise(
        trace_after,
        returns="e",
        tape=rows(
            "path n_states decay kind",
            ([2], 4, 0.5, "accumulating"),
            ([1, 2, 1], 4, 0.9, "replacing"),
            ([1, 2, 1], 4, 0.9, "accumulating"),
            ([3, 3, 3, 0], 4, 0.75, "replacing"),
            ([0, 1, 2, 1, 1, 3], 4, 0.6, "accumulating"),
            ([0, 1, 2, 1, 1, 3], 4, 0.6, "replacing"),
            ([1, 2, 1], 3, 0.87654, "accumulating"),
        ),
    ),
    td_episode=Exercise(
        td_episode, memory={"v": V_START}, tape=with_columns(EPISODES, kind=KINDS * 6)
    ),
    true_online_episode=Exercise(
        true_online_episode, memory={"v": V_START}, tape=EPISODES
    ),
    watkins_update=Exercise(
        watkins_update,
        memory={"q": Q, "e": np.zeros_like(Q)},
        tape=with_columns(
            rows("s a r s_next a_next terminated", *STEPS),
            alpha=(*ALPHAS, FINE_ALPHA, 0.3, 0.2, 0.3, 0.2, 0.4),
            gamma=(*GAMMAS, FINE_GAMMA, 0.8, 0.9, 0.99, 0.0, 0.9),
            lam=(*LAMBDAS, FINE_LAMBDA, 0.7, 0.9, 1.0, 0.8, 0.0),
        ),
    ),
)
