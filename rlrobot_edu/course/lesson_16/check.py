"""Exercises of lesson 16: an imagined step by hand, Dyna's loop, two rulers, and what is biased about the bias."""

from __future__ import annotations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_16 import solutions
from rlrobot_edu.course.lesson_16.dyna_check import dyna
from rlrobot_edu.course.lesson_16.overlaps_check import overlaps

__all__ = ["by_hand", "dyna", "overlaps"]

by_hand = Question(
    task="Q(A, right) after the three imagined steps",
    right=solutions.by_hand,
    because="The first changes nothing, for B was worth 0. The second: 0.5 · 0.9 · 0.5 = 0.225. The third: "
    "0.5 · 0.9 · 0.225.",
    mistakes=[
        Mistake("so it is after the first imagined step, when B is still worth nothing. But (A, right) comes once more, "
                "after (B, right).", 0),
        Mistake("this is Q(B, right), after the second. The third imagined step builds on it.", 0.225),
        Mistake("one α is missing: Q(C, right) is 0.5, and an imagined step closes only half of the gap, too.", 0.2025),
        Mistake("both α are missing: an imagined step closes only half of the gap, as a real one.", 0.405),
        Mistake("both γ are missing: what comes one step later counts 0.9 times.", 0.125),
        Mistake("one γ is missing: what comes one step later counts 0.9 times, in each of the two steps.", 0.1125),
        Mistake("this is 0.9 · 0.5, the target of (B, right). Q moves half of the way to it.", 0.45),
        Mistake("the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
                0.5 * (1 + 0.9 * 0.5 * (1 + 0.45))),
        Mistake("the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
                0.5 + 0.5 * (1 + 0.9 * 0.725 - 0.5)),
        Mistake("this is Q(C, right), what the real step has taught. How far does it get back in thought?", 0.5),
        Mistake("after its first time Q(A, right) is 0, not half of something: B was worth nothing then.",
                0.5 * 0.225 + 0.5 * 0.9 * 0.225),
        Mistake("nearly: 0.1 is rounded too far. Give a digit or two more, or the formula itself.", 0.1),
    ],
    hints=(
        "Do one after the other, as if they were real steps: target 0 + 0.9 · the best of s′, and half of the way.",
        "(A, right): B is worth 0, nothing changes. (B, right): half of the way to 0.9 · 0.5. And then A again.",
        "0.5 * 0.9 * Q(B, right), and Q(B, right) is 0.5 * 0.9 * 0.5 by now.",
    ),
    gained="Three thoughts, and one of them changed nothing: the order of thoughts matters. Keep that for section 2.",
)  # fmt: skip
