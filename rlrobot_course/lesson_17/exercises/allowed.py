"""The last word before the wheels: stop, or go on."""

from __future__ import annotations

import math

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def allowed(v, omega, ahead, age):
    if age > 0.5 or math.isnan(ahead):
        return 0.0, 0.0
    if v > 0 and ahead < 0.18:
        return 0.0, omega
    return v, omega


CASES = (
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
)

UNKNOWN, NEAR = "age > 0.5 or math.isnan(ahead)", "v > 0 and ahead < 0.18"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return what is left of v and omega when the three rules have been applied",
    right=allowed,
    returns="allowed",
    tape=[dict(zip(("v", "omega", "ahead", "age"), case, strict=True)) for case in CASES],
    mistakes={
        "nan_gets_through": Mistake(
            "NaN gets through: every comparison with it is false, ahead < 0.18 and ahead == math.nan as well. So "
            "your robot drives on although it sees nothing. Ask math.isnan(ahead) first.",
            {" or math.isnan(ahead)": ""},
        ),
        "near_before_old": Mistake(
            "old readings, and something was near in them. The order of the rules decides: ask first what is old "
            "or not known, and stop whole. Your robot would go on turning blindly.",
            {UNKNOWN: f"({UNKNOWN}) and not ({NEAR})"},
        ),
        "no_age": Mistake(
            "the rule for old readings is missing: above half a second, nothing is known of the room any more.",
            {"age > 0.5 or ": ""},
        ),
        "age_inverted": Mistake(
            "the rule for old readings is the wrong way round: a large age is bad.", {"age > 0.5": "age < 0.5"}
        ),
        "turns_blind": Mistake(
            "who knows nothing must not turn, either: both numbers are 0 then.", {"0.0, 0.0": "0.0, omega"}
        ),
        "never_turns": Mistake(
            "a robot that may not even turn beside a wall never gets away from it: only v becomes 0.",
            {"0.0, omega": "0.0, 0.0"},
        ),
        "holds_back_backward": Mistake(
            "driving backward leads away from what is ahead: only forward motion, v > 0, is held back.",
            {"v > 0 and ": ""},
        ),
        "no_distance": Mistake("the rule for things that are near is missing.", {NEAR: "False"}),
        "distance_inverted": Mistake(
            "the rule for things that are near is the wrong way round: a small distance is bad.",
            {"ahead < 0.18": "ahead > 0.18"},
        ),
        "both_limits": Mistake(
            "0.18 m are still enough, and 0.5 s still new: < and >, without =.",
            {"ahead < 0.18": "ahead <= 0.18", "age > 0.5": "age >= 0.5"},
        ),
        "limit_of_0_18": Mistake(
            "0.18 m are still enough: ahead < 0.18, without =.", {"ahead < 0.18": "ahead <= 0.18"}
        ),
        "limit_of_0_5": Mistake("0.5 s are not yet too old: age > 0.5, without =.", {"age > 0.5": "age >= 0.5"}),
        "infinity_stops": Mistake(
            "infinity means that nothing is ahead: then the robot may drive. Only NaN means that it is not known.",
            {"math.isnan(ahead)": "not math.isfinite(ahead)"},
        ),
        "backs_off": Mistake(
            "near a wall your robot backs off. It should only not go on: v becomes 0.", {"0.0, omega": "-v, omega"}
        ),
        "slows_down": Mistake(
            "near a wall your robot is slower, but drives on. It must not: v becomes 0.", {"0.0, omega": "v / 2, omega"}
        ),
        "and_for_or": Mistake("both must hold for your robot to stop: one is enough. Write or.", {"0.5 or": "0.5 and"}),
        "v_alone": Mistake(
            "this is only v. Return both numbers: return v, omega.",
            {"return 0.0, 0.0": "return 0.0", "return 0.0, omega": "return 0.0", "return v, omega": "return v"},
        ),
        "never_moves": Mistake(
            "safe, but it never moves at all.", {"return 0.0, omega": "return 0.0, 0.0", "v, omega": "0.0, 0.0"}
        ),
    },
    hints=(
        "First ask whether anything is known at all: too old, or NaN. Then whether something is near ahead.",
        "if age > 0.5 or math.isnan(ahead): both are 0. If v > 0 and ahead < 0.18: only v is 0.",
        "Two ifs, each with a return of its own, and at the end: return v, omega",
    ),
    gained="Ten times a second, the link asks the same of every command before it is sent.",
    witnesses=WITNESSES,
)
