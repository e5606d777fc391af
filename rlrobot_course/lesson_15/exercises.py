"""Right answers and tapes of lesson 15; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import rows

AGENTS_NEEDED = Formula(
    "2 * (SD / error) ** 2", SD=3, difference=0.5, error="difference / 3"
)


def f_ratio(groups):
    everyone = np.concatenate(groups)
    between = sum(len(g) * (np.mean(g) - everyone.mean()) ** 2 for g in groups)
    within = sum(np.sum((g - np.mean(g)) ** 2) for g in groups)
    return (between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))


_draw = np.random.default_rng(14)
GROUPS = [
    [np.array([1.0, 2.0, 4.5]), np.array([5.0, 8.0, 5.5])],
    [
        np.array([3.0, 4.0]),
        np.array([4.2, 6.0, 5.0, 7.7, 6.1]),
        np.array([2.5, 3.5, 3.1]),
    ],
    [
        _draw.normal(mean, 1.0, n).round(1)
        for mean, n in ((4, 6), (5, 4), (5.5, 8), (4.4, 5))
    ],
    [np.array([2.0, 3.0, 5.0]), np.array([4.0, 4.5, 1.5])],
    [np.array([1.23456, 2.34567]), np.array([3.14159, 1.41421, 2.71828])],
]
F = "(between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))"


def p_value(observed, shuffled):
    return sum(f >= observed for f in shuffled) / len(shuffled)


check = with_pages(
    globals(),
    agents_needed=Question(AGENTS_NEEDED),
    f_ratio=Exercise(
        f_ratio, returns="F", tape=[{"groups": groups} for groups in GROUPS]
    ),
    p_value=Exercise(
        p_value,
        returns="p",
        tape=rows(
            "observed shuffled[]",
            (3.0, [0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 3.0, 1.5]),
            (26.0, [0.5, 1.5, 2.5, 0.1]),
            (0.5, [0.5, 1.5, 2.5, 0.1, 0.9, 0.3, 0.2]),
            (0.05, [0.7, 1.5, 2.5]),
            (2.0, [2.0, 0.4, 0.1, 0.3, 0.8, 1.2, 0.0, 1.9, 0.6, 0.5, 0.2, 0.9, 1.1]),
            (1.00043, [1.0, 1.00046, 0.9, 0.7, 1.00041, 0.3, 1.5]),
            (2.0, [1.99958, 0.9, 1.1]),
        ),
    ),
)
