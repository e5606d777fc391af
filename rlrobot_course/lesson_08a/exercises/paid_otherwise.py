"""What a value would be if one step had paid another reward, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

paid_otherwise = 9.98 - 12 * 0.299

exercise = Question(
    task="Q(441, 1), had step 878 paid −2",
    right=paid_otherwise,
    because="Its weight is 2.99 / 10 = 0.299, and the reward would be 12 less: 9.98 − 12 · 0.299 = 6.39. One "
    "bump is not enough.",
    mistakes={
        "nothing_paid": Mistake(
            "this is Q without the share: so it would be had the step paid 0. It is to pay −2.", 6.99
        ),
        "takes_the_reward": Mistake("the step's reward enters with its weight, not as a whole.", -2.02),
        "takes_two": Mistake("the reward enters with its weight; and it falls by 12, from 10 to −2.", 7.98),
        "falls_by_eight": Mistake("from 10 to −2 the reward falls by 12, not by 8.", 9.98 - 8 * 0.299),
        "share_and_two": Mistake("the −2 enters with the step's weight, too.", 4.99),
        "change_alone": Mistake("this is by how much it would be less. Take it off 9.98.", 12 * 0.299),
        "change_alone_downwards": Mistake("this is by how much it changes. Add it to 9.98.", -12 * 0.299),
        "new_share_alone": Mistake("this is what the step would have paid. The rest of Q stays: 9.98 − 2.99.", -0.598),
        "old_share_stays": Mistake(
            "the new share is in it, and the old one still, too. Take the 2.99 off first.", 9.98 - 0.598
        ),
        "twelve_shares": Mistake("the share is what 10 have paid. A reward of 1 pays a tenth of it.", 9.98 - 12 * 2.99),
        "upwards": Mistake("a smaller reward makes the value smaller.", 9.98 + 12 * 0.299),
    },
    hints=(
        "A share is weight times reward. The weight stays when the reward is another one.",
        "The weight of step 878 is 2.99 / 10. By how much does the reward fall?",
        "9.98 − 12 · 0.299",
    ),
    gained="So one can ask of a robot's opinion what would have changed it.",
    witnesses={
        "nothing_paid": [9.98 - 2.99],
        "takes_the_reward": [9.98 - 12],
        "takes_two": [7.98],
        "share_and_two": [9.98 - 2.99 - 2],
        "change_alone": [3.588],
        "change_alone_downwards": [-3.588],
        "new_share_alone": [-2 * 0.299],
        "old_share_stays": [9.382],
        "twelve_shares": [9.98 - 12 * 2.99],
    },
)
