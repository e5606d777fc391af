"""The targets of Q-learning and of SARSA for a recorded step."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

two_targets = (10 + 0.9 * 40, 10 + 0.9 * 5)

exercise = Question(
    task="the target of Q-learning and the target of SARSA, as (…, …)",
    right=two_targets,
    because="Q-learning counts on the best of s', 10 + 0.9 · 40; SARSA on what the teacher did there, 10 + 0.9 · 5.",
    mistakes={
        "swapped": Mistake(
            "these are the right numbers in the wrong order: Q-learning's first.", (10 + 0.9 * 5, 10 + 0.9 * 40)
        ),
        "q_learning_twice": Mistake(
            "both look at the best action here. SARSA looks at the one that the teacher took next.", (46.0, 46.0)
        ),
        "sarsa_twice": Mistake(
            "both look at the teacher's next action here. Q-learning looks at the best one.", (14.5, 14.5)
        ),
        "no_gamma": Mistake("you forgot γ.", (50, 15)),
        "no_reward": Mistake("the reward of the step is missing.", (36, 4.5)),
        "discounts_the_reward": Mistake("a target is r + γ · …; the γ does not belong to r.", (45.0, 13.5)),
    },
    hints=(
        "Both targets are r + 0.9 · a value of s'. Which one does each take?",
        "Q-learning: the largest of the three. SARSA: that of a' = 2.",
        "(10 + 0.9 * 40, 10 + 0.9 * …)",
    ),
    gained="This one number is why the same bad teacher teaches them different things.",
    witnesses={
        "swapped": [(14.5, 46)],
        "q_learning_twice": [(46, 46)],
        "no_gamma": [(50, 15)],
        "no_reward": [(36, 4.5)],
    },
)
