"""Right answers and tapes of lesson 01; the pages of this folder have the tasks, hints and mistakes."""

from math import hypot

import numpy as np

from rlrobot_course.exercises.parts import Case, Design, Exercise, with_pages
from rlrobot_course.lesson_01.design import PAIRS, words
from rlrobot_course.worlds.tapes import rows


def bin_of(x, cuts):
    number = 0
    for cut in cuts:
        if x > cut:
            number += 1
    return number


LASER = [0.27, 0.53, 0.80]  # cut points [m]
ANGLE = [-45, 0, 45, 90]  # cut points [deg]


def state_number(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        s = s * n + b
    return s


ROBOT = [2, 2, 3, 2]  # bins of the inputs of worked_example


def another_state(rng: np.random.Generator, case: Case) -> Case:
    """A state of a robot with as many inputs, of which each has more bins."""
    shape = [n + int(rng.integers(1, 3)) for n in case["shape"]]
    return {"bins": rng.integers(shape).tolist(), "shape": shape}


def reward(before, after):
    left, right = after["laser_front_left"], after["laser_front_right"]
    dx, dy = after["x"] - before["x"], after["y"] - before["y"]
    if min(left, right) < 0.10:
        return -2
    return 10 if hypot(dx, dy) > 0.07 else -0.02


check = with_pages(
    globals(),
    bin_of=Exercise(
        bin_of,
        returns="bin",
        tape=[
            {"x": x, "cuts": LASER} for x in (0.53, 0.70, 0.10, 0.30, 2.00, 0.27, 0.80)
        ]
        + [{"x": x, "cuts": [0.20]} for x in (0.20, 0.21)]
        + [{"x": x, "cuts": ANGLE} for x in (-30, -90, 90, 180, 0, 20)]
        + [{"x": x, "cuts": [1.5, 1.6, 4.0, 4.5, 9.0]} for x in (4.2, 1.55, 5, 9.1)]
        # a reading, or a cut point, that is rounded lies in another bin
        + rows("x cuts", (0.4, []), (0.5304, LASER), (0.2702, [0.2704, 0.5296])),
    ),
    state_number=Exercise(
        state_number,
        returns="state",
        tape=[
            {"bins": bins, "shape": ROBOT}
            for bins in ([1, 0, 1, 1], [0, 1, 2, 0], [0, 0, 0, 1], [1, 1, 2, 1])
        ]
        + rows(
            "bins shape",
            ([2, 1], [3, 4]),
            ([1, 3, 0, 2], [2, 5, 3, 4]),
            ([4], [6]),
            ([0, 1, 3, 3, 1], [4, 4, 4, 4, 4]),
            ([2, 6, 11], [3, 7, 12]),
            ([0, 0, 0], [3, 2, 5]),
        ),
        another=another_state,
    ),
    reward=Design(
        reward,
        returns="more is paid when it",
        words=words,
        tape=rows("wanted unwanted", *PAIRS),
    ),
)
