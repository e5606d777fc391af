"""What going to and fro for ever is worth."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

to_and_fro = (5 - 0.9 * 1) / (1 - 0.9**2)

exercise = Question(
    task="the return of +5, −1, +5, −1 … for ever, with γ = 0.9",
    right=to_and_fro,
    because="One round is worth 5 − 0.9 · 1 = 4.1, and each round counts 0.81 times the one before: 4.1 / 0.19 = 21.6.",
    mistakes={
        "no_square": Mistake(
            "a round has two steps, so the next round counts 0.9² = 0.81 times: divide by 1 − 0.81.", 41.0
        ),
        "plain_round": Mistake("within a round the −1 comes one step later: it counts 0.9 times.", 4 / 0.19),
        "one_round": Mistake("this is one round only, and it goes on for ever.", 4.1),
        "one_plain_round": Mistake("this is one round without discount. It goes on for ever, with γ = 0.9.", 4),
        "mean_of_a_step": Mistake("this is the mean reward of a step. What is asked is the return.", 2),
        "mean_for_ever": Mistake("that is 2 a step, for ever: nearly. But the 5 comes first, and counts more.", 20),
        "five_for_ever": Mistake("that would be 5 in every step.", 50),
        "cost_first": Mistake("the 5 comes first. Yours begins with the −1.", (-1 + 0.9 * 5) / 0.19),
        "cost_added": Mistake("the −1 is a cost: take it off.", 5.9 / 0.19),
        "ten_for_ever": Mistake("this is 10 for ever, the most that can be earned. To and fro pays less.", 100),
        "multiplies": Mistake(
            "a round is worth 4.1 and the next one 0.81 times that: divide by 1 − 0.81, do not multiply.", 4.1 * 0.19
        ),
    },
    hints=(
        "Take two steps together as a round. What is a round worth, and how much less does the next one count?",
        "A round is worth 5 + 0.9 · (−1) = 4.1. Each next one counts 0.9 · 0.9 times as much.",
        "4.1 / (1 − 0.9 ** 2)",
    ),
    gained="A loop of rewards is worth its round over 1 − γ to the length of the round. Set that against the goal.",
    witnesses={
        "no_square": [4.1 / 0.1],
        "plain_round": [4 / 0.19],
        "one_round": [5 - 0.9],
        "mean_of_a_step": [2],
        "mean_for_ever": [20],
        "cost_first": [3.5 / 0.19],
    },
)
