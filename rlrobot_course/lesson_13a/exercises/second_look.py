"""What a second sample makes of a state's value."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

second_look = (0.5 * 10 + 0.5 * (-0.02 + 0.9 * 40)) / (1 - 0.5 * 0.9)

exercise = Question(
    task="Q(s, a) of a pair that was seen twice, once as a loop and once on its way to a state of value 40",
    right=second_look,
    because="x = 0.5 (10 + 0.9 x) + 0.5 (−0.02 + 36), so x = 22.99 / 0.55. From 100 to 42, by one more sample.",
    mistakes={
        "first_alone": Mistake(
            "this is with the first sample alone. Now each of the two has the probability 0.5.", 100
        ),
        "second_alone": Mistake(
            "this is with the second sample alone. Each of the two has the probability 0.5.", 35.98
        ),
        "mean_of_both": Mistake(
            "this is the mean of 100 and 35.98. But the loop is worth 100 only if it never ends: behind the first "
            "outcome stands the value x that you are looking for, not 100.",
            67.99,
        ),
        "no_loop": Mistake("the loop leads back to s: in that half the value 0.9 x comes on top.", 22.99),
        "no_loop_and_forty_in_full": Mistake(
            "the loop leads back to s: in that half the value 0.9 x comes on top. And the 40 is discounted.", 24.99
        ),
        "forty_in_full": Mistake("the 40 is one step away: it counts 0.9 times.", 24.99 / 0.55),
        "always_loops": Mistake("0.9 x stands there only in half of the cases: x = 22.99 + 0.45 x.", 229.9),
        "no_halves": Mistake("the two halves are missing: each outcome counts 0.5 times.", 459.8),
        "rewards_in_full": Mistake("the outcomes count 0.5 times each, and so does what they pay.", 45.98 / 0.55),
        "x_in_full": Mistake("the way back to s is discounted, too: it is 0.5 · 0.9 x.", 45.98),
        "mean_for_ever": Mistake(
            "this is the mean reward for ever. But the second outcome leads away, to the value 40.", 49.9
        ),
        "unknown_mix": Mistake("what does the loop's half pay now, and what comes after it?", 17.99 / 0.55),
    },
    hints=(
        "Call the value x. It is the mean of two outcomes, and in one of them x itself comes next.",
        "x = 0.5 · (10 + 0.9 x) + 0.5 · (−0.02 + 0.9 · 40)",
        "x (1 − 0.45) = 5 + 17.99",
    ),
    gained="So a trap is not a matter of the method: it stands and falls with a single row.",
    witnesses={
        "first_alone": [100],
        "mean_of_both": [67.99],
        "no_loop": [22.99],
        "forty_in_full": [45.44],
        "always_loops": [229.9],
        "x_in_full": [45.98],
    },
)
