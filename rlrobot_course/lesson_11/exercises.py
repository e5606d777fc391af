"""Right answers and tapes of lesson 11; the pages of this folder have the tasks, hints and mistakes."""

import math

from rlrobot_course.exercises.parts import Exercise, Question, with_pages
from rlrobot_course.worlds.tapes import rows


def motion(left, right, radius, separation):
    v = radius * (left + right) / 2
    omega = radius * (right - left) / separation
    return v, math.degrees(omega)


check = with_pages(
    globals(),
    bins=Question((1, 2, 0, 3, 2)),
    motion=Exercise(
        motion,
        returns="motion",
        tape=rows(
            "left right radius separation",
            (1.0, 2.0, 0.1, 0.5),
            (2.0, 2.0, 0.0975, 0.331),
            (-1.0, 1.0, 0.0975, 0.331),
            (0.0, 1.0, 0.0975, 0.331),
            (1.0, 0.0, 0.2, 0.4),
            (0.0, 0.0, 0.1, 0.3),
            (-0.5, -0.5, 0.1, 0.3),
            (0.5, -1.0, 0.075, 0.46),
            (1.23456, -0.76543, 0.09754, 0.33147),
        ),
    ),
)
