"""How near a wall may be before a step at double speed."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

still_safe = 0.05 + 2 * 0.0975

exercise = Question(
    task="a reading of the front laser in metres",
    right=still_safe,
    because="0.05 + 2 · 0.0975 = 0.245 m. The first cut, 0.27 m, lies just above it.",
    mistakes={
        "single_speed": Mistake(
            "that is at single speed. Both wheels backward means forward at double speed: twice as far.", 0.1475
        ),
        "no_margin": Mistake(
            "this is the way of one step at double speed. Behind it there must still be 0.05 m left.", 0.195
        ),
        "single_speed_no_margin": Mistake(
            "this is the way of one step at single speed. It is driven at double speed, and 0.05 m must be left.",
            0.0975,
        ),
        "margin_taken_off": Mistake("0.05 m must be left after the step. Add it, do not take it off.", 0.145),
        "single_speed_margin_taken_off": Mistake(
            "0.05 m must be left after the step. Add it; and it is driven at double speed.", 0.0475
        ),
        "two_margins": Mistake("0.05 m must be left only once, at the end of the step.", 0.295),
        "margin_alone": Mistake(
            "that is a reading which costs a reward already. From where may the robot still drive one step?", 0.05
        ),
        "first_cut": Mistake("this is the first cut of the task. Where does it come from? Work it out.", 0.27),
        "centimetres": Mistake("in metres, please: 24.5 cm are 0.245 m.", 24.5),
        "speed_of_the_wheels": Mistake(
            "2 rad/s is the speed of the wheels. How far does their rim get in one second? The radius is 0.0975 m.",
            2.05,
        ),
    },
    hints=(
        "How far does one step at double speed go? And how much must be left after it?",
        "A wheel of 0.0975 m radius at 2 rad/s rolls 2 · 0.0975 m in a second.",
        "0.05 + 2 · …",
    ),
    gained="A cut is a decision: it should separate what calls for different actions.",
    witnesses={
        "single_speed": [0.05 + 0.0975],
        "no_margin": [2 * 0.0975],
        "margin_taken_off": [2 * 0.0975 - 0.05],
        "first_cut": [0.27],
        "centimetres": [24.5],
    },
)
