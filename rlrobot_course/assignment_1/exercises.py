"""Right answers and tapes of assignment 1; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Case, Exercise, with_pages
from rlrobot_course.worlds.callbacks import Chooser, Weighing
from rlrobot_course.worlds.tapes import (
    FINE_ALPHA,
    FINE_GAMMA,
    Q_START,
    PatientWorld,
    rows,
)


def state_of(cell, voltage, cuts):
    charge = sum(voltage > cut for cut in cuts)
    return cell * (len(cuts) + 1) + charge


VOLTS = [11.25, 11.75, 12.25]


def other_cell(rng: np.random.Generator, case: Case) -> Case:
    """A case of `state_of` in another cell, its voltages moved; what lies on a cut stays there."""
    volts = float(rng.integers(-3, 4))
    cuts = [cut + volts for cut in case["cuts"]]
    return {
        "cell": case["cell"] + int(rng.integers(1, 4)),
        "voltage": case["voltage"] + volts,
        "cuts": cuts,
    }


def returns(rewards, ends, gamma):
    g, follows = [0.0] * len(rewards), 0.0
    for t in range(len(rewards) - 1, -1, -1):
        if ends[t]:
            follows = 0.0
        g[t] = rewards[t] + gamma * follows
        follows = g[t]
    return g


def replay(q, log, alpha, gamma):
    for s, a, r, s_next, terminated in reversed(log):
        target = r if terminated else r + gamma * max(q[s_next])
        q[s, a] += alpha * (target - q[s, a])


LOG = [
    (0, 1, -1.5, 1, False),
    (1, 0, -1.25, 2, False),
    (2, 2, 20.5, 3, True),
    (0, 2, -1.0, 0, False),
    (0, 1, -20.0, 3, True),
]


def greedy(q):
    best = q == np.max(q, axis=1, keepdims=True)
    return best / best.sum(axis=1, keepdims=True)


def train(env, q, choose, episodes, alpha, gamma):
    sums = []
    for _ in range(episodes):
        s, total, over = env.reset(), 0.0, False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            target = r if terminated else r + gamma * max(q[s_next])
            q[s, a] += alpha * (target - q[s, a])
            s, total, over = s_next, total + r, terminated or truncated
        sums.append(total)
    return sums


check = with_pages(
    globals(),
    state_of=Exercise(
        state_of,
        returns="state",
        tape=rows(
            "cell voltage cuts",
            (0, 11.0, VOLTS),
            (0, 12.0, VOLTS),
            (2, 12.5, VOLTS),
            (1, 11.75, VOLTS),
            (5, 11.5, [11.25]),
            (3, 13.0, [11.0, 11.5, 12.0, 12.5, 13.5]),
            (1, 9.0, VOLTS),
            (
                2,
                11.7504,
                VOLTS,
            ),  # a reading, or a cut point, that is rounded is in another bin
            (1, 11.7501, [11.2504, 11.7504]),
            (3, 12.0, []),
        ),
        another=other_cell,
    ),
    returns=Exercise(
        returns,
        returns="returns",
        tape=rows(
            "rewards ends gamma",
            ([-1.0, -1.0, 20.0], [False, False, True], 0.5),
            ([-1.0, 20.0, -1.0, -20.0], [False, True, False, True], 0.9),
            ([4.0, 2.5, 1.5], [False, False, False], 0.8),
            ([7.5], [True], 0.9),
            ([3.0, -2.0, 5.0, 1.25, 6.0], [True, True, False, True, False], 0.6),
            ([], [], 0.6),
            (
                [-1, 2, 5],
                [False, False, True],
                0.5,
            ),  # whole numbers, whose returns are none
            ([1.23456, -0.98765, 3.14159], [False, True, False], 0.87654),
            ([1.23456, -0.98765, 3.14159], [False, False, True], 0.87654),
            ([3.0, -2.0, 5.0], [False, False, True], 0.0),
            ([3.0, -2.0, 5.0], [False, False, True], 0.99),
        ),
    ),
    replay=Exercise(
        replay,
        memory={"q": Q_START},
        tape=rows(
            "log alpha gamma",
            (LOG[:1], 0.25, 0.9),
            (LOG[2:3], 0.5, 0.9),
            (LOG[:3], 0.5, 0.8),
            (LOG, 0.1, 0.95),
            ([], 0.1, 0.95),
            ([(2, 0, 1.23456, 1, False), *LOG[1:]], FINE_ALPHA, FINE_GAMMA),
            (LOG, 0.3, 0.0),
            (LOG, 0.2, 0.99),
        ),
    ),
    greedy=Exercise(
        greedy,
        returns="policy",
        tape=rows(
            "q[]",
            ([[1.5, 2.5, 0.5], [0.25, -1.0, -2.0]],),
            ([[2.5, 2.5, 0.5], [0.0, 0.0, 0.0], [-3.5, -1.5, -1.5]],),
            ([[-0.5, -1.5]],),
            ([[0.0, 3.5, 3.5, 3.5], [5.5, 0.0, 5.5, 1.0]],),
            ([[0.5, 1.25, 0.75], [7.5, 7.25, 7.0], [0.0, 0.125, -2.5]],),
            ([[1.23456, 1.23447], [0.00043, 0.0]],),  # nearly equal is not equal
        ),
    ),
    train=Exercise(
        train,
        returns="sums",
        memory={"env": PatientWorld(), "q": Q_START},
        tape=[
            {"choose": Chooser(rank), "episodes": n, "alpha": alpha, "gamma": gamma}
            for rank, n, alpha, gamma in (
                (0, 1, 0.5, 0.9),
                (1, 1, 0.1, 0.8),
                (2, 3, 0.25, 0.9),
                (0, 2, 0.4, 0.7),
            )
        ]
        + [
            {"choose": Weighing(1), "episodes": 3, "alpha": alpha, "gamma": gamma}
            for alpha, gamma in ((FINE_ALPHA, FINE_GAMMA), (0.3, 0.0), (0.2, 0.99))
        ],
    ),
)
