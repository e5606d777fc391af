"""Which of four robots has learned by which target."""

from __future__ import annotations

from itertools import product

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

who = [3, 2, 1, 0]

LEARNED = ("it cannot be told", "Q-learning", "SARSA", "expected SARSA")

CLUES = (
    "A went to 2.35: a half of the way to a target of 2.7. So what did s' count as: the best, that of a', or the mean "
    "of the policy?",
    "B stayed at 2.0, so its target was 2. What did s' count as?",
    "C went to 2.5: its target was 3. What did s' count as?",
    "D's step has terminated. Which of the three looks at s' then?",
)

EXAMPLE = [1, 1, 1, 1]

exercise = Question(
    task="for each of the robots A, B, C and D a number from 0 to 3, such as [1, 1, 1, 1]",
    right=who,
    because="3.4, the mean of the policy, makes the target 2.7; Q(s', a') = 2 makes it 2; the best, 4, makes it 3; and "
    "D's target is r alone, whoever it is.",
    mistakes={
        "as_shown": Mistake(
            "that was only to show how it is written. Which target has each of the four gone half of the way to?",
            EXAMPLE,
        ),
        **{
            "_".join(map(str, tried)): Mistake(CLUES[next(i for i in range(4) if tried[i] != who[i])], list(tried))
            for tried in product(range(len(LEARNED)), repeat=4)
            if list(tried) not in (EXAMPLE, who)
        },
    },
    hints=(
        "Turn the update round: with α = 0.5 the target is as far beyond the new value as that is beyond the old one.",
        "The target is 1 + 0.5 · (what s' counts as): 4 for Q-learning, 2 for SARSA, and the mean of the policy, "
        "0.7 · 4 + 0.3 · (4 + 0 + 2) / 3, for expected SARSA.",
        "The targets were 2.7, 2, 3 and 1, and expected SARSA is number 3.",
    ),
    gained="From a number before and after one can often tell what a program does, whatever its comments say.",
    witnesses={
        "as_shown": [[1, 1, 1, 1]],
        "1_2_1_0": [[1, 2, 1, 0]],
        "3_1_1_0": [[3, 1, 1, 0]],
        "3_2_3_0": [[3, 2, 3, 0]],
        "3_2_1_1": [[3, 2, 1, 1]],
    },
)
