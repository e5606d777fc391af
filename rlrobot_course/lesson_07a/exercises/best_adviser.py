"""Which input's set gives the best advice."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

best_adviser = "floor"

exercise = Question(
    task="the name of the input whose set gives the best advice",
    right=best_adviser,
    because="What is good does not depend on the colour of the floor, so four states give each other their experience. "
    "An input that does not matter makes learning slower; QBIASSR undoes a part of that.",
    mistakes={
        "line": Mistake(
            "with the line on the other side, the other turn is best: two of the three members disagree with the "
            "third.",
            "line",
        ),
        "ahead": Mistake(
            "to go straight on is good where the way is free, and a crash where it is not: these two states "
            "should not listen to each other.",
            "ahead",
        ),
        "trailer": Mistake(
            "with the trailer left and right change places: the other state's advice is wrong exactly where it is "
            "most sure.",
            "trailer",
        ),
        "all": Mistake(
            "their advice is not equally good. Take two states that differ in one input alone: is the same action "
            "best in both?",
            "all",
        ),
        "none_of_them": Mistake(
            "one of these inputs hardly matters for what is to be done. Then what was learned with one of its "
            "values holds for the others, too.",
            "none",
        ),
        "d": Mistake("d is an input of the robot of lesson 07. Here there are four others: see the table.", "d"),
        "colour": Mistake("you mean the right one. Write its name as in the table, in the first column.", "colour"),
        "color": Mistake("you mean the right one. Write its name as in the table, in the first column.", "color"),
    },
    hints=(
        "Take two states that differ in one input alone. Is the same action best in both?",
        "Three of the inputs change what is best: where the line is, what stands in the way, how a trailer swings.",
        "Which one does not matter for steering at all?",
    ),
    gained="To see this before the robot learns is half of designing a task.",
    witnesses={
        "line": ["line"],
        "ahead": ["Ahead"],
        "trailer": ["trailer"],
        "all": ["all"],
        "none_of_them": ["none"],
        "form": [4, ["floor"], "all of them", "trialer"],
        "colour": ["colour"],
        "d": ["d"],
    },
)
