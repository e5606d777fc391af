"""Right answers and tapes of lesson 07b; what is asked, hints and mistakes stand on the pages beside."""

from rlrobot_course.grading.parts import Exercise, with_pages
from rlrobot_course.tapes import rows


def n_step_return(r, v, n, gamma):
    g = gamma**n * v[n]
    for k in range(n):
        g += gamma**k * r[k]
    return g


check = with_pages(
    globals(),
    n_step_return=Exercise(
        n_step_return,
        returns="return",
        tape=rows(
            "r[] v[] n gamma",
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 2, 0.9),
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 1, 0.8),
            ((0.5, -2.0, 0.25, 10.0), (1.0, 2.5, 0.75, 4.0, 0.0), 4, 0.7),
            ((-1.0, -1.0, -1.0, -1.0, -1.0), (-3.1, -6.2, 1.7, -0.4, -2.9, 0.0), 3, 0.95),
            ((0.0, 0.0, 3.0), (0.6, -0.7, 0.2, 1.9), 2, 0.5),
        ),
    ),
)
