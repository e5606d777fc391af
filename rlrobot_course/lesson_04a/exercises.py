"""Right answers and tapes of lesson 04a; what is asked, hints and mistakes stand on the pages beside."""

import math

import numpy as np

from rlrobot_course.grading.parts import Exercise, with_pages
from rlrobot_course.tapes import rows


def temperature_for(gap, odds):
    return gap / np.log(odds)


def normalise(q_s, r_max, gamma):
    q_max = r_max / (1 - gamma)
    return q_s * 100 / q_max


check = with_pages(
    globals(),
    temperature_for=Exercise(
        temperature_for,
        returns="T",
        tape=rows(
            "gap odds",
            (2.0, 9.0),
            (10.0, 100.0),
            (0.5, 20.0),
            (1.0, math.e),
            (30.0, 1.5),
            (4.0, 2.0),
            (0.3, 1.01),
        ),
    ),
    normalise=Exercise(
        normalise,
        returns="x",
        tape=rows(
            "q_s[] r_max gamma",
            ([5.0, 2.5, -1.0], 1.0, 0.9),
            ([30.0, 10.0, 0.0, -7.123], 10.0, 0.5),
            ([3.0, 7.0], 5.0, 0.99),
            ([8.0, -2.0], 10.0, 0.0),
            ([60.0, 40.0, 1.0], 10.0, 0.9),
            ([-0.31, -0.12, -1.7, -0.4], 0.3, 0.7),
            ([0.0, 0.0, 0.0], 2.0, 0.8),
        ),
    ),
)
