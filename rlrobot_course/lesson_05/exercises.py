"""Right answers and tapes of lesson 05; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import (
    Case,
    Exercise,
    Formula,
    Question,
    with_pages,
)
from rlrobot_course.worlds.tapes import SMALL, rows
from rlrobot_edu.widgets.kernels import bias_of

BY_HAND = Formula(
    "(of_X + of_Y + of_theta + of_d) / 4", Q=5, X=10, Y=2, theta_left=14, theta_right=-1, d=-8, of_X="(Q + X) / 2",
    of_Y="(Q + Y) / 2", of_theta="(Q + theta_left + theta_right) / 3", of_d="(Q + d) / 2",
)  # fmt: skip


def siblings(shape, s, i):
    bins = list(np.unravel_index(s, shape))
    numbers = []
    for k in range(shape[i]):
        bins[i] = k
        numbers.append(int(np.ravel_multi_index(bins, shape)))
    return numbers


def another_set(rng: np.random.Generator, case: Case) -> Case:
    """A case with as many inputs, of which each has more bins."""
    shape = tuple(n + int(rng.integers(1, 3)) for n in case["shape"])
    return {"shape": shape, "s": int(rng.integers(np.prod(shape))), "i": case["i"]}


def bias(q, shape, s):
    total = np.zeros(q.shape[1])
    for i in range(len(shape)):
        total += q[siblings(shape, s, i)].mean(axis=0)
    return total / len(shape)


BIAS_DRAWN = np.random.default_rng(7).normal(2.0, 6.0, size=(30, 5)).round(1)
BIAS_DRAWN[[9, 15, 17]] = 0.0  # never visited
BIAS_DRAWN[[3, 4, 8], [1, 0, 2]] = 0.0
BIAS_FINE = np.random.default_rng(8).normal(2.0, 6.0, size=(24, 3))  # with many digits
SHAPE = (2, 2, 3, 2)  # bins of the inputs of worked_example
best_adviser = "floor"

check = with_pages(
    globals(),
    bias_by_hand=Question(BY_HAND),
    best_adviser=Question(best_adviser),
    siblings=Exercise(
        siblings,
        returns="siblings",
        tape=rows(
            "shape s i",
            (SHAPE, 21, 2),
            (SHAPE, 21, 0),
            (SHAPE, 4, 3),
            (SHAPE, 13, 1),
            ((2, 5, 3), 17, 1),
            ((4, 3), 7, 0),
            ((4, 3), 7, 1),
            ((5,), 2, 0),
            (SHAPE, 0, 3),
            (SHAPE, 23, 0),
        ),
        another=another_set,
    ),
    bias=Exercise(
        bias,
        library=bias_of,
        returns="bias",
        tape=[{"q": SMALL, "shape": (2, 3), "s": 4}]
        + [
            {"q": BIAS_DRAWN[: np.prod(shape), :n_actions], "shape": shape, "s": s}
            for shape, s, n_actions in (
                (SHAPE, 21, 3),
                (SHAPE, 4, 3),
                ((4, 6), 9, 4),
                ((3, 2, 4), 16, 2),
                ((24,), 5, 5),
                ((5, 3, 2), 11, 3),
            )
        ]
        + [{"q": BIAS_FINE, "shape": SHAPE, "s": s} for s in (14, 0, 23)],
    ),
)
