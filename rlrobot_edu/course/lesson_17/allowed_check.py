"""The exercise of lesson 17 on safety: what is left of a command when the way is not free, or nothing is known."""

from __future__ import annotations

import math

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.lesson_17 import solutions

CASES = (
    (0.2, 0.0, 1.5, 0.1), (0.2, 0.3, 0.1, 0.1), (0.0, 0.6, 0.05, 0.1), (-0.1, 0.2, 0.1, 0.1), (0.2, 0.3, 1.5, 0.7),
    (-0.1, 0.4, 0.1, 2.0), (0.2, 0.3, math.nan, 0.1), (0.0, 0.5, math.nan, 0.1), (0.2, -0.4, math.inf, 0.1),
    (0.2, 0.1, 0.18, 0.4), (0.2, -0.1, 0.6, 0.5), (0.2, 0.3, math.inf, math.inf), (0.1, 0.0, 0.17, 0.0),
    (-0.1, 0.3, math.nan, 0.2), (0.2, 0.3, 0.4, 0.3), (0.0, 0.4, 1.0, 0.6),
    (0.2, 0.3, 0.1, 0.9), (0.1, -0.2, 0.05, math.inf),
)  # fmt: skip
UNKNOWN, NEAR = "age > 0.5 or math.isnan(ahead)", "v > 0 and ahead < 0.18"

allowed = Exercise(
    task="return what is left of v and omega when the three rules have been applied",
    right=solutions.allowed,
    returns="allowed",
    tape=[dict(zip(("v", "omega", "ahead", "age"), case, strict=True)) for case in CASES],
    mistakes=[
        Mistake("NaN gets through: every comparison with it is false, ahead < 0.18 and ahead == math.nan as well. So "
                "your robot drives on although it sees nothing. Ask math.isnan(ahead) first.",
                {" or math.isnan(ahead)": ""}),
        Mistake("old readings, and something was near in them. The order of the rules decides: ask first what is old "
                "or not known, and stop whole. Your robot would go on turning blindly.",
                {UNKNOWN: f"({UNKNOWN}) and not ({NEAR})"}),
        Mistake("the rule for old readings is missing: above half a second, nothing is known of the room any more.",
                {"age > 0.5 or ": ""}),
        Mistake("the rule for old readings is the wrong way round: a large age is bad.",
                {"age > 0.5": "age < 0.5"}),
        Mistake("who knows nothing must not turn, either: both numbers are 0 then.",
                {"0.0, 0.0": "0.0, omega"}),
        Mistake("a robot that may not even turn beside a wall never gets away from it: only v becomes 0.",
                {"0.0, omega": "0.0, 0.0"}),
        Mistake("driving backward leads away from what is ahead: only forward motion, v > 0, is held back.",
                {"v > 0 and ": ""}),
        Mistake("the rule for things that are near is missing.", {NEAR: "False"}),
        Mistake("the rule for things that are near is the wrong way round: a small distance is bad.",
                {"ahead < 0.18": "ahead > 0.18"}),
        Mistake("0.18 m are still enough, and 0.5 s still new: < and >, without =.",
                {"ahead < 0.18": "ahead <= 0.18", "age > 0.5": "age >= 0.5"}),
        Mistake("0.18 m are still enough: ahead < 0.18, without =.", {"ahead < 0.18": "ahead <= 0.18"}),
        Mistake("0.5 s are not yet too old: age > 0.5, without =.", {"age > 0.5": "age >= 0.5"}),
        Mistake("infinity means that nothing is ahead: then the robot may drive. Only NaN means that it is not known.",
                {"math.isnan(ahead)": "not math.isfinite(ahead)"}),
        Mistake("near a wall your robot backs off. It should only not go on: v becomes 0.",
                {"0.0, omega": "-v, omega"}),
        Mistake("near a wall your robot is slower, but drives on. It must not: v becomes 0.",
                {"0.0, omega": "v / 2, omega"}),
        Mistake("both must hold for your robot to stop: one is enough. Write or.",
                {"0.5 or": "0.5 and"}),
        Mistake("this is only v. Return both numbers: return v, omega.",
                {"return 0.0, 0.0": "return 0.0", "return 0.0, omega": "return 0.0", "return v, omega": "return v"}),
        Mistake("safe, but it never moves at all.", {"return 0.0, omega": "return 0.0, 0.0", "v, omega": "0.0, 0.0"}),
    ],
    hints=(
        "First ask whether anything is known at all: too old, or NaN. Then whether something is near ahead.",
        "if age > 0.5 or math.isnan(ahead): both are 0. If v > 0 and ahead < 0.18: only v is 0.",
        "Two ifs, each with a return of its own, and at the end: return v, omega",
    ),
    gained="Ten times a second, the link asks the same of every command before it is sent.",
)  # fmt: skip
