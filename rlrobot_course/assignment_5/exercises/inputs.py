"""Which inputs the task of parking needs."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

inputs = "ADE"

exercise = Question(
    task='the letters of the inputs that a state needs, such as "BC"',
    right=inputs,
    because="The front laser tells whether it is parked, and the two beside it whether it is about to touch. Nothing "
    "else tells anything about the next reward that these three do not.",
    mistakes={
        "ahead_alone": Mistake(
            "who sees only what is ahead learns nothing about walls that are touched beside it.", "A"
        ),
        "not_ahead": Mistake("the wall ahead decides whether the robot is parked, so which input tells it?", "DE"),
        "not_right": Mistake("and on the other side? A wall may be touched left and right.", "AD"),
        "not_left": Mistake("and on the other side? A wall may be touched left and right.", "AE"),
        "position": Mistake(
            "where it is in this arena tells where walls are only here, and the lasers tell it anywhere. It makes "
            "four times as many states.",
            "ABDE",
        ),
        "heading": Mistake(
            "the reward asks nothing about the heading: a wall is a wall. It makes eight times as many states.", "ACDE"
        ),
        "behind": Mistake("this robot never drives backward, so what is behind it cannot be touched.", "ADEF"),
        "time": Mistake("the time since the start tells nothing about the next reward.", "ADEG"),
        "everything": Mistake(
            "all of them: that are thousands of states, most of which are never met twice. Which readings does the "
            "reward ask for?",
            "ABCDEFG",
        ),
        "as_shown": Mistake("that was only to show how it is written.", "BC"),
        "a_map": Mistake(
            "a map would do where nothing ever changes: but the heading alone has eight sectors of 45°, and a step "
            "is 0.1 m. The lasers tell it finer and with fewer states.",
            "ABC",
        ),
    },
    hints=(
        "Which readings does your reward look at after the step? The state must let the robot foresee them.",
        "Three of the seven are enough, and they are of one kind.",
        "The laser that looks ahead, and the two that look to the left and the right of it.",
    ),
    gained="4 · 2 · 2 = 16 states: an afternoon's exercise for a table.",
    witnesses={
        "ahead_alone": ["A"],
        "behind": ["ADEF"],
        "everything": ["ABCDEFG"],
        "time": ["E, D, A and G"],
        "not_ahead": ["DE"],
    },
)
