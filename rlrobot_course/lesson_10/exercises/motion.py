"""The motion of a robot with two wheels."""

from __future__ import annotations

import math

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def motion(left, right, radius, separation):
    v = radius * (left + right) / 2
    omega = radius * (right - left) / separation
    return v, math.degrees(omega)


WHEELS = [
    (1.0, 2.0, 0.1, 0.5),
    (2.0, 2.0, 0.0975, 0.331),
    (-1.0, 1.0, 0.0975, 0.331),
    (0.0, 1.0, 0.0975, 0.331),
    (1.0, 0.0, 0.2, 0.4),
    (0.0, 0.0, 0.1, 0.3),
    (-0.5, -0.5, 0.1, 0.3),
    (0.5, -1.0, 0.075, 0.46),
]

V, TURN = "radius * (left + right) / 2", "radius * (right - left) / separation"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the robot's forward speed in m/s and its turning rate in degrees per second",
    right=motion,
    returns="motion",
    tape=[dict(zip(("left", "right", "radius", "separation"), wheels, strict=True)) for wheels in WHEELS],
    mistakes={
        "radians_left": Mistake(
            "the turning rate is in radians per second. The robot's is asked in degrees: math.degrees(…).",
            {"math.degrees(omega)": "omega"},
        ),
        "inverted": Mistake(
            "your robot turns the wrong way: it turns to the left, which counts positive, if the right wheel is "
            "the faster one.",
            {"right - left": "left - right"},
        ),
        "sum_of_speeds": Mistake(
            "the speed is the mean of both wheels' speeds, and yours is their sum: divide by 2.",
            {"(left + right) / 2": "(left + right)"},
        ),
        "half_the_separation": Mistake(
            "the turning rate is the difference of both wheels' speeds over their separation, not over half of "
            "it. (Or is the factor for degrees 360 / π? It is 180 / π.)",
            {"/ separation": "/ (separation / 2)"},
        ),
        "twice_the_separation": Mistake(
            "the turning rate is half of what it should be: divide by the separation, not by twice that.",
            {"/ separation": "/ (2 * separation)"},
        ),
        "no_radius_in_v": Mistake(
            "the speed is in rad/s: a wheel of radius r rolls r metres for each radian. Multiply by the radius.",
            {V: "(left + right) / 2"},
        ),
        "no_radius_in_omega": Mistake(
            "the turning rate lacks the radius: radius · right and radius · left are the speeds of the wheels in m/s.",
            {TURN: "(right - left) / separation"},
        ),
        "no_radius": Mistake(
            "both numbers lack the radius: a wheel at 1 rad/s rolls one radius a second.",
            {V: "(left + right) / 2", TURN: "(right - left) / separation"},
        ),
        "no_separation": Mistake(
            "the turning rate is not divided by the separation of the wheels.", {" / separation": ""}
        ),
        "times_separation": Mistake(
            "the wheels' difference is multiplied by their separation: divide by it. The further apart the wheels "
            "are, the less the robot turns.",
            {"/ separation": "* separation"},
        ),
        "degrees_to_radians": Mistake(
            "degrees to radians is the wrong way round: math.degrees turns radians into degrees.",
            {"math.degrees": "math.radians"},
        ),
        "swapped": Mistake(
            "the two numbers have changed places: first the speed, then the turning rate.",
            {"v, math.degrees(omega)": "math.degrees(omega), v"},
        ),
        "sum_for_omega": Mistake(
            "the turning rate comes from the difference of the wheels' speeds, right less left.",
            {"right - left": "right + left"},
        ),
        "difference_for_v": Mistake(
            "the speed comes from the sum of the wheels' speeds, and yours from their difference.",
            {"left + right": "right - left"},
        ),
        "pi_3_14": Mistake(
            "π is not 3.14: math.degrees(…) knows it better.", {"math.degrees(omega)": "omega * 180 / 3.14"}
        ),
        "v_alone": Mistake(
            "this is the speed alone. Return both numbers: return v, omega.", {"v, math.degrees(omega)": "v"}
        ),
        "omega_alone": Mistake(
            "this is the turning rate alone. Return both numbers: return v, omega.",
            {"v, math.degrees(omega)": "math.degrees(omega)"},
        ),
        "own_robot": Mistake(
            "the radius and the separation are arguments; yours holds for one robot only.",
            {"radius": "0.0975", "separation": "0.331"},
        ),
    },
    hints=(
        "Each wheel rolls radius · its speed metres a second. The robot's middle moves at the mean of both; their "
        "difference turns it.",
        "v = radius * (left + right) / 2, and the turning rate is radius * (right - left) / separation in rad/s.",
        "return radius * (left + right) / 2, math.degrees(…)",
    ),
    gained="With this you can read any command of a robot on two wheels. It draws the arrows of all that follows.",
    witnesses=WITNESSES,
)
