"""Right answers and tapes of lesson 18; the pages of this folder have the tasks, hints and mistakes."""

import math

from rlrobot_course.exercises.parts import Exercise, Question, with_pages
from rlrobot_course.worlds.tapes import rows


def wheels(v, omega, radius, separation):
    aside = omega * separation / 2
    left = (v - aside) / radius
    right = (v + aside) / radius
    return left, right


GIRAFF, PIONEER = (0.075, 0.46), (0.0975, 0.331)


def nearest_ahead(ranges, angle_min, increment):
    met, nearest = False, math.inf
    for i, r in enumerate(ranges):
        angle = angle_min + i * increment
        if 0 < r < math.inf:
            met = True
            if math.cos(angle) >= 0.5:
                nearest = min(nearest, r)
    return nearest if met else math.nan


INF, NAN = math.inf, math.nan
EIGHTH, TENTH = math.pi / 4, math.pi / 5


def allowed(v, omega, ahead, age):
    if age > 0.5 or math.isnan(age) or math.isnan(ahead):
        return 0.0, 0.0
    if v > 0 and ahead < 0.18:
        return 0.0, omega
    return v, omega


check = with_pages(
    globals(),
    who_stops=Question((3, 4, 1, 2, 4)),
    wheels=Exercise(
        wheels,
        returns="wheels",
        tape=rows(
            "v omega radius separation",
            (0.15, 0.5, *GIRAFF),
            (0.2, 0.0, *PIONEER),
            (0.0, 0.6, *PIONEER),
            (0.1, -0.4, 0.1, 0.5),
            (0.0, 0.0, *GIRAFF),
            (-0.05, 0.3, *GIRAFF),
            (0.3, 1.0, 0.2, 0.7),
            (0.12345, 0.45678, 0.09754, 0.33147),
        ),
    ),
    nearest_ahead=Exercise(
        nearest_ahead,
        returns="nearest",
        tape=rows(
            "ranges angle_min increment",
            (
                [2.0, 1.5, 0.4, 0.9, 0.3, 0.7, 0.5, 1.1],
                0.0,
                EIGHTH,
            ),  # the last ray but one step looks ahead, too
            (
                [0.9, 1.2, 0.8, 2.0, 0.6],
                -math.pi / 2,
                EIGHTH,
            ),  # half a circle, from the right to the left
            ([INF, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
            ([0.0, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
            ([NAN, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
            (
                [INF, INF, 0.5, 0.6, 0.7, 0.4, 0.8, INF],
                0.0,
                EIGHTH,
            ),  # free ahead: infinity
            ([0.0] * 8, 0.0, EIGHTH),  # covered, or broken
            ([NAN] * 4, -0.5, 0.3),
            ([INF] * 6, -1.5, 0.6),
            ([3.0, 2.5, 2.0, 0.35, 1.8, 1.6, 0.45, 2.9, 3.1, 0.6], -math.pi, TENTH),
            (
                [1.5, 0.55, 1.2, 0.75, 1.3],
                -1.2,
                0.6,
            ),  # rays at 69, 34, 0, 34 and 69 degrees
            ([2.4, 0.9, 1.0, 0.2, 0.1, 0.6, 0.3, 1.7], 0.0, EIGHTH),
            ([0.8, 0.7, 0.9, 1.2], 1.03, 0.0035),  # rays at 59.0 to 59.6 degrees
            ([0.8, 0.7, 0.9, 1.2, INF], 1.05, 0.004),  # from 60.2 degrees on
            ([0.9, 1.2, 1.8, 2.0, 0.6], -0.6, 0.3),  # the last one is the nearest
            ([0.4, 2.0, 0.4, 2.0], -math.pi, math.pi / 2),  # as near behind as ahead
            ([0.51234, 0.6], 0.0, 0.1),  # a range with many digits
            ([0.7, 0.9], 1.04714, 0.1),  # the first ray is ahead, by a hair
            ([0.7, 0.9], 1.0474, 0.1),  # and here it is not
            ([0.7, 0.9], -1.04714, 0.2),  # the same to the right
            ([0.7, 0.9], -1.0474, 0.2),
            ([2.0, 1.9, 1.8, 1.7, 1.6, 1.5, 0.7], -0.5, 0.25786),  # the last one is
        ),
    ),
    allowed=Exercise(
        allowed,
        returns="allowed",
        tape=rows(
            "v omega ahead age",
            (0.2, 0.0, 1.5, 0.1),
            (0.2, 0.3, 0.1, 0.1),
            (0.0, 0.6, 0.05, 0.1),
            (-0.1, 0.2, 0.1, 0.1),
            (0.2, 0.3, 1.5, 0.7),
            (-0.1, 0.4, 0.1, 2.0),
            (0.2, 0.3, math.nan, 0.1),
            (0.0, 0.5, math.nan, 0.1),
            (0.2, -0.4, math.inf, 0.1),
            (0.2, 0.1, 0.18, 0.4),
            (0.2, -0.1, 0.6, 0.5),
            (0.2, 0.3, math.inf, math.inf),
            (0.1, 0.0, 0.17, 0.0),
            (-0.1, 0.3, math.nan, 0.2),
            (0.2, 0.3, 0.4, 0.3),
            (0.0, 0.4, 1.0, 0.6),
            (0.2, 0.3, 0.1, 0.9),
            (0.1, -0.2, 0.05, math.inf),
            (0.2, 0.2, 1.5, 0.51),
            (0.2, 0.2, 0.175, 0.1),
            (0.2, 0.2, 0.185, 0.1),
            (0.2, 0.3, 0.0, 0.1),  # it touches something
            (0.1, 0.3, -0.02, 0.1),  # and is pressed against it
            (0.2, 0.3, 1.5, math.nan),
            (0.0, 0.3, 0.1, math.nan),
            (0.12345, 0.34567, 1.5, 0.1),
            (0.2, 0.2, 0.25, 0.1),
            (0.2, 0.2, 0.1796, 0.1),  # a hair below the limit
            (0.2, 0.2, 1.5, 0.5004),  # a hair too old
        ),
    ),
)
