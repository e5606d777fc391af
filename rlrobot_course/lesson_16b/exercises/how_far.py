"""How far a robot gets in a second on a circle, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

how_far = (0.0975 * (0.5 + 1) / 2, 0.0975 * (0 + 1) / 2)

exercise = Question(
    task="how far it gets in a second, a tuple of two numbers",
    right=how_far,
    because="0.073 m is more than 0.07 m and is paid, 0.049 m is not. So with three speeds no circle "
    "pays, with five some do.",
    mistakes={
        "sum": Mistake(
            "the middle of the robot moves at the mean of both wheels, not at their sum.", (0.14625, 0.0975)
        ),
        "outer_wheel": Mistake(
            "this is how far the outer wheel gets. The middle gets half of what both get.", (0.0975, 0.0975)
        ),
        "difference": Mistake("the difference of the wheels turns the robot; their mean drives it.", (0.04875, 0.0975)),
        "in_radians": Mistake(
            "this is the mean speed in rad/s. Times the radius of a wheel it becomes m/s.", (0.75, 0.5)
        ),
        "swapped": Mistake("the first number is that of 0.5 and 1 rad/s.", (0.04875, 0.073125)),
        "one_alone": Mistake("this is the first of two numbers.", 0.073125),
    },
    hints=(
        "A wheel that turns with ω rad/s gets 0.0975 · ω metres in a second. And the middle between two wheels?",
        "The middle moves at their mean: 0.0975 · (left + right) / 2.",
        "(0.0975 · 0.75, 0.0975 · 0.5)",
    ),
    gained="Such a sum, done before the first run, would have told what the reward really asks for.",
    witnesses={
        "sum": [(0.0975 * 1.5, 0.0975)],
        "outer_wheel": [(0.0975, 0.0975)],
        "in_radians": [(0.75, 0.5)],
        "swapped": [(0.04875, 0.0731)],
        "one_alone": [0.0731],
    },
)
