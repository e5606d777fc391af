"""The speeds of the wheels for a given motion."""

from __future__ import annotations

import math  # noqa: F401  (a mistake calls it)

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def wheels(v, omega, radius, separation):
    aside = omega * separation / 2
    left = (v - aside) / radius
    right = (v + aside) / radius
    return left, right


GIRAFF, PIONEER = (0.075, 0.46), (0.0975, 0.331)

CASES = (
    (0.15, 0.5, *GIRAFF),
    (0.2, 0.0, *PIONEER),
    (0.0, 0.6, *PIONEER),
    (0.1, -0.4, 0.1, 0.5),
    (0.0, 0.0, *GIRAFF),
    (-0.05, 0.3, *GIRAFF),
    (0.3, 1.0, 0.2, 0.7),
)

ASIDE, LEFT, RIGHT = "omega * separation / 2", "(v - aside) / radius", "(v + aside) / radius"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the speeds of the left and the right wheel in rad/s",
    right=wheels,
    returns="wheels",
    tape=[dict(zip(("v", "omega", "radius", "separation"), case, strict=True)) for case in CASES],
    mistakes={
        "whole_separation": Mistake(
            "each wheel is only half of the separation away from the middle: what is added and taken off is "
            "omega · separation / 2.",
            {ASIDE: "omega * separation"},
        ),
        "inverted": Mistake(
            "your robot turns the wrong way: to the left is positive, and there the right wheel is the faster one.",
            {"v - aside": "v + aside", "v + aside": "v - aside"},
        ),
        "no_radius": Mistake(
            "these are the speeds of the rims in m/s. A wheel of this radius turns at speed / radius rad/s.",
            {" / radius": ""},
        ),
        "times_radius": Mistake(
            "multiplied by the radius, where it must be divided: the larger a wheel, the slower it need turn.",
            {" / radius": " * radius"},
        ),
        "degrees_to_radians": Mistake(
            "omega is in rad/s already, as all angles in ROS: it needs no math.radians.",
            {ASIDE: "math.radians(omega) * separation / 2"},
        ),
        "radians_to_degrees": Mistake(
            "all angles in ROS are in radians, and here they should stay so: leave math.degrees out.",
            {ASIDE: "math.degrees(omega) * separation / 2"},
        ),
        "no_separation": Mistake(
            "omega and v have different units, rad/s and m/s. Times half of the separation, omega is a speed, too.",
            {ASIDE: "omega"},
        ),
        "divides_by_separation": Mistake(
            "omega is multiplied by the distance of a wheel from the middle, not divided: the further out, the "
            "faster it must be.",
            {ASIDE: "omega / (separation / 2)"},
        ),
        "quarter_separation": Mistake(
            "a quarter of the separation is too little: each wheel is half of it away from the middle.",
            {ASIDE: "omega * separation / 4"},
        ),
        "half_v": Mistake(
            "v is halved, but each wheel must go as fast as the robot, and not half as fast.",
            {"v - aside": "v / 2 - aside", "v + aside": "v / 2 + aside"},
        ),
        "brackets": Mistake(
            "the radius divides the whole sum: put it in brackets, (v ± …) / radius.",
            {LEFT: "v - aside / radius", RIGHT: "v + aside / radius"},
        ),
        "no_minus": Mistake(
            "both wheels get the same in yours. One of them needs a minus.", {"v - aside": "v + aside"}
        ),
        "v_alone": Mistake(
            "both wheels get the same in yours: v alone. What has omega to say?", {"v - aside": "v", "v + aside": "v"}
        ),
        "omega_alone": Mistake(
            "v is missing: with omega = 0 both wheels drive the robot straight on.",
            {"v - aside": "-aside", "v + aside": "aside"},
        ),
        "left_inverted": Mistake(
            "the two wheels have changed places, and one of them its sign: left first, and left is the slower one "
            "if the robot turns to the left.",
            {"v - aside": "aside - v"},
        ),
        "own_giraff": Mistake(
            "radius and separation are arguments; yours holds for the Giraff only.",
            {"separation": "0.46", "radius": "0.075"},
        ),
        "own_pioneer": Mistake(
            "radius and separation are arguments; yours holds for the Pioneer only.",
            {"separation": "0.331", "radius": "0.0975"},
        ),
    },
    hints=(
        "The middle of the robot goes at v. A wheel that is d to the right of it goes faster by omega · d.",
        "d is half of the separation: the rims go at v − omega · B / 2 and v + omega · B / 2. Then from m/s to rad/s.",
        "left, right = (v - omega * separation / 2) / radius, (v + …) / radius",
    ),
    gained="This is what stands between a Twist and the motors of every robot on two wheels.",
    witnesses=WITNESSES,
)
