"""Right answers and tapes of lesson 07a; what is asked, hints and mistakes stand on the pages beside."""

import math

from rlrobot_course.grading.parts import Exercise, with_pages
from rlrobot_course.tapes import rows
from rlrobot_edu.learning.memory import trace_steps


def n_traces(gamma, lam, threshold):
    return math.floor(math.log(threshold) / math.log(gamma * lam))


def lam_for(gamma, steps, threshold):
    decay = threshold ** (1 / steps)
    return min(1.0, decay / gamma)


check = with_pages(
    globals(),
    n_traces=Exercise(
        n_traces,
        library=trace_steps,
        returns="n",
        tape=rows(
            "gamma lam threshold",
            (0.9, 0.9, 0.01),
            (0.9, 0.5, 0.01),
            (0.99, 0.95, 0.002),
            (0.95, 0.9, 0.1),
            (0.5, 0.6, 0.05),
            (0.6, 0.5, 0.4),
            (0.85, 0.97, 0.6),
            (0.2, 0.5, 0.9),
        ),
    ),
    lam_for=Exercise(
        lam_for,
        returns="lam",
        tape=rows(
            "gamma steps threshold",
            (0.9, 10, 0.01),
            (0.95, 84, 0.02),
            (0.9, 210, 0.01),
            (0.99, 210, 0.05),
            (0.8, 5, 0.1),
            (0.99, 1000, 0.01),
            (0.95, 2, 0.1),
        ),
    ),
)
