"""Where the gripper is."""

from __future__ import annotations

import math

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def gripper(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):
    out = upper * math.sin(biceps) + lower * math.cos(biceps + forearm)
    up = shoulder + upper * math.cos(biceps) - lower * math.sin(biceps + forearm)
    return out * math.cos(arm), out * math.sin(arm), up


ANGLES = [(-0.42, 0.9, 0.26), (0.3, 0.5, 0.6), (0.7, 1.0, 0.0), (-0.7, 0.4, 0.1), (0.0, 0.7, 0.4), (0.14, 0.9, 0.39)]

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return x, y and z of the gripper",
    right=gripper,
    returns="gripper",
    tape=[{"arm": a, "biceps": b, "forearm": f} for a, b, f in ANGLES],
    mistakes={
        "arm_swapped": Mistake(
            "sine and cosine of arm have changed places: at arm = 0 the gripper is straight ahead, y = 0.",
            {"out * math.cos(arm), out * math.sin(arm)": "out * math.sin(arm), out * math.cos(arm)"},
        ),
        "right_for_left": Mistake(
            "the arm turns to the left, and y grows to the left: y = out · sin(arm), without a minus.",
            {"out * math.sin(arm)": "-out * math.sin(arm)"},
        ),
        "forearm_alone": Mistake(
            "the lower arm's angle is biceps + forearm: the elbow is carried by the upper arm, which leans.",
            {"biceps + forearm": "forearm"},
        ),
        "difference_of_angles": Mistake(
            "the angles are added: both a leaning biceps and a bent forearm point the lower arm further down.",
            {"biceps + forearm": "biceps - forearm"},
        ),
        "lower_arm_up": Mistake(
            "the lower arm falls below the elbow: its part of the height is taken away, not added.",
            {"- lower * math.sin": "+ lower * math.sin"},
        ),
        "no_shoulder": Mistake(
            "the height begins at the shoulder, 0.12 m above the table.", {"shoulder + upper": "upper"}
        ),
        "upper_arm_swapped": Mistake(
            "sine and cosine of the upper arm have changed places: upright (biceps = 0) it reaches out by nothing.",
            {
                "upper * math.sin(biceps)": "upper * math.cos(biceps)",
                "upper * math.cos(biceps)": "upper * math.sin(biceps)",
            },
        ),
        "lower_arm_swapped": Mistake(
            "sine and cosine of the lower arm have changed places: level (biceps + forearm = 0) it reaches out by "
            "its whole length.",
            {
                "lower * math.cos(biceps + forearm)": "lower * math.sin(biceps + forearm)",
                "lower * math.sin(biceps + forearm)": "lower * math.cos(biceps + forearm)",
            },
        ),
        "arms_swapped": Mistake(
            "upper and lower arm have changed places.", {"upper *": "lower *", "lower *": "upper *"}
        ),
        "upper_arm_lies": Mistake(
            "an upright upper arm (biceps = 0) reaches out by nothing, not by its whole length: upper · sin(biceps).",
            {"upper * math.sin(biceps)": "upper"},
        ),
        "upper_arm_stands": Mistake(
            "a leaning upper arm is less high than it is long: its height is upper · cos(biceps).",
            {"upper * math.cos(biceps)": "upper"},
        ),
        "upper_arm_out_alone": Mistake(
            "only the upper arm is in out: add the lower arm's part.", {" + lower * math.cos(biceps + forearm)": ""}
        ),
        "upper_arm_up_alone": Mistake(
            "only the upper arm is in the height: take the lower arm's part away.",
            {" - lower * math.sin(biceps + forearm)": ""},
        ),
        "not_turned": Mistake(
            "this is seen from the side: out and up. Turned by arm, out becomes x and y.",
            {"out * math.cos(arm), out * math.sin(arm), up": "out, 0.0, up"},
        ),
        "no_height": Mistake("the height is missing: return x, y and z.", {"math.sin(arm), up": "math.sin(arm)"}),
        "degrees": Mistake(
            "sin and cos take radians, and these angles are in radians already.",
            {
                "math.sin(biceps)": "math.sin(math.radians(biceps))",
                "math.cos(biceps)": "math.cos(math.radians(biceps))",
                "biceps + forearm": "math.radians(biceps + forearm)",
                "(arm)": "(math.radians(arm))",
            },
        ),
        "height_turned": Mistake(
            "only out is turned by arm; the height stays as it is.", {"(arm), up": "(arm), up * math.cos(arm)"}
        ),
    },
    hints=(
        "First from the side: how far out is the gripper, and how high? Then turn what is out by the angle arm.",
        "out and up stand above as formulas. Then x is out · cos(arm) and y is out · sin(arm).",
        "out = upper * np.sin(biceps) + lower * np.cos(…); up = shoulder + …; return out * np.cos(arm), …, up",
    ),
    gained="With these three lines you can move an arm without any simulator: the next cells do.",
    witnesses=WITNESSES,
)
