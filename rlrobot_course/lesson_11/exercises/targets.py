"""The targets of a terminated and of a truncated step."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

targets = (10.0, 10 + 0.9 * 50)

exercise = Question(
    task="two numbers as a tuple: the target of the step that terminates, and of the one that is cut off",
    right=targets,
    because="After the goal there is nothing more to come: 10. The clock ends the film, not the world: 10 + 0.9 · 50.",
    mistakes={
        "swapped": Mistake("the other way round: it is the goal that ends all rewards, not the clock.", (55.0, 10.0)),
        "both_end": Mistake("only one of the two episodes is really over. Which?", (10.0, 10.0)),
        "none_ends": Mistake("at the goal the world ends: what Q promises past it does not count.", (55.0, 55.0)),
        "cut_without_reward": Mistake(
            "after the cut there is more to come: 0.9 · 50 on top of the reward.", (10.0, 45.0)
        ),
        "no_gamma": Mistake("what comes a step later counts 0.9 times.", (10.0, 60.0)),
        "discounts_the_reward": Mistake(
            "the reward of the step counts in full; it is the value after it that is discounted.", (10.0, 54.0)
        ),
        "no_reward_at_the_goal": Mistake("a target has the reward of the step in it, also at the end.", (0.0, 55.0)),
        "value_alone": Mistake(
            "the second one is the value alone. The reward of the step belongs to it.", (10.0, 50.0)
        ),
    },
    hints=(
        "The target is r + γ · (the value after the step). Is there anything after the step?",
        "At the goal there is nothing: r alone. At the cut the robot could go on from s′, which is worth 50.",
        "(10, 10 + 0.9 · …)",
    ),
    gained="This is why an environment returns two words, terminated and truncated, and not one.",
    witnesses={
        "swapped": [(55, 10)],
        "both_end": [(10, 10)],
        "no_gamma": [[10, 60]],
        "none_ends": [(55, 55)],
        "no_reward_at_the_goal": [(0, 55)],
    },
)
