"""How many agents show a difference."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

agents_needed = 2 * (3 / (0.5 / 3)) ** 2

exercise = Question(
    task="how many agents of each method it takes",
    right=agents_needed,
    because="3 · √(2/n) = 0.5 / 3, so √(2/n) = 1/18 and n = 2 · 18² = 648.",
    mistakes={
        "one_mean": Mistake("the uncertainty of a difference has √(2/n): two means are uncertain, not one.", 324),
        "one_more": Mistake("648 are enough, to the last agent: 2 · 18².", 649),
        "as_large_as_the_difference": Mistake(
            "that makes the uncertainty as large as the difference itself. It should be a third of it.", 72
        ),
        "one_mean_as_large": Mistake("that is for one mean, and an uncertainty as large as the difference.", 36),
        "not_squared": Mistake("solve 3 · √(2/n) = 0.5 / 3 for n: both sides must be squared.", 18),
        "two_squared": Mistake(
            "2 · 18² = 648: is the 2 squared, too? Or is this the number of both methods together?", 1296
        ),
        "times_3": Mistake("a third of the difference: divide 0.5 by 3, do not multiply.", 8),
        "root_upside_down": Mistake("that is √(2/n) upside down. Square it, and mind the 2.", 12.727922),
        "root_left": Mistake("the root must be squared away: n = 2 · 18².", 36 * 2**0.5),
        "two_over_n": Mistake("this is 2/n. Solve for n.", 1 / 324),
    },
    hints=(
        "The uncertainty of the difference should be a third of the difference: write that as an equation.",
        "3 · √(2/n) = 0.5 / 3. Divide by 3, then square both sides.",
        "2/n = (1/18)², so n = 2 · …",
    ),
    gained="Now you can tell how long an experiment must be before you begin it.",
    witnesses={
        "one_mean": [324],
        "as_large_as_the_difference": [72],
        "not_squared": [18],
        "two_squared": [1296],
        "one_mean_as_large": [36],
    },
)
