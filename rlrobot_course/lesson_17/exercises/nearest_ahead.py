"""The nearest thing ahead in a laser scan."""

from __future__ import annotations

import math

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


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

CASES = (
    ([2.0, 1.5, 0.4, 0.9, 0.3, 0.7, 0.5, 1.1], 0.0, EIGHTH),  # the last ray but one step looks ahead, too
    ([0.9, 1.2, 0.8, 2.0, 0.6], -math.pi / 2, EIGHTH),  # half a circle, from the right to the left
    ([INF, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
    ([0.0, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
    ([NAN, 1.4, 0.5, 0.6, 0.7, 0.4, 0.8, 2.2], 0.0, EIGHTH),
    ([INF, INF, 0.5, 0.6, 0.7, 0.4, 0.8, INF], 0.0, EIGHTH),  # free ahead: infinity
    ([0.0] * 8, 0.0, EIGHTH),  # covered, or broken
    ([NAN] * 4, -0.5, 0.3),
    ([INF] * 6, -1.5, 0.6),
    ([3.0, 2.5, 2.0, 0.35, 1.8, 1.6, 0.45, 2.9, 3.1, 0.6], -math.pi, TENTH),
    ([1.5, 0.55, 1.2, 0.75, 1.3], -1.2, 0.6),  # rays at 69, 34, 0, 34 and 69 degrees
    ([2.4, 0.9, 1.0, 0.2, 0.1, 0.6, 0.3, 1.7], 0.0, EIGHTH),
    ([0.8, 0.7, 0.9, 1.2], 1.03, 0.0035),  # rays at 59.0 to 59.6 degrees
    ([0.8, 0.7, 0.9, 1.2, INF], 1.05, 0.004),  # from 60.2 degrees on
    ([0.4, 2.0, 0.4, 2.0], -math.pi, math.pi / 2),  # as near behind as ahead
)

IS_AHEAD = "math.cos(angle) >= 0.5"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the smallest range among the rays that look ahead and met something; infinity if none did, and NaN "
    "if no ray of the whole scan met anything",
    right=nearest_ahead,
    returns="nearest",
    tape=[dict(zip(("ranges", "angle_min", "increment"), case, strict=True)) for case in CASES],
    mistakes={
        "zero_counts": Mistake(
            "a range of 0 counts as a wall in yours. Many drivers write 0 where a ray met nothing: leave it out.",
            {"0 < r": "0 <= r"},
        ),
        "nan_gets_through": Mistake(
            "NaN gets through. Every comparison with it is false, r <= 0 as well: ask 0 < r < math.inf, which is "
            "false, too, and then leaves it out.",
            {
                "0 < r < math.inf": "not (r <= 0 or r == math.inf)",
                "min(nearest, r)": "r if math.isnan(r) else min(nearest, r)",
            },
        ),
        "all_directions": Mistake(
            "all directions count as ahead in yours. Ahead is what lies within 60 degrees; angles are in radians, "
            "and 60 degrees are only 1.05 of them.",
            {IS_AHEAD: "True"},
        ),
        "only_left_half": Mistake(
            "a ray at 315 degrees looks ahead, too: it is 45 degrees to the right. Angles go round; their cosine "
            "knows that, math.cos(angle) >= 0.5.",
            {IS_AHEAD: "abs(angle) <= math.pi / 3"},
        ),
        "ninety_degrees": Mistake(
            "this is 90 degrees to each side. Ahead is what lies within 60 degrees, where the cosine is at least 0.5.",
            {IS_AHEAD: "math.cos(angle) > 1e-9"},
        ),
        "thirty_degrees": Mistake(
            "this is 30 degrees to each side; it should be 60.", {IS_AHEAD: "math.cos(angle) >= math.cos(math.pi / 6)"}
        ),
        "to_the_left": Mistake(
            "this looks to the left: ahead is where the cosine is large, not the sine.",
            {IS_AHEAD: "math.sin(angle) >= 0.5"},
        ),
        "behind": Mistake(
            "this looks behind: ahead is where the cosine is at least 0.5.", {IS_AHEAD: "math.cos(angle) <= -0.5"}
        ),
        "from_angle_0": Mistake(
            "the first ray does not look ahead, but at angle_min: angle_min + i · increment.", {"angle_min + i": "i"}
        ),
        "radian_apart": Mistake(
            "the rays are `increment` apart, not one radian: angle_min + i · increment.", {"i * increment": "i"}
        ),
        "cosine_of_degrees": Mistake(
            "math.cos takes radians, and the angles are in radians already: leave out math.degrees.",
            {IS_AHEAD: "math.cos(math.degrees(angle)) >= 0.5"},
        ),
        "not_ahead": Mistake(
            "this looks at all that is not ahead. Ahead the cosine is at least 0.5, and the angle at most 60 degrees.",
            {IS_AHEAD: "math.cos(angle) < 0.5"},
        ),
        "counted_up_too_soon": Mistake(
            "the first ray looks at angle_min itself: count the angle up after it was used.", {"+ i *": "+ (i + 1) *"}
        ),
        "zero_where_free": Mistake(
            "nothing ahead is not 0 m: the robot would stop for ever. Where ahead is free, return math.inf.",
            {"return nearest if met": "return (nearest if nearest < math.inf else 0.0) if met"},
        ),
        "first_with_this_range": Mistake(
            "index(r) finds the first ray with this range, and another may have the same: a wall behind hides the one "
            "ahead. Use enumerate(ranges).",
            {"angle_min + i * increment": "angle_min + ranges.index(r) * increment"},
        ),
        "empty_scan_is_free": Mistake(
            "a scan in which no ray met anything says nothing: a covered scanner looks the same. Return math.nan "
            "then, not infinity.",
            {" if met else math.nan": ""},
        ),
        "blocked_where_free": Mistake(
            "nothing ahead, but something elsewhere: so the scanner works, and ahead is free. That is infinity, "
            "not NaN.",
            {"if met else": "if nearest < math.inf else"},
        ),
        "infinity_as_proof": Mistake(
            "a ray that is infinite met nothing, and is no proof that the scanner works.", {"0 < r < math.inf": "0 < r"}
        ),
        "zero_where_unknown": Mistake(
            "0 is what a covered scanner says. Where nothing is known, return math.nan.", {"else math.nan": "else 0.0"}
        ),
        "furthest": Mistake(
            "this is how far the furthest thing ahead is. The nearest is dangerous.",
            {"False, math.inf": "False, -math.inf", "min(nearest, r)": "max(nearest, r)"},
        ),
        "return_in_the_loop": Mistake(
            "the first ray ahead decides alone. Does return stand inside a loop, and end it?",
            {"nearest = min(nearest, r)": "return r"},
        ),
    },
    hints=(
        "Three kinds of rays: those that met nothing (leave them out), those that met something elsewhere, and those "
        "that met something ahead. Remember whether there was any of the last two.",
        "Ray i looks at angle_min + i * increment. It met something if 0 < r < math.inf, and looks ahead if "
        "math.cos(angle) >= 0.5.",
        "met, nearest = False, math.inf; in the loop met = True and nearest = min(nearest, r), each under its if; at "
        "the end: return nearest if met else …",
    ),
    gained="Not to know is not the same as to know that nothing is there. Your robot can tell them apart now.",
    witnesses=WITNESSES,
)
