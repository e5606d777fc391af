"""Right answers and tapes of assignment 5; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.assignment_5.parking import PAIRS, words
from rlrobot_course.exercises.parts import Case, Design, Exercise, Question, with_pages
from rlrobot_course.worlds.tapes import rows


def park_reward(before, after):
    front = after["laser_front"]
    near = min(front, after["laser_front_left"], after["laser_front_right"])
    moved = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -2
    if 0.15 < front <= 0.35 and moved < 0.01:
        return 10
    return 1 if front > 0.35 and front < before["laser_front"] - 0.01 else 0


def value_of(rows, policy, n_states, gamma, sweeps):
    v = np.zeros(n_states)
    for _ in range(sweeps):
        old = v.copy()
        for s in range(n_states):
            seen = [
                r + gamma * old[s_next]
                for s_row, a, r, s_next in rows
                if (s_row, a) == (s, policy[s])
            ]
            v[s] = sum(seen) / len(seen) if seen else 0
    return v


ROWS = [
    (0, 0, 1.5, 1),
    (0, 0, 2.5, 0),
    (0, 1, -3.5, 2),
    (1, 1, 4.5, 2),
    (1, 1, 0.5, 1),
    (1, 1, 1.25, 0),
    (1, 0, 9.5, 1),
    (2, 0, -0.5, 0),
    (0, 0, 1.5, 1),
    (2, 1, 7.5, 2),
]


def interval(values, t):
    mean, n = np.mean(values), len(values)
    half = t * np.std(values, ddof=1) / np.sqrt(n)
    return [mean - half, mean + half]


def verdict(first, second, t):
    low, high = interval(np.subtract(first, second), t)
    if low > 0:
        return "first"
    if high < 0:
        return "second"
    return "open"


EARNED = [2.5, 3.25, 1.75, 4.5, 3.0]
LIKE = [
    x - 0.25 + 0.0625 * i for i, x in enumerate(EARNED)
]  # a little less, nearly the same pair by pair


def other_results(rng: np.random.Generator, case: Case) -> Case:
    """A case of `verdict` whose results are all so many times as large, which changes no verdict."""
    size = rng.uniform(0.6, 1.7)
    first, second = (
        [float(size * x) for x in case[name]] for name in ("first", "second")
    )
    return {"first": first, "second": second, "t": case["t"]}


right_interval = interval  # for answers that have an `interval` of their own

check = with_pages(
    globals(),
    park_reward=Design(
        park_reward,
        returns="more is paid when it",
        words=words,
        tape=rows("wanted unwanted", *PAIRS),
    ),
    inputs=Question("ADE"),
    value_of=Exercise(
        value_of,
        returns="v",
        tape=rows(
            "rows policy n_states gamma sweeps",
            (ROWS, [0, 1, 0], 3, 0.9, 1),
            (ROWS, [0, 1, 0], 3, 0.8, 2),
            (ROWS, [1, 0, 1], 3, 0.75, 12),
            (ROWS[:6], [0, 1, 1], 3, 0.9, 3),
            (ROWS, [0, 1, 0], 3, 0.5, 40),
            ([], [0, 0], 2, 0.9, 5),
            (ROWS, [1, 0, 1], 3, 0.75, 1),
            (ROWS, [0, 1, 0], 3, 0.0, 3),
            (ROWS, [0, 1, 0], 3, 0.99, 3),
            ([(0, 0, 1.23456, 1), (1, 0, -0.98765, 0)], [0, 0], 2, 0.87654, 3),
        ),
    ),
    interval=Exercise(
        interval,
        returns="interval",
        tape=rows(
            "values t",
            (EARNED, 2.78),
            ([0.5, -1.5], 12.7),
            ([1.25, 1.25, 1.25], 4.3),
            ([10.5, 0.25, -3.5, 8.75, 2.0, 2.25, 1.5], 2.45),
            ([-0.5, -0.75, -1.0, -0.25], 3.18),
            ([1.23456, -0.98765, 3.14159], 4.30265),
        ),
    ),
    verdict=Exercise(
        verdict,
        returns="verdict",
        tape=rows(
            "first second t",
            (EARNED, LIKE, 2.0),
            (LIKE, EARNED, 2.0),
            (EARNED, EARNED[::-1], 2.78),
            (EARNED, EARNED, 2.78),
            ([5.5, 6.25, 5.75], [1.25, 0.5, 2.5], 4.3),
            ([1.25, 0.5, 2.5], [5.5, 6.25, 5.75], 4.3),
            ([1.0, 3.5, 1.25, 2.5], [1.5, 2.0, 1.5, 1.75], 3.18),
            ([1.5, 2.0, 1.5, 1.75], [1.0, 3.5, 1.25, 2.5], 3.18),
            ([2.5, 2.75, 3.0, 3.5, 4.0, 4.5], [2.625, 2.0, 2.25, 2.75, 3.0, 3.5], 2.57),
            ([2.5, 3.0, 3.5, 3.0], [1.0, 2.75, 1.5, 2.5], 2.0),  # decided by t alone
            ([2.5, 3.0, 3.5, 3.0], [1.0, 2.75, 1.5, 2.5], 3.18),
            # a large mean, and most of the pairs, of which nothing follows
            ([20.0, 1.0, 2.0], [0.0, 2.0, 1.5], 4.3),
            ([2.0, 2.125, 1.875, 1.0], [1.75, 2.0, 1.75, 1.625], 3.18),
            # small differences, and an end of the interval that is nearly 0
            ([2.00013, 3.00021, 1.50017], [2.0, 3.0, 1.5], 2.0),
            ([2.0, 3.0, 1.5], [2.00013, 3.00021, 1.50017], 2.0),
            ([2.0, 4.0, 6.0], [1.0, 2.0, 3.0], 3.4644),
            ([2.0, 4.0, 6.0], [1.0, 2.0, 3.0], 3.4638),
        ),
        another=other_results,
    ),
)
