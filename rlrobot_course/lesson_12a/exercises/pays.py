"""What a shuttle pays a step."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

pays = ((-1 + 5) / 2, (-1 + 10) / 2)

exercise = Question(
    task="what the two loops pay a step on average, as (first, second)",
    right=pays,
    because="(−1 + 5) / 2 and (−1 + 10) / 2. Keep both in mind: you will meet them again.",
    mistakes={
        "sums": Mistake("these are the sums of both steps. An average a step is half of that.", (4, 9)),
        "retreat_pays": Mistake("retreat costs 1: it is −1 + 5, not 1 + 5.", (3, 5.5)),
        "retreat_is_free": Mistake("retreat is not free, it costs 1: each of the loops has one step of −1.", (2.5, 5)),
        "first_loop": Mistake("the second loop is right. In the first, one step pays −1 and the other 5.", (2.5, 4.5)),
        "second_loop": Mistake("the first loop is right. In the second, one step pays −1 and the other 10.", (2, 5)),
        "contact_as_approach": Mistake(
            "the first loop is right. In the second, the step back into contact pays 10, not 5.", (2, 2)
        ),
        "swapped": Mistake("this is the second loop first.", (4.5, 2)),
        "with_gamma": Mistake(
            "these are the values with γ. Asked is the plain average of two rewards.", (21.57894737, 47.89473684)
        ),
        "good_step_alone": Mistake("this is what the good step pays. The other one counts, too.", (5, 10)),
    },
    hints=(
        "Each loop has two steps, and goes on for ever: the average of two rewards is all you need.",
        "Away: −1, in both loops. Back: 5 where the gripper stays outside 5 cm, 10 where it gets within.",
        "(−1 + 5) / 2, and for the second loop 10 in place of 5.",
    ),
    gained="An agent's average reward can tell you where it is stuck, without a look at the robot.",
    witnesses={
        "sums": [(4, 9)],
        "retreat_pays": [(3, 5.5)],
        "retreat_is_free": [(2.5, 5)],
        "contact_as_approach": [(2, 2)],
        "swapped": [(4.5, 2)],
    },
)
