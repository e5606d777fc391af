"""What a value becomes by three imagined steps."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

by_hand = 0.5 * 0.9 * (0.5 * 0.9 * 0.5)

exercise = Question(
    task="Q(A, right) after the three imagined steps",
    right=by_hand,
    because="The first changes nothing, for B was worth 0. The second: 0.5 · 0.9 · 0.5 = 0.225. The third: "
    "0.5 · 0.9 · 0.225.",
    mistakes={
        "after_the_first": Mistake(
            "so it is after the first imagined step, when B is still worth nothing. But (A, right) comes once "
            "more, after (B, right).",
            0,
        ),
        "after_the_second": Mistake(
            "this is Q(B, right), after the second. The third imagined step builds on it.", 0.225
        ),
        "one_alpha_missing": Mistake(
            "one α is missing: Q(C, right) is 0.5, and an imagined step closes only half of the gap, too.", 0.2025
        ),
        "no_alpha": Mistake("both α are missing: an imagined step closes only half of the gap, as a real one.", 0.405),
        "no_gamma": Mistake("both γ are missing: what comes one step later counts 0.9 times.", 0.125),
        "one_gamma_missing": Mistake(
            "one γ is missing: what comes one step later counts 0.9 times, in each of the two steps.", 0.1125
        ),
        "target_of_b": Mistake("this is 0.9 · 0.5, the target of (B, right). Q moves half of the way to it.", 0.45),
        "reward_at_b": Mistake(
            "the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
            0.5 * (1 + 0.9 * 0.5 * (1 + 0.45)),
        ),
        "reward_everywhere": Mistake(
            "the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
            0.5 + 0.5 * (1 + 0.9 * 0.725 - 0.5),
        ),
        "real_step_alone": Mistake(
            "this is Q(C, right), what the real step has taught. How far does it get back in thought?", 0.5
        ),
        "half_of_something": Mistake(
            "after its first time Q(A, right) is 0, not half of something: B was worth nothing then.",
            0.5 * 0.225 + 0.5 * 0.9 * 0.225,
        ),
        "rounded": Mistake("nearly: 0.1 is rounded too far. Give a digit or two more, or the formula itself.", 0.1),
    },
    hints=(
        "Do one after the other, as if they were real steps: target 0 + 0.9 · the best of s′, and half of the way.",
        "(A, right): B is worth 0, nothing changes. (B, right): half of the way to 0.9 · 0.5. And then A again.",
        "0.5 * 0.9 * Q(B, right), and Q(B, right) is 0.5 * 0.9 * 0.5 by now.",
    ),
    gained="Three thoughts, and one of them changed nothing: the order of thoughts matters. Keep that for section 2.",
    witnesses={
        "after_the_first": [0],
        "after_the_second": [0.225],
        "one_alpha_missing": [0.2025],
        "no_alpha": [0.405],
        "no_gamma": [0.125],
        "real_step_alone": [0.5],
    },
)
