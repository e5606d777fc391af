"""How many samples make a probability so sure."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

enough = 4 * 0.5 * (1 - 0.5) / 0.1**2

exercise = Question(
    task="the number of samples that bring two standard errors down to 0.1, for p = 0.5",
    right=enough,
    because="2 · √(0.25 / 100) = 0.1. For half of that, ±0.05, it takes four times as many.",
    mistakes={
        "root_of_n": Mistake("this is √n. What is n?", 10),
        "one_error": Mistake("this is with one standard error. Two of them shall be 0.1.", 25),
        "exact_96_04": Mistake("this is with 1.96 standard errors. Take two.", 96.04),
        "exact_97": Mistake("this is with 1.96 standard errors. Take two.", 97),
        "half_the_width": Mistake("this would be ±0.05. The 0.1 is the distance to either side.", 400),
        "two_not_squared": Mistake("the 2 stands before the root: in n it counts squared, as 4.", 50),
        "no_root": Mistake("the root is missing: 0.1 counts squared, too.", 5),
        "probability_of_a_half": Mistake("p (1 − p) is 0.5 · 0.5.", 200),
        "error_squared": Mistake("this is the standard error squared. How many samples make it so small?", 0.0025),
    },
    hints=(
        "Put p = 0.5 into 2 √(p (1 − p) / n), set it to 0.1, and solve for n.",
        "2 · √(0.25 / n) = 2 · 0.5 / √n = 1 / √n.",
        "1 / √n = 0.1, so √n = 10.",
    ),
    gained="Of the pairs that a robot has tried in five hours, few have so many samples. You will see how few.",
    witnesses={
        "root_of_n": [10],
        "one_error": [25],
        "exact_97": [97],
        "half_the_width": [400],
        "two_not_squared": [50],
    },
)
