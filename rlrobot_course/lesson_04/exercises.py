"""Right answers and tapes of lesson 04; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, with_pages
from rlrobot_course.worlds import tapes
from rlrobot_edu.widgets.kernels import probabilities


def epsilon_greedy(q_s, epsilon):
    best = q_s == q_s.max()
    return epsilon / len(q_s) + (1 - epsilon) * best / best.sum()


def draw(p, u):
    total = 0.0
    for a in range(len(p)):
        total += p[a]
        if u < total:
            return a


def softmax(x, temperature):
    powers = np.exp((x - x.max()) / temperature)
    return powers / powers.sum()


def normalise(q_s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return q_s * 100 / q_max


check = with_pages(
    globals(),
    epsilon_greedy=Exercise(
        epsilon_greedy,
        returns="p",
        tape=tapes.rows(
            "q_s[] epsilon",
            ([2.0, 5.0, 1.0, 5.0, 0.0], 0.2),
            ([-3.0, -2.0, -5.0], 0.61),
            ([3.0, 1.0, 2.0, -8.0], 0.137),
            ([4.0, 4.0, 1.0, 4.0, 3.0, 2.0], 0.25),
            ([2.0, 2.004, 2.002], 0.3),
            ([-0.2, 0.0, -2.0, 0.0], 0.5),
            ([0.0, 0.0, 0.0, 0.0], 0.1),
            ([-1.0, -2.0, -1.0], 0.0),
            ([1.0, 2.0], 1.0),
            ([-0.199990, -0.2, -0.199990, -0.5], 0.3),  # nearly equal is not equal
            ([0.54321, 1.23456, 1.23456], 0.12345),
        ),
    ),
    draw=Exercise(
        draw,
        library=tapes.draw,
        returns="action",
        tape=tapes.rows(
            "p[] u",
            ([0.2, 0.3, 0.1, 0.4], 0.45),
            ([0.3, 0.3, 0.4], 0.35),
            ([0.2, 0.5, 0.3], 0.1),
            ([0.2, 0.5, 0.3], 0.9),
            ([0.6, 0.1, 0.1, 0.2], 0.75),
            ([0.1, 0.2, 0.7], 0.25),
            ([0.25, 0.25, 0.25, 0.25], 0.5),
            ([0.0, 1.0, 0.0], 0.0),
            ([0.5, 0.0, 0.5], 0.5),
            ([1.0], 0.3),
            ([0.4, 0.05, 0.3, 0.1, 0.15], 0.97),
            ([0.7, 0.3], 0.65),
            # u lies beside a border, where whoever rounds draws another action
            ([1 / 3, 1 / 3, 1 / 3], 0.33324),
            ([1 / 3, 1 / 3, 1 / 3], 0.66672),
            ([0.17404, 0.63865, 0.18731], 0.17432),
            ([0.17404, 0.63865, 0.18731], 0.81263),
            ([0.1956, 0.00421, 0.00427, 0.79592], 0.20398),
            ([0.16035, 0.58837, 0.25128], 0.99999),
        ),
    ),
    softmax=Exercise(
        softmax,
        library=probabilities,
        returns="p",
        tape=tapes.rows(
            "x[] temperature",
            ([1.0, 2.5, 0.5], 2.0),
            ([1.0, 2.5, 0.5], 0.5),
            ([3.0, 2.0, 0.0, -1.5], 1.0),
            ([0.0, 0.0, 0.0, 0.0], 1.0),
            ([-30.0, 40.0, 10.0], 25.0),
            ([1000.0, 999.0, 0.0], 1.0),
            ([-999.0, -1000.0], 1.0),
            ([60.0, 59.9], 0.05),
            ([3000.0, 0.0, 0.0], 1.0),
            ([2.0, 20000.0, 19999.5, 0.0], 1.0),
            ([7.0, 8.0, 6.5, 9.0, 3.0], 3.0),
            ([-5.0, 3.0], 0.001),
            ([0.12345, 1.30679, -0.98765], 0.54321),
        ),
    ),
    normalise=Exercise(
        normalise,
        returns="x",
        tape=tapes.rows(
            "q_s[] r_max gamma",
            ([5.0, 2.5, -1.0], 1.0, 0.9),
            ([30.0, 10.0, 0.0, -7.123], 10.0, 0.5),
            ([3.0, 7.0], 5.0, 0.99),
            ([8.0, -2.0], 10.0, 0.0),
            ([60.0, 40.0, 1.0], 10.0, 0.9),
            ([-0.31, -0.12, -1.7, -0.4], 0.3, 0.7),
            ([0.0, 0.0, 0.0], 2.0, 0.8),
            ([1.23456, -0.76543], 3.45678, 0.87654),
        ),
    ),
)
