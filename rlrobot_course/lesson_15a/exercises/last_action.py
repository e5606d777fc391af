"""What SARSA learns from the last row of a recording."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

last_action = "C"

exercise = Question(
    task='a letter, such as "A"',
    right=last_action,
    because="The robot was still on its way, so something follows; what the driver would have pressed, nobody knows. "
    "The agent's own choice is the only one that can be had.",
    mistakes={
        "nothing_follows": Mistake(
            "the episode has not ended: the driver stopped, the robot did not. To count nothing after it says that "
            "all is over there, and makes a good place look bad.",
            "A",
        ),
        "first_row": Mistake(
            "the first row of a recording is no answer to its last state: it was pressed somewhere else.", "B"
        ),
        "repeats_the_last": Mistake(
            "not every driver repeats the last button. Nobody knows what this one would have pressed.", "D"
        ),
    },
    hints=(
        "Was the step terminated? Then what does follow?",
        "Only one of the four does not make up what the driver did, nor an end.",
        "Who else can choose an action in s'?",
    ),
    gained="It is one row of 300. With many short lessons it would be many.",
    witnesses={"nothing_follows": ["A"], "first_row": ["b"], "repeats_the_last": ["D"], "form": [3]},
)
